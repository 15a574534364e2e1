//! Laws of cameras and matrices: there and back.

use ask::{Asking, numbers, triple};
use serde_json::{Value, json};

use super::super::judgement::{Judgement, Profile};
use super::super::probe::ours;
use super::{LawOutcome, missing, relative, within};

/// Law: a point on a camera's ray is seen where the ray starts (Suffern, ch. 9 to 11). The case is a `camera_ray`.
pub fn there_and_back(ask: &mut Asking<'_>, case: &Value, profile: Profile) -> LawOutcome {
    let ray = ask.ask(case)?;
    let (Some(origin), Some(direction)) = (triple(&ray["origin"]), triple(&ray["direction"]))
    else {
        let is_seen = ours(case).is_ok_and(|ray| !ray["direction"].is_null());
        return if is_seen { missing("direction") } else { Ok(Judgement::Undecided) };
    };
    let asked = &case["camera_ray"];
    let point: [f64; 3] = std::array::from_fn(|i| origin[i] + 5.0 * direction[i]);
    let question =
        json!({"project": {"camera": asked["camera"], "image": asked["image"], "point": point}});
    let seen = ask.ask(&question)?;
    let [px, py] = [0, 1].map(|i| asked["pixel"][i].as_f64().unwrap_or(0.0));
    let [u, v] = [0, 1].map(|i| asked["place"][i].as_f64().unwrap_or(0.5));
    let expected = [px + u, py + 1.0 - v];
    let at_edge = expected
        .iter()
        .zip([&asked["image"]["width"], &asked["image"]["height"]])
        .any(|(x, length)| *x < 1e-3 || *x > length.as_f64().unwrap_or(0.0) - 1e-3);
    if at_edge {
        return Ok(Judgement::Undecided);
    }
    // the film's coordinates are rounded relative to its size, and wide lenses stretch at their rim
    let off = relative(&seen["image"], &json!(expected)) / 64.0;
    Ok(within(profile, "image", off, || format!("image = {expected:?}, where the ray starts")))
}

/// Law: `M M⁻¹ = 1` (Suffern, ch. 20). The case is a `transform`.
pub fn inverse_is_inverse(ask: &mut Asking<'_>, case: &Value, profile: Profile) -> LawOutcome {
    let answer = ask.ask(case)?;
    let rows = |name: &str| {
        let rows: Option<Vec<Vec<f64>>> = answer[name].as_array()?.iter().map(numbers).collect();
        rows.filter(|rows| rows.len() >= 3 && rows.iter().all(|row| row.len() == 4))
    };
    let Some(m) = rows("matrix") else { return missing("matrix") };
    let Some(inverse) = rows("inverse") else {
        return Ok(Judgement::Undecided); // some programs have only the one that they need
    };
    let entry = |i: usize, j: usize| {
        let terms: [f64; 3] = std::array::from_fn(|k| m[i][k] * inverse[k][j]);
        let moved = if j == 3 { m[i][3] } else { 0.0 };
        let identity = if i == j { 1.0 } else { 0.0 };
        let size = terms.iter().map(|x| x.abs()).sum::<f64>() + moved.abs() + 1.0;
        (terms.iter().sum::<f64>() + moved - identity).abs() / size
    };
    let off = (0..12).map(|at| entry(at / 4, at % 4)).fold(0.0, f64::max);
    Ok(within(profile, "M·M⁻¹", off, || "matrix · inverse = 1".to_owned()))
}
