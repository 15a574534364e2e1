//! Mirrors, and the depth of rays (Suffern, ch. 24).

use serde_json::{Value, json};

use super::stage::{
    self, Exact, along, between, color, light, material, matte, object, phong, ray, share, whitted,
    within,
};
use exact::Draw;

pub const ALL: &[Exact] = &[
    ("mirror.ball", "ch24", ball),
    ("mirror.bare", "ch24", bare),
    ("mirror.hall", "ch24", hall),
    ("mirror.balls", "ch24", balls),
];

fn lights(draw: &mut Draw) -> Vec<Value> {
    let at = within(draw, [-3.0, 4.0, -1.0], [3.0, 7.0, 5.0]);
    let lamp =
        json!({"point": {"ls": between(draw, 2.0, 4.0), "color": color(draw), "location": at}});
    vec![light("lamp", lamp), light("sky", json!({"ambient": {"ls": share(draw)}}))]
}

fn with_sky(draw: &mut Draw, mut scene: Value) -> Value {
    scene["background"] = color(draw);
    scene
}

/// A coloured mirror over a shiny base, beside a box, over a ground, under a sky.
fn ball(draw: &mut Draw) -> Value {
    let mirror =
        json!({"reflective": {"phong": phong(draw), "kr": share(draw), "cr": color(draw)}});
    let materials = vec![
        material("mirror", mirror),
        material("chalk", matte(draw)),
        material("stone", matte(draw)),
    ];
    let objects = vec![
        object("ball", "mirror", stage::sphere(stage::BALL, 1.0)),
        object("box", "chalk", stage::block()),
        object("floor", "stone", stage::ground()),
    ];
    let scene = stage::scene(whitted(draw.below(3)), lights(draw), materials, objects);
    let aim = within(draw, [-1.4, 0.4, -0.2], [0.0, 1.6, 0.6]);
    let from = stage::before(draw);
    along(with_sky(draw, scene), ray(from, aim))
}

/// A mirror and nothing else: the sky in it.
fn bare(draw: &mut Draw) -> Value {
    let mirror = json!({"reflective": {"kr": share(draw), "cr": color(draw)}});
    let objects = vec![object("ball", "mirror", stage::sphere([0.0, 1.0, 0.0], 1.0))];
    let materials = vec![material("mirror", mirror)];
    let scene = stage::scene(whitted(draw.below(3)), Vec::new(), materials, objects);
    let aim = within(draw, [-0.5, 0.5, 0.0], [0.5, 1.5, 0.5]);
    let from = stage::before(draw);
    along(with_sky(draw, scene), ray(from, aim))
}

/// Two mirrors that face each other, and a ball between them: each reflection more is another colour.
fn hall(draw: &mut Draw) -> Value {
    let mirror =
        |draw: &mut Draw| json!({"reflective": {"kr": between(draw, 0.5, 0.9), "cr": color(draw)}});
    let materials = vec![
        material("gold", mirror(draw)),
        material("silver", mirror(draw)),
        material("chalk", matte(draw)),
    ];
    let left = json!({"corner": [-2.0, -3.0, 4.0], "a": [0.0, 0.0, -8.0], "b": [0.0, 6.0, 0.0]});
    let right = json!({"corner": [2.0, -3.0, -4.0], "a": [0.0, 0.0, 8.0], "b": [0.0, 6.0, 0.0]});
    let objects = vec![
        object("left", "gold", json!({"rectangle": left})),
        object("right", "silver", json!({"rectangle": right})),
        object("ball", "chalk", stage::sphere([0.25, 0.0, -1.0], 0.75)),
    ];
    let scene = stage::scene(whitted(draw.below(5)), lights(draw), materials, objects);
    let side = 2.0 * draw.sign();
    let aim = [side, between(draw, -0.75, 0.75), between(draw, -1.5, 1.5)];
    let from = within(draw, [-1.5, -0.5, 1.5], [1.5, 0.5, 3.0]);
    along(with_sky(draw, scene), ray(from, aim))
}

/// Three mirrors that see each other, over a ground.
fn balls(draw: &mut Draw) -> Value {
    let mirror = |draw: &mut Draw| json!({"reflective": {"phong": phong(draw), "kr": share(draw), "cr": color(draw)}});
    let materials = vec![
        material("a", mirror(draw)),
        material("b", mirror(draw)),
        material("c", mirror(draw)),
        material("stone", matte(draw)),
    ];
    let objects = vec![
        object("left", "a", stage::sphere([-1.0, 1.0, 0.0], 0.9)),
        object("right", "b", stage::sphere([1.0, 1.0, 0.0], 0.9)),
        object("back", "c", stage::sphere([0.0, 1.0, -1.75], 0.9)),
        object("floor", "stone", stage::ground()),
    ];
    let scene = stage::scene(whitted(1 + draw.below(4)), lights(draw), materials, objects);
    let side = draw.sign();
    let aim = [side * between(draw, 0.2, 1.0), between(draw, 0.6, 1.4), 0.6];
    let from = stage::before(draw);
    along(with_sky(draw, scene), ray(from, aim))
}
