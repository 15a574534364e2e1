//! Lights that are points or directions, textures and mappings (Suffern, ch. 14, 29, 30).

use ask::{number, numbers, triple};
use serde_json::{Value, json};

use super::super::mistakes as m;
use super::{Mistakes, change, data, only, remove, swap};
use groundtruth::math::power;

/// Those of `light`.
pub const LIGHT: Mistakes = Mistakes {
    questions: &[(&m::NO_FALL_OFF, |question| {
        let light = only(&mut data(question)?["light"])?;
        change(light, "/attenuation", |_| 0.0)
    })],
    answers: &[
        (&m::FROM_LIGHT, |_, field, right| {
            (field == "direction").then(|| negated(&right["direction"]))?
        }),
        (&m::TIMES_DISTANCE, |_, field, right| {
            let distance = number(&right["distance"])?;
            let scaled = triple(&right["direction"])?.map(|x| distance * x);
            (field == "direction").then(|| scaled.to_vec())
        }),
        (&m::SUN_NOT_NORMALISED, |question, field, _| {
            let sun = triple(&question["light"]["light"]["directional"]["direction"])?;
            (field == "direction").then(|| sun.to_vec())
        }),
        (&m::DISTANCE_SQUARED, |_, field, right| {
            let distance = number(&right["distance"])?;
            (field == "distance").then(|| vec![distance * distance])
        }),
        (&m::NO_FALL_OFF, |question, field, right| {
            let light = question["light"]["light"].as_object()?.values().next()?;
            let exponent = light["attenuation"].as_f64()?;
            let factor = power(number(&right["distance"])?, exponent);
            let all = numbers(&right["radiance"])?.into_iter().map(|x| factor * x).collect();
            (field == "radiance").then_some(all)
        }),
    ],
};

fn negated(value: &Value) -> Option<Vec<f64>> {
    Some(numbers(value)?.into_iter().map(|x| -x).collect())
}

/// Those of `texture`.
pub const TEXTURE: Mistakes = Mistakes {
    questions: &[
        (&m::TEXTURE_COLOURS_EXCHANGED, |question| {
            swap(only(&mut data(question)?["texture"])?, "/color1", "/color2")
        }),
        (&m::NO_SIZE, |question| change(only(&mut data(question)?["texture"])?, "/size", |_| 1.0)),
        (&m::NAN_AS_INTEGER, |question| {
            let data = data(question)?;
            let mapping = &data["texture"]["image"]["mapping"];
            let is_probe = mapping == "light_probe" || mapping == "panoramic";
            let [x, y, _] = triple(&data["point"])?;
            remove(data.pointer_mut("/texture/image")?, "mapping")?;
            data["uv"] = json!([0.0, 0.0]);
            (is_probe && x == 0.0 && y == 0.0).then_some(())
        }),
        (&m::SWAP_U, |question| swap(data(question)?, "/uv/0", "/uv/1")),
        (&m::MIRROR_U, |question| change(data(question)?, "/uv/0", |u| 1.0 - u)),
        (&m::MIRROR_V, |question| change(data(question)?, "/uv/1", |v| 1.0 - v)),
        (&m::SWAP_YZ, |question| swap(data(question)?, "/point/1", "/point/2")),
        (&m::FLIP_X, |question| change(data(question)?, "/point/0", |x| -x)),
        (&m::FLIP_Y, |question| change(data(question)?, "/point/1", |x| -x)),
        (&m::FLIP_Z, |question| change(data(question)?, "/point/2", |x| -x)),
    ],
    answers: &[(&m::CHECKER_TRUNCATED, |question, _, _| {
        let asked = &question["texture"];
        truncated(&asked["texture"], triple(&asked["point"])?)
    })],
};

/// The colour of a checker whose cells are numbered by truncation, which is one more than rounding down for negative
/// numbers; `None` on lines, and for other textures.
fn truncated(texture: &Value, point: [f64; 3]) -> Option<Vec<f64>> {
    if let Some(grey) = number(texture) {
        return Some(vec![grey; 3]);
    }
    let Some((tag, data)) = texture.as_object().and_then(|it| it.iter().next()) else {
        return numbers(texture);
    };
    let field = |name: &str, other: f64| data.get(name).map_or(Some(other), Value::as_f64);
    let [x, y, z] = point;
    // the cell along each axis, not rounded yet
    let cells = match &**tag {
        "checker3d" => {
            let size = field("size", 1.0)?;
            point.map(|x| x / size - 0.000_187_453_738).to_vec()
        }
        "plane_checker" => {
            let size = field("size", 1.0)?;
            vec![x / size, z / size]
        }
        "rectangle_checker" | "cylinder_checker" => {
            let unit = field("unit", 1.0)?;
            let share = |x: f64| 0.5 * x / unit + 0.5;
            let (columns, rows) = (field("num_horizontal", 20.0)?, field("num_vertical", 10.0)?);
            match &**tag {
                "rectangle_checker" => vec![columns * share(x), rows * share(z)],
                _ => {
                    let turn = groundtruth::math::atan2(x, z) / std::f64::consts::TAU;
                    vec![columns * turn.rem_euclid(1.0), rows * share(y)]
                }
            }
        }
        _ => return None,
    };
    let widths = [
        field("outline_width", 0.0)? / field("size", 1.0)?,
        line(data, "vertical"),
        line(data, "horizontal"),
    ];
    let widest = widths.into_iter().fold(0.0, f64::max);
    let is_on_line = |x: &f64| (x - x.round()).abs() < 0.5 * widest;
    if cells.iter().any(is_on_line) {
        return None;
    }
    let is_even = cells.iter().map(|x| x.trunc()).sum::<f64>().rem_euclid(2.0) == 0.0;
    truncated(&data[if is_even { "color1" } else { "color2" }], point)
}

/// The width of a checker's lines, as a share of a cell.
fn line(data: &Value, name: &str) -> f64 {
    data["lines"][name].as_f64().unwrap_or(0.0)
}

/// Those of `mapping`.
pub const MAPPING: Mistakes = Mistakes {
    questions: &[
        (&m::SWAP_YZ, |question| swap(data(question)?, "/point/1", "/point/2")),
        (&m::SWAP_XZ, |question| swap(data(question)?, "/point/0", "/point/2")),
        (&m::FLIP_X, |question| change(data(question)?, "/point/0", |x| -x)),
        (&m::FLIP_Z, |question| change(data(question)?, "/point/2", |x| -x)),
        (&m::AZIMUTH_FROM_X, |question| {
            swap(data(question)?, "/point/0", "/point/2")?;
            change(data(question)?, "/point/0", |x| -x)
        }),
    ],
    answers: &[
        (&m::MIRROR_U, |_, _, right| numbers(right).map(|uv| vec![1.0 - uv[0], uv[1]])),
        (&m::MIRROR_V, |_, _, right| numbers(right).map(|uv| vec![uv[0], 1.0 - uv[1]])),
        (&m::AZIMUTH_OFF, |question, _, right| other_azimuth(question, right, 1.0)),
        (&m::AZIMUTH_OFF, |question, _, right| other_azimuth(question, right, 0.5)),
        (&m::HALF_TURN, |question, _, right| {
            is_around(question).then(|| numbers(right).map(|uv| vec![2.0 * uv[0], uv[1]]))?
        }),
        (&m::HEIGHT_FOR_ANGLE, |question, _, right| {
            let mapping = &question["mapping"];
            let [_, y, _] = triple(&mapping["point"])?;
            let v = match mapping["mapping"].as_str()? {
                "spherical" => 0.5 * (y + 1.0),
                "hemispherical" => y,
                _ => return None,
            };
            Some(vec![numbers(right)?[0], v])
        }),
        (&m::DIVIDED_BY_ZERO_AXIS, |question, _, _| {
            let [x, y, _] = triple(&question["mapping"]["point"])?;
            (x == 0.0 && y == 0.0).then(|| vec![f64::NAN; 2])
        }),
        (&m::PROBE_TWICE, |question, _, right| {
            let mapping = &question["mapping"]["mapping"];
            let is_probe = mapping == "light_probe" || mapping == "panoramic";
            is_probe.then(|| numbers(right)?.into_iter().map(|x| Some(2.0 * x - 0.5)).collect())?
        }),
    ],
};

/// Whether u goes around the y axis.
fn is_around(question: &Value) -> bool {
    let of = &question["mapping"]["mapping"];
    ["cylindrical", "spherical", "hemispherical"].iter().any(|around| of == around)
}

/// The coordinates with so many turns less where the azimuth is negative, for x < 0.
fn other_azimuth(question: &Value, right: &Value, less: f64) -> Option<Vec<f64>> {
    let [x, ..] = triple(&question["mapping"]["point"])?;
    let uv = numbers(right)?;
    (x < 0.0 && is_around(question)).then(|| vec![uv[0] - less, uv[1]])
}
