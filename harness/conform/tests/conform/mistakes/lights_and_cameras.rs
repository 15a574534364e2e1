//! Mistakes in lights and cameras.

use std::f64::consts::PI;

use conform::mistakes as m;
use conform::ours;
use groundtruth::math::{Step, Transform, Vector};
use serde::Deserialize;
use serde_json::{Value, json};

use super::super::altered::{at, data, instead, only, vector};
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
const ZOOMED: [&str; 2] = ["camera_ray.orthographic.zoom", "project.pinhole"];

planted! {
    FROM_LIGHT in POINT => Numbers("/direction", |x| -x);
    TIMES_DISTANCE in POINT => Answer(|_, mut a| {
        let distance = a["distance"].as_f64().unwrap_or(1.0);
        at(&mut a, "/direction", |x| distance * x);
        a
    });
    NO_FALL_OFF in POINT => Question(|data| data["light"]["point"]["attenuation"] = json!(0.0));
    DISTANCE_SQUARED in POINT => Numbers("/distance", |x| x * x);
    OVER_PI in ["light.directional"] => Numbers("/radiance", |x| x / PI);
    SUN_NOT_NORMALISED in ["light.directional"] =>
        Answer(|q, mut a| { a["direction"] = data(q)["light"]["directional"]["direction"].clone(); a });
    WHOLE_FIELD_OF_VIEW in ["camera_ray.fisheye.values"] => Answer(|q, mut a| {
        let mut axis = q.clone();
        axis["camera_ray"]["image"] = json!({"width": 1, "height": 1});
        axis["camera_ray"]["pixel"] = json!([0, 0]);
        axis["camera_ray"]["place"] = json!([0.5, 0.5]);
        let axis = vector(&ours(&axis).unwrap_or_default()["direction"]);
        let d = vector(&a["direction"]);
        // the direction mirrored: twice the angle from the axis
        let cosine: f64 = (0..3).map(|i| axis[i] * d[i]).sum();
        if !a["direction"].is_null() {
            a["direction"] = json!([0, 1, 2].map(|i| 2.0 * cosine * d[i] - axis[i]));
        }
        a
    });
    DIVIDED_BY_ZERO_ANGLE in ["camera_ray.fisheye.middle"] => Answer(|_, mut a| {
        if a["film"] == json!([0.0, 0.0]) {
            a["direction"] = json!(["nan", "nan", "nan"]);
        }
        a
    });
    TURNED_BY_HALF in PINHOLE => Question(|data| {
        for (axis, side) in ["width", "height"].into_iter().enumerate() {
            let length = data["image"][side].as_u64().unwrap_or(1);
            let pixel = data["pixel"][axis].as_u64().unwrap_or(0);
            data["pixel"][axis] = json!(length - 1 - pixel);
            at(data, &format!("/place/{axis}"), |u| 1.0 - u);
        }
    });
    PIXEL_CORNER in PINHOLE => Question(moved_half);
    UPSIDE_DOWN in PINHOLE => Question(|data| {
        let height = data["image"]["height"].as_u64().unwrap_or(1);
        data["pixel"][1] = json!(height - 1 - data["pixel"][1].as_u64().unwrap_or(0));
    });
    MIRRORED in PINHOLE => Question(|data| {
        let width = data["image"]["width"].as_u64().unwrap_or(1);
        data["pixel"][0] = json!(width - 1 - data["pixel"][0].as_u64().unwrap_or(0));
    });
    MIRRORED in PINHOLE => Question(|data| {
        let width = data["image"]["width"].as_u64().unwrap_or(1);
        data["pixel"][0] = json!(width - 1 - data["pixel"][0].as_u64().unwrap_or(0));
        at(data, "/place/0", |u| 1.0 - u);
    });
    AXES_SWAPPED in PINHOLE => Answer(|q, _| {
        // a quarter turn of an image upside down
        instead(q, |data| {
            let roll = data["camera"]["roll"].as_f64().unwrap_or(0.0);
            data["camera"]["roll"] = json!(roll + 90.0);
            let height = data["image"]["height"].as_u64().unwrap_or(1);
            data["pixel"][1] = json!(height - 1 - data["pixel"][1].as_u64().unwrap_or(0));
            at(data, "/place/1", |v| 1.0 - v);
        })
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
    PLACE_DOWN in PINHOLE => Question(|data| at(data, "/place/1", |v| 1.0 - v));
    ROLL_REVERSED in ROLLED => Question(|data| at(data, "/camera/roll", |roll| -roll));
    DEGREES in ROLLED => Question(|data| at(data, "/camera/roll", |roll| roll / PI * 180.0));
    ZOOM_INVERTED in ZOOMED => Question(|data| at(only(&mut data["camera"]["lens"]), "/zoom", |zoom| 1.0 / zoom));
    NOT_NORMALISED_LENGTH in ["camera_ray.pinhole.values"] => Answer(|q, mut a| {
        // the length that has −distance along w: the axis is the ray of the middle
        let mut axis = q.clone();
        axis["camera_ray"]["image"] = json!({"width": 1, "height": 1});
        axis["camera_ray"]["pixel"] = json!([0, 0]);
        axis["camera_ray"]["place"] = json!([0.5, 0.5]);
        let axis = vector(&ours(&axis).unwrap_or_default()["direction"]);
        let direction = vector(&a["direction"]);
        let cosine: f64 = (0..3).map(|i| axis[i] * direction[i]).sum();
        let distance = data(q)["camera"]["lens"]["pinhole"]["distance"].as_f64();
        at(&mut a, "/direction", |x| x * distance.unwrap_or(1.0) / cosine);
        a
    });
    NO_PIXEL_SIZE in PINHOLE => Question(|data| data["image"]["pixel_size"] = json!(1.0));
    NO_ROLL in ROLLED => Question(|data| data["camera"]["roll"] = json!(0.0));
    BACKWARDS in ["camera_ray.orthographic.values"] => Numbers("/direction", |x| -x);
    PIXEL_CORNER in ["project.pinhole"] => Numbers("/image", |x| x - 0.5);
    UPSIDE_DOWN in ["project.pinhole"] => Answer(|q, mut a| {
        let height = data(q)["image"]["height"].as_f64().unwrap_or(1.0);
        at(&mut a, "/image/1", |y| height - y);
        a
    });
    "rays and points disagree" in ["camera_ray.fisheye.there_and_back"] => Numbers("/image", |x| x + 0.25);
    "pdf × 7" in SAMPLED => Numbers("/pdf", |x| 7.0 * x);
    "the cosine left out of the pdf of a lamp" in LAMPS =>
        Answer(|q, mut a| { let cosine = cosine_at_lamp(q, &a); at(&mut a, "/pdf", |x| cosine * x); a });
    "the square of the distance left out of the pdf" in LAMPS => Answer(|_, mut a| {
        let distance = a["distance"].as_f64().unwrap_or(1.0);
        at(&mut a, "/pdf", |x| x / (distance * distance));
        a
    });
    "lamps of half the radiance" in LAMPS => Numbers("/radiance", |x| 0.5 * x);
    LAMP_TWO_SIDED in ["light.area.rectangle.sides", "light.area.disk.sides"] =>
        Question(|data| data["lamp"]["two_sided"] = json!(true));
    "the normal of a lamp moved as a vector" in STRETCHED => Answer(|q, mut a| {
        let cosine = cosine_at_lamp(q, &a);
        let steps = &data(q)["lamp"]["shape"]["instance"]["transform"];
        let Ok(steps) = Vec::<Step>::deserialize(steps) else { return a };
        // all lamps lie in the plane y = 0 before
        let Ok(place) = Transform::from_steps(&steps) else { return a };
        let wrong = place.vector(Vector::Y).unit().expect("a length");
        let wrong = wrong.dot(Vector::from(vector(&a["direction"]))).abs();
        at(&mut a, "/pdf", |x| x * cosine / wrong);
        a
    });
    "a lamp one unit nearer" in ["light.area.rectangle.turned"] => Numbers("/distance", |x| x - 1.0);
    LENS_DIAMETER in ["camera_ray.thin_lens.values"] =>
        Question(|data| at(only(&mut data["camera"]["lens"]), "/lens_radius", |radius| 0.5 * radius));
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
