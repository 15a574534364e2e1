//! Mistakes in lights and cameras.

use std::f64::consts::PI;

use conform::mistakes as m;
use conform::ours;
use groundtruth::math::{Step, Transform, Vector};
use serde::Deserialize;
use serde_json::{Value, json};

use super::super::altered::{data, instead, vector, with};
use super::planted::{Answer, Numbers, Question, planted};

const POINT: [&str; 1] = ["light.point"];
const PINHOLE: [&str; 2] = ["camera_ray.pinhole.values", "camera_ray.orthographic.values"];
const ROLLED: [&str; 2] = ["camera_ray.pinhole.roll", "project.orthographic"];
const LAMPS: [&str; 3] =
    ["light.area.rectangle.area", "light.area.disk.area", "light.area.mesh.area_mean"];
const SAMPLED: [&str; 5] = [
    "light.area.rectangle.solid_angle",
    "light.area.sphere.area",
    "light.area.disk.stretched",
    "light.environment.mean",
    "light.ambient_occluder.values",
];
const STRETCHED: [&str; 3] =
    ["light.area.rectangle.stretched", "light.area.disk.stretched", "light.area.mesh.stretched"];

planted! {
    FROM_LIGHT in POINT => Numbers("/direction", |x| -x);
    OVER_PI in ["light.directional"] => Numbers("/radiance", |x| x / PI);
    DIVIDED_BY_ZERO_ANGLE in ["camera_ray.fisheye.middle"] => Answer(|_, mut a| {
        if a["film"] == json!([0.0, 0.0]) {
            a["direction"] = json!(["nan", "nan", "nan"]);
        }
        a
    });
    PIXEL_CORNER in PINHOLE => Question(moved_half);
    MIRRORED in PINHOLE => Question(|data| {
        let width = data["image"]["width"].as_u64().unwrap_or(1);
        data["pixel"][0] = json!(width - 1 - data["pixel"][0].as_u64().unwrap_or(0));
    });
    INTEGER_HALF in PINHOLE => Answer(|q, a| {
        let [w, h] = ["width", "height"].map(|it| data(q)["image"][it].as_u64().unwrap_or(0));
        let [x, y] = [0, 1].map(|i| data(q)["pixel"][i].as_u64().unwrap_or(0));
        if x + 1 >= w || y == 0 {
            return a;
        }
        instead(q, |data| {
            data["image"]["width"] = json!(w - w % 2);
            data["image"]["height"] = json!(h - h % 2);
            data["pixel"][1] = json!(y - h % 2);
        })
    });
    NOT_NORMALISED_LENGTH in ["camera_ray.pinhole.values"] => Answer(|q, a| {
        // the length that has −distance along w: the axis is the ray of the middle
        let mut axis = q.clone();
        axis["camera_ray"]["image"] = json!({"width": 1, "height": 1});
        axis["camera_ray"]["pixel"] = json!([0, 0]);
        axis["camera_ray"]["place"] = json!([0.5, 0.5]);
        let axis = vector(&ours(&axis).unwrap_or_default()["direction"]);
        let direction = vector(&a["direction"]);
        let cosine: f64 = (0..3).map(|i| axis[i] * direction[i]).sum();
        let distance = data(q)["camera"]["lens"]["pinhole"]["distance"].as_f64();
        with(a, "/direction", |x| x * distance.unwrap_or(1.0) / cosine)
    });
    EYES_EXCHANGED in ["camera_ray.stereo"] =>
        Question(|data| data["eye"] = json!(if data["eye"] == "left" { "right" } else { "left" }));
    NO_ROLL in ROLLED => Question(|data| data["camera"]["roll"] = json!(0.0));
    "rays and points disagree" in ["camera_ray.fisheye.there_and_back"] => Numbers("/image", |x| x + 0.25);
    "pdf × 7" in SAMPLED => Numbers("/pdf", |x| 7.0 * x);
    "the cosine left out of the pdf of a lamp" in LAMPS =>
        Answer(|q, a| { let cosine = cosine_at_lamp(q, &a); with(a, "/pdf", |x| cosine * x) });
    "the square of the distance left out of the pdf" in LAMPS => Answer(|_, a| {
        let distance = a["distance"].as_f64().unwrap_or(1.0);
        with(a, "/pdf", |x| x / (distance * distance))
    });
    LAMP_TWO_SIDED in ["light.area.rectangle.sides", "light.area.disk.sides"] =>
        Question(|data| data["lamp"]["two_sided"] = json!(true));
    "the normal of a lamp moved as a vector" in STRETCHED => Answer(|q, a| {
        let cosine = cosine_at_lamp(q, &a);
        let steps = &data(q)["lamp"]["shape"]["instance"]["transform"];
        let Ok(steps) = Vec::<Step>::deserialize(steps) else { return a };
        // all lamps lie in the plane y = 0 before
        let Ok(place) = Transform::from_steps(&steps) else { return a };
        let wrong = place.vector(Vector::Y).unit().expect("a length");
        let wrong = wrong.dot(Vector::from(vector(&a["direction"]))).abs();
        with(a, "/pdf", |x| x * cosine / wrong)
    });
}

/// The cosine between the normal of a lamp where a sample meets it and the way back.
fn cosine_at_lamp(question: &Value, sample: &Value) -> f64 {
    let (shape, from) = (&data(question)["lamp"]["shape"], &data(question)["from"]);
    let ray = json!({"origin": from, "direction": sample["direction"]});
    let hit = ours(&json!({"intersect": {"shape": shape, "ray": ray}})).unwrap_or_default();
    let [n, w] = [&hit["normal"], &sample["direction"]].map(vector);
    (0..3).map(|i| n[i] * w[i]).sum::<f64>().abs()
}

/// Asks for the film point half a pixel down and to the left: that of a picture with one column and one row more.
fn moved_half(data: &mut Value) {
    for pointer in ["/image/width", "/image/height", "/pixel/1"] {
        let value = data.pointer_mut(pointer).expect("cases say it");
        *value = json!(value.as_u64().unwrap_or(0) + 1);
    }
}
