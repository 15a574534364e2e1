//! Textures on objects and on instances (Suffern, ch. 24, 30).

use serde_json::{Value, json};

use super::stage::{
    self, Exact, along, between, color, direct, light, material, matte, object, ray, share, within,
};
use exact::Draw;

pub const ALL: &[Exact] = &[
    ("texture.solid", "ch30", |draw| {
        let cd = checker(draw);
        let recipe = painted(draw, cd);
        floor(draw, recipe)
    }),
    ("texture.plane", "ch24", |draw| {
        let cd = json!({"plane_checker": {
            "size": between(draw, 0.5, 1.5), "color1": color(draw), "color2": color(draw),
            "outline_width": 0.125, "outline_color": color(draw),
        }});
        let recipe = painted(draw, cd);
        floor(draw, recipe)
    }),
    ("texture.amount", "ch30", |draw| {
        let (amount, base) = (checker(draw), color(draw));
        let field = draw.pick(&["ka", "kd"]);
        let mut recipe = json!({"matte": {"ka": share(draw), "kd": share(draw), "cd": base}});
        recipe["matte"][field] = amount;
        ball(draw, recipe, true)
    }),
    ("texture.on_instance", "ch30", |draw| {
        let cd = checker(draw);
        let recipe = painted(draw, cd);
        ball(draw, recipe, true)
    }),
    ("texture.left_in_place", "ch21", |draw| {
        let cd = checker(draw);
        let recipe = painted(draw, cd);
        ball(draw, recipe, false)
    }),
    ("texture.instance", "ch30", |draw| {
        let of = checker(draw);
        let scale = within(draw, [0.5; 3], [2.0; 3]);
        let transform = json!([{"scale": scale}, {"rotate_z": between(draw, 10.0, 80.0)}, {"translate": [0.25, -0.5, 0.125]}]);
        let cd = json!({"texture_instance": {"of": of, "transform": transform}});
        let recipe = painted(draw, cd);
        floor(draw, recipe)
    }),
    ("texture.ramp", "ch30", |draw| {
        let cd = json!({"ramp": {
            "axis": draw.pick(&["x", "z"]), "from": -1.0, "to": 1.5, "colors": [color(draw), color(draw), color(draw)],
            "wrap": draw.pick(&["repeat", "clamp", "mirror"]),
        }});
        let recipe = painted(draw, cd);
        floor(draw, recipe)
    }),
];

/// A matte recipe of this colour.
fn painted(draw: &mut Draw, cd: Value) -> Value {
    json!({"matte": {"ka": share(draw), "kd": share(draw), "cd": cd}})
}

fn checker(draw: &mut Draw) -> Value {
    let size = between(draw, 0.3, 0.9);
    json!({"checker3d": {"size": size, "color1": color(draw), "color2": color(draw)}})
}

fn lights(draw: &mut Draw) -> Vec<Value> {
    let at = within(draw, [-4.0, 4.0, 1.0], [4.0, 7.0, 6.0]);
    let lamp = json!({"point": {"ls": between(draw, 2.0, 4.0), "location": at}});
    vec![light("lamp", lamp), light("sky", json!({"ambient": {"ls": share(draw)}}))]
}

/// A stretched and turned ball over a ground; its texture moves with it, or is looked up where it is hit.
fn ball(draw: &mut Draw, recipe: Value, moves: bool) -> Value {
    let scale = within(draw, [0.5; 3], [1.4; 3]);
    let turn = between(draw, 20.0, 160.0);
    let transform =
        json!([{"scale": scale}, {"rotate_z": turn}, {"translate": [0.125, 1.25, -0.25]}]);
    let mut instance = json!({"of": stage::sphere([0.0; 3], 1.0), "transform": transform});
    if !moves {
        instance["transform_texture"] = json!(false);
    }
    let materials = vec![material("painted", recipe), material("stone", matte(draw))];
    let objects = vec![
        object("ball", "painted", json!({"instance": instance})),
        object("floor", "stone", stage::ground()),
    ];
    let scene = stage::scene(direct(), lights(draw), materials, objects);
    let aim = within(draw, [-0.5, 0.8, -0.5], [0.5, 1.7, 0.5]);
    along(scene, ray(stage::before(draw), aim))
}

/// A painted ground, on which a ball stands that casts a shadow.
fn floor(draw: &mut Draw, recipe: Value) -> Value {
    let materials = vec![material("painted", recipe), material("chalk", matte(draw))];
    let objects = vec![
        object("floor", "painted", stage::ground()),
        object("ball", "chalk", stage::sphere([0.0, 1.0, 0.0], 1.0)),
    ];
    let scene = stage::scene(direct(), lights(draw), materials, objects);
    let aim = within(draw, [-4.0, 0.0, 0.5], [4.0, 0.0, 2.5]);
    along(scene, ray(stage::before(draw), aim))
}
