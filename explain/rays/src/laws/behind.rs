use super::LawReport;
use super::geometry::{glass, quoted};
use crate::log::Purpose;
use crate::traced::Traced;
use text::digits::short;

pub fn check(traced: &Traced, asked: &mut LawReport) {
    let glass = glass(traced);
    for (index, ray) in traced.rays() {
        let (true, Some(t), Some(end)) = (ray.is(&Purpose::Shadow), ray.t, ray.end) else {
            continue;
        };
        if !(t.is_finite() && end.is_finite()) {
            continue;
        }
        // a ray that went on to the lamp brings its light
        let is_lit = ray.radiance.is_some_and(|light| light.max() > 0.0);
        let is_lamp = ray.object.is_some() && ray.object == ray.light;
        let slack = traced.tolerance() * end.abs()
            + traced.slack(ray.origin.to_vector().max_abs()) / ray.direction.length();
        let is_between = (-slack..=end + slack).contains(&t);
        let is_own = is_lamp && ray.radiance.is_some() && !is_lit;
        let is_passed = ray.object.as_ref().is_none_or(|name| glass.contains(name));
        let is_unused = is_lit && is_between && !is_lamp && !is_passed && t < (1.0 - NEAR) * end;
        let holds = if is_lamp { !is_own } else { !is_unused && (is_lit || is_between) };
        asked.count(index, holds, || {
            let length = ray.direction.length();
            let is_scaled = (length - 1.0).abs() > 1e-3 && (t * length <= end || t <= end * length);
            let (what, at) = (quoted(ray.object.as_ref(), "something"), short(t));
            let words = match (is_own, is_unused) {
                (true, _) => format!("is dark, and it is its lamp that blocks it, at t {at}"),
                (_, true) => {
                    format!("is blocked by {what} at t {at}, and brings light all the same")
                }
                _ if t < 0.0 => format!("is blocked by {what} behind its own start, at t {at}"),
                _ => format!("is blocked by {what} at t {at}, behind its lamp at {}", short(end)),
            };
            let is_behind = !is_own && !is_unused;
            let is_far = is_behind && t >= 0.0;
            let causes = [
                ("distance-not-compared", is_far && !is_scaled),
                ("distance-in-other-units", is_far && is_scaled),
                ("behind-start", is_behind && t < 0.0),
                ("lamp-blocks-itself", is_own),
                ("answer-not-used", is_unused),
            ];
            (words, causes)
        });
    }
}

/// The part of the way at the lamp where what blocks may be the lamp itself.
const NEAR: f64 = 1e-2;
