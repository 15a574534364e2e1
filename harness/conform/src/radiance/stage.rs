//! Scenes of a few objects, written as JSON, and rays into them.

use serde_json::{Value, json};

use super::super::questions::round;
use exact::Draw;

/// A question without random numbers: its family's name after `radiance.`, its chapter, and a case.
pub type Exact = (&'static str, &'static str, fn(&mut Draw) -> Value);

/// The samples of one answer of a question with random numbers: a square, as some patterns need it.
pub const SAMPLES: u64 = 36;

/// A share of light, with few digits.
pub fn share(draw: &mut Draw) -> f64 {
    round(draw.between(0.2, 0.8))
}

/// A colour with three different channels, almost surely.
pub fn color(draw: &mut Draw) -> Value {
    json!([share(draw), share(draw), share(draw)])
}

/// A number with few digits.
pub fn between(draw: &mut Draw, low: f64, high: f64) -> f64 {
    round(draw.between(low, high))
}

/// A point in a box.
pub fn within(draw: &mut Draw, low: [f64; 3], high: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|i| between(draw, low[i], high[i]))
}

/// A matte recipe whose reflectances for ambient and for direct light differ.
pub fn matte(draw: &mut Draw) -> Value {
    json!({"matte": {"ka": share(draw), "kd": share(draw), "cd": color(draw)}})
}

/// The fields of `phong`, with a coloured highlight.
pub fn phong(draw: &mut Draw) -> Value {
    let exponent = draw.pick(&[2.5, 5.0, 20.0]);
    json!({
        "ka": share(draw), "kd": share(draw), "cd": color(draw),
        "ks": share(draw), "cs": color(draw), "exponent": exponent,
    })
}

/// A light of the scene.
pub fn light(name: &str, source: Value) -> Value {
    json!({"name": name, "source": source})
}

/// A material of the scene.
pub fn material(name: &str, recipe: Value) -> Value {
    json!({"name": name, "recipe": recipe})
}

/// An object of the scene.
pub fn object(name: &str, material: &str, shape: Value) -> Value {
    json!({"name": name, "material": material, "shape": shape})
}

/// A sphere.
pub fn sphere(center: [f64; 3], radius: f64) -> Value {
    json!({"sphere": {"center": center, "radius": radius}})
}

/// The plane y = 0.
pub fn ground() -> Value {
    json!({"plane": {"point": [0.0, 0.0, 0.0], "normal": [0.0, 1.0, 0.0]}})
}

/// An upright rectangle behind the origin, which faces the viewer.
pub fn wall(z: f64) -> Value {
    json!({"rectangle": {"corner": [-3.0, 0.0, z], "a": [6.0, 0.0, 0.0], "b": [0.0, 4.0, 0.0]}})
}

/// The tracer of what reflects nothing.
pub fn direct() -> Value {
    json!("ray_cast")
}

/// The tracer of mirrors and glass.
pub fn whitted(max_depth: usize) -> Value {
    json!({"whitted": {"max_depth": max_depth}})
}

/// A scene; it is not its camera that looks.
pub fn scene(
    tracer: Value,
    lights: Vec<Value>,
    materials: Vec<Value>,
    objects: Vec<Value>,
) -> Value {
    json!({
        "image": {"width": 1, "height": 1},
        "camera": {"eye": [0.0, 2.0, 6.0], "lens": {"pinhole": {"distance": 8.0}}},
        "tracer": tracer, "lights": lights, "materials": materials, "objects": objects,
    })
}

/// A ray from one point to another, whose direction has the length between them.
pub fn ray(origin: [f64; 3], aim: [f64; 3]) -> Value {
    let origin = origin.map(round);
    let direction: [f64; 3] = std::array::from_fn(|i| round(aim[i] - origin[i]));
    json!({"origin": origin, "direction": direction})
}

/// A point in front of the scene and above its ground, from which to look.
pub fn before(draw: &mut Draw) -> [f64; 3] {
    within(draw, [-4.0, 1.5, 4.0], [4.0, 5.0, 7.0])
}

/// What arrives along a ray, without random numbers.
pub fn along(scene: Value, ray: Value) -> Value {
    json!({"radiance": {"scene": scene, "ray": ray, "replicas": 1}})
}

/// What arrives along a ray in the mean: the mean of some samples, with random numbers of a seed.
pub fn mean_along(draw: &mut Draw, scene: Value, ray: Value) -> Value {
    let seed = draw.below(1 << 30);
    json!({"radiance": {
        "scene": scene, "ray": ray, "samples": SAMPLES, "seed": seed, "replicas": 1,
    }})
}

/// The shadow on the ground of a point in the light of a lamp; the point itself if there is none.
pub fn shadow(of: [f64; 3], lamp: [f64; 3]) -> [f64; 3] {
    let height = lamp[1] - of[1];
    if height < 0.1 {
        return of;
    }
    let along = (of[1] / height).min(4.0);
    std::array::from_fn(|i| of[i] + along * (of[i] - lamp[i]))
}
