//! Camera rays and their inverse (Suffern, ch. 3, 8 to 12).

use ask::{Draw, numbers, triple};
use serde_json::{Value, json};

use super::super::mistakes as m;
use super::super::probe::ours;
use super::{Mistakes, change, data, only, remove, round, swap};
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

/// What turns the film of a question for a ray.
type Change = fn(&mut Value) -> Option<()>;

/// The rows alone: the place in a pixel is still counted upwards.
const ROWS_FROM_BELOW: Change = |question| {
    let data = data(question)?;
    let height = data["image"]["height"].as_f64()?;
    let pixel = data["pixel"][1].as_u64()?;
    data["pixel"][1] = json!(height as u64 - 1 - pixel);
    Some(())
};

/// The columns alone: the place in a pixel is still counted to the right.
const COLUMNS_FROM_RIGHT: Change = |question| {
    let data = data(question)?;
    let width = data["image"]["width"].as_f64()?;
    let pixel = data["pixel"][0].as_u64()?;
    data["pixel"][0] = json!(width as u64 - 1 - pixel);
    Some(())
};

/// The whole film, with the point of the lens; a roll may be applied before it.
const MIRRORED_LENS: Change = |question| {
    change(data(question)?, "/lens/0", |x| -x)?;
    MIRRORED(question)
};

const MIRRORED_ROLL: Change = |question| {
    ROLL_REVERSED(question)?;
    change(data(question)?, "/lens/0", |x| -x);
    MIRRORED(question)
};

/// The picture turned by 180°, the point of the lens with it.
const TURNED_BY_HALF: Change = |question| {
    for axis in ["/lens/0", "/lens/1"] {
        change(data(question)?, axis, |x| -x);
    }
    MIRRORED(question)?;
    UPSIDE_DOWN(question)
};

const UPSIDE_DOWN: Change = |question| {
    change(data(question)?, "/place/1", |v| 1.0 - v);
    ROWS_FROM_BELOW(question)
};

const MIRRORED: Change = |question| {
    change(data(question)?, "/place/0", |u| 1.0 - u);
    COLUMNS_FROM_RIGHT(question)
};

/// The point `(y, x)` of the film for `(x, y)`, in a picture on its side.
const AXES_SWAPPED: Change = |question| {
    let data = data(question)?;
    let length = |name: &str| data["image"][name].as_u64();
    let (width, height) = (length("width")?, length("height")?);
    let [x, y] = [0, 1].map(|i| data["pixel"][i].as_u64());
    data["pixel"] = json!([height - 1 - y?, width - 1 - x?]);
    swap(data, "/place/0", "/place/1");
    swap(data, "/image/width", "/image/height")
};

/// Half a pixel to the right and up where the number of pixels is odd: in a picture of one more, in the next column.
const INTEGER_HALF: Change = |question| {
    let data = data(question)?;
    let is_odd =
        |pointer: &&str| data.pointer(pointer).and_then(Value::as_u64).is_some_and(|n| n % 2 == 1);
    let (wide, high) = (is_odd(&"/image/width"), is_odd(&"/image/height"));
    let moved = [("/image/width", wide), ("/pixel/0", wide), ("/image/height", high)];
    for (pointer, _) in moved.into_iter().filter(|(_, is_moved)| *is_moved) {
        let slot = data.pointer_mut(pointer)?;
        *slot = json!(slot.as_u64()? + 1);
    }
    Some(())
};

/// Half a pixel to the left and down: in a picture of one column and one row more, in the row below.
const CORNERS: Change = |question| {
    let data = data(question)?;
    for pointer in ["/image/width", "/image/height", "/pixel/1"] {
        let slot = data.pointer_mut(pointer)?;
        *slot = json!(slot.as_u64()? + 1);
    }
    Some(())
};

const NO_PIXEL_SIZE: Change = |question| change(data(question)?, "/image/pixel_size", |_| 1.0);
const NO_ROLL: Change = |question| remove(&mut data(question)?["camera"], "roll");
const ROLL_REVERSED: Change =
    |question| change(&mut data(question)?["camera"], "/roll", |degrees| -degrees);
const ROLL_IN_RADIANS: Change =
    |question| change(&mut data(question)?["camera"], "/roll", groundtruth::math::to_degrees);
const ZOOM_INVERTED: Change =
    |question| change(only(&mut data(question)?["camera"]["lens"])?, "/zoom", |zoom| 1.0 / zoom);
const NO_ZOOM: Change =
    |question| change(only(&mut data(question)?["camera"]["lens"])?, "/zoom", |_| 1.0);

/// Another radius of the lens: its point is that of the unit disk, times the radius.
fn lens_radius(question: &mut Value, by: f64) -> Option<()> {
    let data = data(question)?;
    ["/lens/0", "/lens/1"].into_iter().try_for_each(|at| change(data, at, |x| by * x))
}

/// Those of `camera_ray`.
pub const CAMERA_RAY: Mistakes = Mistakes {
    questions: &[
        (&m::UPSIDE_DOWN, UPSIDE_DOWN),
        (&m::UPSIDE_DOWN, ROWS_FROM_BELOW),
        (&m::MIRRORED, MIRRORED),
        (&m::MIRRORED, COLUMNS_FROM_RIGHT),
        (&m::MIRRORED, MIRRORED_LENS),
        (&m::MIRRORED, MIRRORED_ROLL),
        (&m::TURNED_BY_HALF, TURNED_BY_HALF),
        (&m::AXES_SWAPPED, AXES_SWAPPED),
        (&m::PIXEL_CORNER, CORNERS),
        (&m::INTEGER_HALF, INTEGER_HALF),
        (&m::PLACE_DOWN, |question| change(data(question)?, "/place/1", |v| 1.0 - v)),
        (&m::NO_PIXEL_SIZE, NO_PIXEL_SIZE),
        (&m::NO_ROLL, NO_ROLL),
        (&m::ROLL_REVERSED, ROLL_REVERSED),
        (&m::DEGREES, ROLL_IN_RADIANS),
        (&m::NO_ZOOM, NO_ZOOM),
        (&m::ZOOM_INVERTED, ZOOM_INVERTED),
        (&m::LENS_POINT, |question| lens_radius(question, 0.0)),
        (&m::LENS_DIAMETER, |question| lens_radius(question, 0.5)),
        (&m::LENS_RADIUS_DOUBLED, |question| lens_radius(question, 2.0)),
        (&m::LENS_UNSCALED, |question| {
            let lens = data(question)?.pointer_mut("/camera/lens/thin_lens")?;
            lens["focal_distance"] = lens["distance"].clone();
            Some(())
        }),
    ],
    answers: &[
        (&m::WHOLE_FIELD_OF_VIEW, |question, field, right| with_angle(question, field, right, 2.0)),
        (&m::HALF_FIELD_OF_VIEW, |question, field, right| with_angle(question, field, right, 0.5)),
        (&m::DIVIDED_BY_ZERO_ANGLE, |question, field, right| {
            question["camera_ray"]["camera"]["lens"].get("fisheye")?;
            let is_middle = numbers(&right["film"])?.iter().all(|x| *x == 0.0);
            (field == "direction" && is_middle).then(|| vec![f64::NAN; 3])
        }),
        (&m::BACKWARDS, |_, field, right| {
            let backwards = triple(&right["direction"])?.map(|x| -x).to_vec();
            (field == "direction").then_some(backwards)
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

/// The direction of a fisheye whose angle from the axis is `factor` times the right one.
fn with_angle(question: &Value, field: &str, right: &Value, factor: f64) -> Option<Vec<f64>> {
    let asked = &question["camera_ray"];
    asked["camera"]["lens"].get("fisheye")?;
    let mut axis = question.clone();
    let middle =
        json!({"camera": asked["camera"], "image": {"width": 1, "height": 1}, "pixel": [0, 0]});
    axis["camera_ray"] = middle;
    let axis = Vector::from(triple(&ours(&axis).ok()?["direction"])?);
    let direction = Vector::from(triple(&right["direction"])?);
    let ahead = direction.dot(axis);
    let across = (direction - ahead * axis).unit()?;
    let angle = factor * groundtruth::math::atan2(direction.dot(across), ahead);
    let turned = groundtruth::math::cos(angle) * axis + groundtruth::math::sin(angle) * across;
    (field == "direction").then(|| turned.to_array().to_vec())
}

/// Those of `project`.
pub const PROJECT: Mistakes = Mistakes {
    questions: &[
        (&m::NO_PIXEL_SIZE, NO_PIXEL_SIZE),
        (&m::NO_ROLL, NO_ROLL),
        (&m::ROLL_REVERSED, ROLL_REVERSED),
        (&m::DEGREES, ROLL_IN_RADIANS),
        (&m::NO_ZOOM, NO_ZOOM),
        (&m::ZOOM_INVERTED, ZOOM_INVERTED),
    ],
    answers: &[
        (&m::UPSIDE_DOWN, |question, field, right| {
            let [x, y] = numbers(&right["image"])?.try_into().ok()?;
            let height = question["project"]["image"]["height"].as_f64()?;
            (field == "image").then(|| vec![x, height - y])
        }),
        (&m::MIRRORED, |question, field, right| {
            let [x, y] = numbers(&right["image"])?.try_into().ok()?;
            let width = question["project"]["image"]["width"].as_f64()?;
            (field == "image").then(|| vec![width - x, y])
        }),
        (&m::TURNED_BY_HALF, |question, field, right| {
            let [x, y] = numbers(&right["image"])?.try_into().ok()?;
            let [width, height] =
                ["width", "height"].map(|it| question["project"]["image"][it].as_f64());
            (field == "image").then(|| Some(vec![width? - x, height? - y]))?
        }),
        (&m::PIXEL_CORNER, |_, field, right| {
            let moved = numbers(&right["image"])?.into_iter().map(|x| x - 0.5).collect();
            (field == "image").then_some(moved)
        }),
    ],
};
