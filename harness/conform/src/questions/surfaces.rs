//! Textures and mappings (Suffern, ch. 29, 30).

use ask::{number, numbers, triple};
use serde_json::Value;

use super::super::mistakes as m;
use super::{Mistakes, change, data};

/// Those of `texture`.
pub const TEXTURE: Mistakes = Mistakes {
    questions: &[(&m::NO_HALF_TEXEL, |question| {
        let image = question.pointer("/texture/texture/image")?;
        let rows = image["texels"].as_array()?;
        let counts = [rows[0].as_array()?.len(), rows.len()].map(|n| n as f64);
        let _ = image.get("filtering").filter(|it| *it == "bilinear")?;
        let data = data(question)?;
        change(data, "/uv/0", |u| u + 0.5 / counts[0])?;
        change(data, "/uv/1", |v| v + 0.5 / counts[1])
    })],
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
    questions: &[],
    answers: &[
        (&m::AZIMUTH_OFF, |question, _, right| other_azimuth(question, right, 1.0)),
        (&m::AZIMUTH_OFF, |question, _, right| other_azimuth(question, right, 0.5)),
        (&m::HALF_TURN, |question, _, right| {
            is_around(question).then(|| numbers(right).map(|uv| vec![2.0 * uv[0], uv[1]]))?
        }),
        (&m::DIVIDED_BY_ZERO_AXIS, |question, _, _| {
            let [x, y, _] = triple(&question["mapping"]["point"])?;
            (x == 0.0 && y == 0.0).then(|| vec![f64::NAN; 2])
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
