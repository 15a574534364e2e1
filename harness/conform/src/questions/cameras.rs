//! Camera rays and their inverse (Suffern, ch. 3, 8 to 12).

use ask::{Draw, numbers, triple};
use serde_json::{Value, json};

use super::super::mistakes as m;
use super::super::probe::ours;
use super::{Mistakes, data, round};
use groundtruth::math::Vector;

/// Where a point is seen: most are on the ray of a pixel, some behind the camera, some beside.
pub fn seen_point(draw: &mut Draw, mut question: Value) -> Value {
    if draw.coin() {
        question["camera"]["roll"] = json!(round(draw.between(-90.0, 90.0)));
    }
    // through the centre of the lens
    question.as_object_mut().map(|fields| fields.remove("lens"));
    let ray = ours(&json!({"camera_ray": question})).unwrap_or_default();
    let [origin, along] = ["origin", "direction"].map(|it| triple(&ray[it]).unwrap_or_default());
    let ahead = draw.between(1.0, 8.0) * draw.pick(&[1.0, 1.0, 1.0, 1.0, 1.0, -1.0]);
    let reach = draw.pick(&[0.0, 0.0, 0.0, 1.0]);
    let aside = draw.vector(reach).to_array();
    let point: [f64; 3] = std::array::from_fn(|i| origin[i] + ahead * along[i] + ahead * aside[i]);
    json!({"camera": question["camera"], "image": question["image"], "point": point})
}

/// A ray through a pixel of a small picture, most of them through its middle.
pub fn pixel_ray(draw: &mut Draw, lens: &Value) -> Value {
    let at = draw.vector(1.0).to_array().map(round);
    let away = draw.direction().to_array();
    let eye: [f64; 3] = std::array::from_fn(|i| round(at[i] + 5.0 * away[i]));
    let size = [4 + draw.below(24), 4 + draw.below(18)];
    let pixel = size.map(|length| draw.below(length));
    let mut question = json!({
        "camera": {"eye": eye, "look_at": at, "lens": lens},
        "image": {"width": size[0], "height": size[1], "pixel_size": draw.pick(&[0.25, 0.5, 1.0])},
        "pixel": pixel,
    });
    if draw.coin() {
        question["place"] = json!([round(draw.between(0.0, 1.0)), round(draw.between(0.0, 1.0))]);
    }
    if lens.get("thin_lens").is_some() {
        question["lens"] = json!([round(draw.between(-0.7, 0.7)), round(draw.between(-0.7, 0.7))]);
    }
    question
}

/// The ray through the middle of a picture with odd sides, where polar coordinates have no angle.
pub fn in_the_middle(draw: &mut Draw, mut question: Value) -> Value {
    let halves = [draw.below(12), draw.below(9)];
    for (half, side) in halves.into_iter().zip(["width", "height"]) {
        question["image"][side] = json!(2 * half + 1);
    }
    question["pixel"] = json!(halves);
    question.as_object_mut().map(|fields| fields.remove("place"));
    question
}

/// Half a pixel to the right, and up or down, where the number of pixels is odd: in a picture of one more, in the next column.
fn integer_half(question: &mut Value, is_down: bool) -> Option<()> {
    let data = data(question)?;
    let is_odd =
        |pointer: &&str| data.pointer(pointer).and_then(Value::as_u64).is_some_and(|n| n % 2 == 1);
    let (wide, high) = (is_odd(&"/image/width"), is_odd(&"/image/height"));
    let moved = [
        ("/image/width", wide),
        ("/pixel/0", wide),
        ("/image/height", high),
        ("/pixel/1", high && is_down),
    ];
    for (pointer, _) in moved.into_iter().filter(|(_, is_moved)| *is_moved) {
        let slot = data.pointer_mut(pointer)?;
        *slot = json!(slot.as_u64()? + 1);
    }
    Some(())
}

/// Those of `camera_ray`.
pub const CAMERA_RAY: Mistakes = Mistakes {
    questions: &[
        (&m::INTEGER_HALF, |question| integer_half(question, false)),
        (&m::INTEGER_HALF, |question| integer_half(question, true)),
    ],
    answers: &[
        (&m::DIVIDED_BY_ZERO_ANGLE, |question, field, right| {
            question["camera_ray"]["camera"]["lens"].get("fisheye")?;
            let is_middle = numbers(&right["film"])?.iter().all(|x| *x == 0.0);
            (field == "direction" && is_middle).then(|| vec![f64::NAN; 3])
        }),
        (&m::NOT_NORMALISED_LENGTH, |question, field, right| {
            let lens = &question["camera_ray"]["camera"]["lens"]["pinhole"];
            let (distance, zoom) =
                (lens["distance"].as_f64()?, lens["zoom"].as_f64().unwrap_or(1.0));
            let [x, y] = numbers(&right["film"])?.try_into().ok()?;
            let length = Vector::new(x / zoom, y / zoom, distance).length();
            let scaled = triple(&right["direction"])?.map(|x| length * x).to_vec();
            (field == "direction").then_some(scaled)
        }),
    ],
};
