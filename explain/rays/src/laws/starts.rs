use std::collections::HashMap;

use super::LawReport;
use super::geometry::{Leaving, leaving};
use crate::log::Purpose;
use crate::traced::Traced;
use groundtruth::math::Vector;
use text::digits::short;

/// The part of the length of a usual ray above which an offset is seen in the picture.
const TOO_LARGE: f64 = 3e-2;
/// Above this part it is no offset at all.
const ELSEWHERE: f64 = 0.3;

pub fn check(traced: &Traced, asked: &mut LawReport) {
    let elsewhere: Vec<Leaving<'_>> =
        leaving(traced).filter(|it| away(traced, it).length() > it.slack(traced)).collect();
    // the first of each object
    let mut shifts: HashMap<_, Vec<Vector>> = HashMap::new();
    for it in &elsewhere {
        shifts.entry(it.parent.object.as_ref()).or_default().push(away(traced, it));
    }
    let is_shift = |it: &Leaving<'_>| {
        let of_object = &shifts[&it.parent.object.as_ref()];
        let slack = 8.0 * it.slack(traced);
        of_object.len() > 1
            && of_object.iter().all(|other| (*other - of_object[0]).length() <= slack)
    };
    for it in leaving(traced) {
        let away = away(traced, &it);
        let slack = it.slack(traced);
        let is_wrong_side = is_wrong_side(&it, away, slack);
        let holds =
            away.length() <= slack || away.length() <= TOO_LARGE * traced.scale && !is_wrong_side;
        asked.count(it.index, holds, || {
            let root = traced.way_up(it.index).last().unwrap_or(it.index);
            let at_camera = (it.ray.origin - traced.ray(root).origin).length() <= slack;
            let is_offset = away.length() <= ELSEWHERE * traced.scale && !at_camera;
            let causes = [
                ("offset-to-wrong-side", is_wrong_side && is_offset),
                ("offset-too-large", is_offset && !is_wrong_side),
                ("starts-at-camera", at_camera),
                ("object-space", !at_camera && is_shift(&it)),
            ];
            let from = match is_wrong_side && is_offset {
                true => "behind the surface that it leaves",
                false => "from where the ray that sent it ended",
            };
            (format!("starts {} {from}", short(away.length())), causes)
        });
    }
}

/// From where it should start to where it does.
fn away(traced: &Traced, it: &Leaving<'_>) -> Vector {
    match it.ray.is_shadow() && traced.conventions.shadow_from_lamp {
        // it starts at the lamp, and ends at the point
        true => traced.way_to_lamp(it.ray).map_or(Vector::ZERO, |way| it.ray.origin + way - it.end),
        false => it.ray.origin - it.end,
    }
}

fn is_wrong_side(it: &Leaving<'_>, away: Vector, slack: f64) -> bool {
    let Some(normal) = it.facing() else { return false };
    let (moved, goes) = (away.dot(normal), it.leaving.dot(normal));
    // a lamp below the horizon is hidden by the surface itself: such a ray may start on the viewer's side
    let is_hidden = it.ray.is_shadow() && goes <= 0.0;
    // where it goes by mistake is for another law to say: its kind tells the side, too
    let side = match it.ray.kind {
        Some(Purpose::Transmitted) => -1.0,
        Some(Purpose::Reflected | Purpose::Diffuse | Purpose::Glossy) => 1.0,
        _ => goes,
    };
    let is_wrong = moved * goes < 0.0 && moved * side < 0.0;
    moved.abs() > slack && is_wrong && goes.abs() > 1e-3 && !is_hidden
}
