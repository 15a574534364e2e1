//! Radiance along a ray of a whole scene, without random numbers (Suffern, ch. 14 to 16, 24, 27, 28).

use serde_json::{Value, json};

use super::super::family::{Family, Judge};
use super::super::radiance;
use super::{family, round, vector};
use exact::Draw;

/// A material's tag, its chapter, and a case of it.
type Material = (&'static str, &'static str, fn(&mut Draw) -> Value);

pub fn families() -> Vec<Family> {
    let materials: [Material; 5] = [
        (
            "matte",
            "ch14",
            |draw| json!({"matte": {"ka": 0.25, "kd": share(draw), "cd": color(draw)}}),
        ),
        ("phong", "ch15", |draw| json!({"phong": phong(draw)})),
        (
            "reflective",
            "ch24",
            |draw| json!({"reflective": {"phong": phong(draw), "kr": share(draw)}}),
        ),
        ("transparent", "ch27", |draw| {
            let eta = round(draw.between(1.1, 1.8));
            json!({"transparent": {"phong": highlight(), "eta": eta, "kr": 0.125, "kt": 0.875}})
        }),
        ("dielectric", "ch28", |draw| {
            let eta = round(draw.between(1.1, 1.8));
            json!({"dielectric": {"phong": highlight(), "inside": {"eta": eta}}})
        }),
    ];
    let radiance = |(name, chapter, material): Material| {
        let case = move |draw: &mut Draw| question(draw, material);
        let about = format!("materials/{name}");
        let mut family = family(
            &format!("radiance.{name}.values"),
            &about,
            chapter,
            Judge::Answer(radiance::judge),
            case,
        );
        family.share = 0.5;
        family.namer = Some(radiance::NAMER);
        family
    };
    materials.into_iter().map(radiance).collect()
}

fn share(draw: &mut Draw) -> f64 {
    round(draw.between(0.2, 0.8))
}

fn color(draw: &mut Draw) -> Value {
    json!([share(draw), share(draw), share(draw)])
}

fn phong(draw: &mut Draw) -> Value {
    let exponent = draw.pick(&[5.0, 20.0]);
    json!({"ka": 0.25, "kd": 0.5, "cd": color(draw), "ks": share(draw), "exponent": exponent})
}

fn highlight() -> Value {
    json!({"ks": 0.25, "exponent": 100.0})
}

/// A sphere over a plane, a lamp, and a ray from somewhere above.
fn question(draw: &mut Draw, material: fn(&mut Draw) -> Value) -> Value {
    let (material, ground) = (material(draw), color(draw));
    let is_direct = ["matte", "phong"].iter().any(|kind| material.get(kind).is_some());
    let origin: [f64; 3] =
        [draw.between(-4.0, 4.0), draw.between(1.5, 5.0), draw.between(4.0, 7.0)].map(round);
    let aim = [draw.between(-1.4, 1.4), draw.between(0.1, 2.0), draw.between(-1.0, 1.0)];
    let direction: [f64; 3] = std::array::from_fn(|i| round(aim[i] - origin[i]));
    let scene = json!({
        "image": {"width": 8, "height": 8},
        "camera": {"eye": [0.0, 2.0, 6.0], "lens": {"pinhole": {"distance": 8.0}}},
        "tracer": if is_direct { json!("ray_cast") } else { json!({"whitted": {"max_depth": 4}}) },
        "materials": [
            {"name": "first", "recipe": material},
            {"name": "ground", "recipe": {"matte": {"ka": 0.25, "kd": 0.5, "cd": ground}}},
        ],
        "lights": [
            {"name": "sky", "source": {"ambient": {"ls": 0.5}}},
            {"name": "lamp", "source": {"point": {"ls": 3.0, "location": above(draw)}}},
        ],
        "objects": [
            {"name": "ball", "material": "first",
             "shape": {"sphere": {"center": [0.0, 1.0, 0.0], "radius": 1.0}}},
            {"name": "floor", "material": "ground",
             "shape": {"plane": {"point": [0.0, 0.0, 0.0], "normal": [0.0, 1.0, 0.0]}}},
        ],
    });
    json!({"radiance": {"scene": scene, "ray": {"origin": origin, "direction": direction}, "replicas": 1}})
}

fn above(draw: &mut Draw) -> Value {
    let mut at = vector(draw, 4.0);
    at[1] = json!(round(draw.between(4.0, 8.0)));
    at
}
