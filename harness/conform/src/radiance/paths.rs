//! Light that is reflected between surfaces: the path tracers (Suffern, ch. 26), each to several depths.

use serde_json::{Value, json};

use super::stage::{
    self, Exact, between, color, light, material, matte, mean_along, object, ray, share, within,
};
use exact::Draw;

pub const ALL: &[Exact] = &[
    ("path_trace.furnace", "ch26", |draw| furnace(draw, "path_trace")),
    ("path_trace.sky", "ch26", |draw| corner_under_sky(draw, "path_trace")),
    ("path_trace.room", "ch26", |draw| room(draw, "path_trace")),
    ("path_trace.mirror", "ch26", |draw| room_with_mirror(draw, "path_trace")),
    ("path_trace.gloss", "ch26", |draw| gloss(draw, "path_trace")),
    ("path_trace.glass", "ch28", |draw| glass(draw, "path_trace")),
    ("global_trace.room", "ch26", |draw| room(draw, "global_trace")),
    ("global_trace.mirror", "ch26", |draw| room_with_mirror(draw, "global_trace")),
    ("path.furnace", "ch26", |draw| furnace(draw, "path")),
    ("path.roulette", "ch26", |draw| {
        // from the fifth bounce on, paths may end by chance
        let mut question = furnace(draw, "path");
        let scene = &mut question["radiance"]["scene"];
        scene["tracer"]["path"]["max_depth"] = json!(8 + draw.below(8));
        scene["materials"][0]["recipe"]["emissive"]["matte"]["kd"] = json!(1.0);
        question
    }),
    ("path.sky", "ch26", |draw| corner_under_sky(draw, "path")),
    ("path.room", "ch26", |draw| room(draw, "path")),
    ("path.mirror", "ch26", |draw| room_with_mirror(draw, "path")),
];

fn tracer(draw: &mut Draw, name: &str) -> Value {
    json!({name: {"max_depth": 1 + draw.below(4)}})
}

/// A hollow ball whose wall shines and reflects: `E (1 + ρ + ρ² + …)`, a term for each depth.
fn furnace(draw: &mut Draw, name: &str) -> Value {
    let recipe = json!({"emissive": {
        "ls": between(draw, 0.5, 2.0), "ce": color(draw), "matte": {"kd": share(draw), "cd": color(draw)},
    }});
    let mut wall = material("wall", recipe);
    wall["two_sided"] = json!(true);
    let objects = vec![object("oven", "wall", stage::sphere([0.0; 3], 2.0))];
    let scene = stage::scene(tracer(draw, name), Vec::new(), vec![wall], objects);
    let from = within(draw, [-1.0; 3], [1.0; 3]);
    let to = draw.direction().to_array();
    mean_along(draw, scene, ray(from, std::array::from_fn(|i| from[i] + to[i])))
}

/// A ground between two walls.
fn corner(draw: &mut Draw) -> (Vec<Value>, Vec<Value>) {
    let materials = vec![
        material("stone", matte(draw)),
        material("chalk", matte(draw)),
        material("brick", matte(draw)),
    ];
    let side = json!({"rectangle": {"corner": [-1.5, 0.0, 3.0], "a": [0.0, 0.0, -5.0], "b": [0.0, 4.0, 0.0]}});
    let objects = vec![
        object("floor", "stone", stage::ground()),
        object("back", "chalk", stage::wall(-1.5)),
        object("side", "brick", side),
    ];
    (materials, objects)
}

fn into_corner(draw: &mut Draw) -> Value {
    let aim = within(draw, [-1.4, 0.0, -1.4], [1.0, 0.0, 0.5]);
    ray([aim[0] + 0.5, 1.0, aim[2] + 1.5], aim)
}

fn corner_under_sky(draw: &mut Draw, name: &str) -> Value {
    let (materials, objects) = corner(draw);
    let mut scene = stage::scene(tracer(draw, name), sky_of(name), materials, objects);
    scene["background"] = color(draw);
    let ray = into_corner(draw);
    mean_along(draw, scene, ray)
}

/// The tracer of MIS samples the sky, too.
fn sky_of(name: &str) -> Vec<Value> {
    match name {
        "path" => vec![light("sky", json!({"environment": {}}))],
        _ => Vec::new(),
    }
}

/// A corner under a large lamp, which is an area light, too.
fn room(draw: &mut Draw, name: &str) -> Value {
    let (mut materials, mut objects) = corner(draw);
    let glow = json!({"emissive": {"ls": between(draw, 1.0, 4.0), "ce": color(draw)}});
    materials.push(material("glow", glow));
    let lamp = json!({"rectangle": {"corner": [-1.25, 2.5, -1.25], "a": [2.5, 0.0, 0.0], "b": [0.0, 0.0, 2.5]}});
    objects.push(object("lamp", "glow", lamp));
    let lights = vec![light("light", json!({"area": {"object": "lamp"}}))];
    let scene = stage::scene(tracer(draw, name), lights, materials, objects);
    let ray = into_corner(draw);
    mean_along(draw, scene, ray)
}

/// The same with a mirror in the place of a wall, into which the ray mostly goes.
fn room_with_mirror(draw: &mut Draw, name: &str) -> Value {
    let mut question = room(draw, name);
    let mirror = json!({"reflective": {"kr": between(draw, 0.5, 0.9), "cr": color(draw)}});
    let data = &mut question["radiance"];
    data["scene"]["materials"][1] = material("chalk", mirror);
    if draw.below(3) > 0 {
        let aim = within(draw, [-1.0, 0.25, -1.5], [1.0, 2.0, -1.5]);
        data["ray"] = ray([0.5, 1.0, 1.5], aim);
    }
    question
}

/// A glossy ball over a ground, under a sky that is not sampled.
fn gloss(draw: &mut Draw, name: &str) -> Value {
    let glossy = json!({"glossy_reflector": {
        "phong": {"kd": 0.0, "cd": color(draw)}, "kr": share(draw), "cr": color(draw),
        "exponent": draw.pick(&[4.0, 20.0, 100.0]),
    }});
    let materials = vec![material("gloss", glossy), material("stone", matte(draw))];
    let objects = vec![
        object("ball", "gloss", stage::sphere([0.0, 1.0, 0.0], 1.0)),
        object("floor", "stone", stage::ground()),
    ];
    let mut scene = stage::scene(tracer(draw, name), Vec::new(), materials, objects);
    scene["background"] = color(draw);
    let aim = within(draw, [-0.5, 0.3, 0.2], [0.5, 1.2, 0.6]);
    let from = stage::before(draw);
    mean_along(draw, scene, ray(from, aim))
}

/// A glass ball over a ground, under a sky.
fn glass(draw: &mut Draw, name: &str) -> Value {
    let mut question = gloss(draw, name);
    let inside = json!({"eta": between(draw, 1.2, 1.8), "absorption": color(draw)});
    let recipe = json!({"dielectric": {"inside": inside}});
    question["radiance"]["scene"]["materials"][0]["recipe"] = recipe;
    question
}
