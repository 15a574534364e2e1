//! What a tracer of chapters 14 to 16 has, and no more: spheres over a plane, matte and Phong surfaces, ambient, point and
//! directional lights (Suffern, ch. 14 to 16).
//!
//! Before chapter 16, nothing is where it could cast a shadow: a tracer without shadows is right there.

use serde_json::{Value, json};

use super::stage::{
    self, Exact, along, between, color, direct, light, material, matte, object, ray, shadow, share,
    sphere, within,
};
use exact::Draw;

pub const ALL: &[Exact] = &[
    ("basics.ambient", "ch14", |draw| {
        let balls = balls(draw);
        let aim = near(draw, &balls);
        lit(draw, Vec::new(), [matte, matte], balls, aim)
    }),
    ("basics.point", "ch14", |draw| alone(draw, matte, &[point])),
    ("basics.directional", "ch14", |draw| alone(draw, matte, &[sun])),
    ("basics.several_lights", "ch14", |draw| alone(draw, matte, &[point, sun])),
    ("basics.highlight", "ch15", |draw| alone(draw, phong, &[point])),
    ("basics.several_highlights", "ch15", |draw| alone(draw, phong, &[sun, point])),
    ("basics.shadows_of_point", "ch16", |draw| shadows(draw, &[point])),
    ("basics.shadows_of_directional", "ch16", |draw| shadows(draw, &[sun])),
    ("basics.shadows_of_several", "ch16", |draw| shadows(draw, &[point, sun])),
    ("basics.lamp_between", "ch16", lamp_between),
];

/// A light, and a point from which it comes.
type Lamp = fn(&mut Draw) -> (Value, [f64; 3]);

fn point(draw: &mut Draw) -> (Value, [f64; 3]) {
    let at = within(draw, [-4.0, 2.0, 0.5], [4.0, 7.0, 6.0]);
    let source =
        json!({"point": {"ls": between(draw, 1.0, 4.0), "color": color(draw), "location": at}});
    (light("lamp", source), at)
}

fn sun(draw: &mut Draw) -> (Value, [f64; 3]) {
    let to = within(draw, [-4.0, 2.0, -1.0], [4.0, 6.0, 6.0]);
    let source = json!({"directional": {"ls": between(draw, 1.0, 4.0), "color": color(draw), "direction": to}});
    (light("sun", source), to.map(|x| 1e3 * x))
}

/// A Phong recipe whose highlights have no colour of their own.
fn phong(draw: &mut Draw) -> Value {
    let mut recipe = stage::phong(draw);
    recipe.as_object_mut().map(|fields| fields.remove("cs"));
    json!({"phong": recipe})
}

/// A ball: its centre and radius. None has the radius 1, which hides a division by it.
type Ball = ([f64; 3], f64);

/// Two balls that stand on the ground, one behind the other.
fn balls(draw: &mut Draw) -> [Ball; 2] {
    let mut ball = |x: f64, z: f64| {
        let radius = between(draw, 0.4, 0.9);
        ([x + between(draw, -0.3, 0.3), radius, z + between(draw, -0.3, 0.3)], radius)
    };
    [ball(-0.5, 0.5), ball(0.75, -1.0)]
}

/// A point on or beside one of the balls.
fn near(draw: &mut Draw, balls: &[Ball]) -> [f64; 3] {
    let (center, radius) = balls[draw.below(balls.len())];
    within(draw, center.map(|x| x - radius), center.map(|x| x + radius))
}

/// The balls, of the first material, over a ground of the second, in these lights and ambient light.
fn lit(
    draw: &mut Draw,
    mut lights: Vec<Value>,
    recipes: [fn(&mut Draw) -> Value; 2],
    balls: impl IntoIterator<Item = Ball>,
    aim: [f64; 3],
) -> Value {
    lights.push(light("sky", json!({"ambient": {"ls": share(draw), "color": color(draw)}})));
    let [ball, ground] = recipes.map(|recipe| recipe(draw));
    let materials = vec![material("chalk", ball), material("stone", ground)];
    let balls = (0..).zip(balls).map(|(i, (center, radius)): (u8, Ball)| {
        object(&format!("ball {i}"), "chalk", sphere(center, radius))
    });
    let floor = object("floor", "stone", stage::ground());
    let scene = stage::scene(direct(), lights, materials, balls.chain([floor]).collect());
    along(scene, ray(stage::before(draw), aim))
}

/// A ball and nothing else, or a plane and nothing else, under these lights.
fn alone(draw: &mut Draw, recipe: fn(&mut Draw) -> Value, lamps: &[Lamp]) -> Value {
    let lights = lamps.iter().map(|lamp| lamp(draw).0).collect();
    let ball = ([0.0, 1.0, 0.0], between(draw, 0.4, 0.9));
    let mut question = lit(draw, lights, [recipe; 2], [ball], [0.0; 3]);
    let (kept, aim) = match draw.below(4) {
        0 => (1, within(draw, [-2.0, 0.0, -2.0], [2.0, 0.0, 2.0])),
        _ => (0, near(draw, &[ball])),
    };
    let data = &mut question["radiance"];
    data["scene"]["objects"] = json!([data["scene"]["objects"][kept]]);
    data["ray"] = ray(stage::before(draw), aim);
    question
}

/// Balls over a ground, seen mostly where one of them may be in the way of a light.
fn shadows(draw: &mut Draw, lamps: &[Lamp]) -> Value {
    let (lights, from): (Vec<Value>, Vec<[f64; 3]>) = lamps.iter().map(|lamp| lamp(draw)).unzip();
    let balls = balls(draw);
    let on = near(draw, &balls);
    let aim = if draw.below(4) == 0 { on } else { shadow(on, from[draw.below(from.len())]) };
    lit(draw, lights, [matte, phong], balls, aim)
}

/// A lamp with a ball on either side of it, so that each is behind the lamp for the other one and for the ground.
fn lamp_between(draw: &mut Draw) -> Value {
    let at = within(draw, [-0.2, 1.0, -0.2], [0.2, 1.6, 0.2]);
    let source =
        json!({"point": {"ls": between(draw, 1.0, 4.0), "color": color(draw), "location": at}});
    let balls = [([-1.2, 1.0, 0.0], 0.8), ([1.2, 1.2, 0.0], 0.7), ([0.1, 3.0, -0.1], 0.9)];
    let on_ground = within(draw, [-1.5, 0.0, -1.0], [1.5, 0.0, 1.5]);
    let aim = if draw.coin() { on_ground } else { near(draw, &balls[..2]) };
    lit(draw, vec![light("lamp", source)], [phong, matte], balls, aim)
}
