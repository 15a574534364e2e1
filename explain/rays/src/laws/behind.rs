use super::geometry::{glass, quoted};
use super::{LawReport, RayLaw};
use crate::log::Purpose;
use crate::traced::Traced;
use text::digits::short;

pub const LAW: RayLaw = RayLaw {
    name: "not-behind-the-lamp",
    says: "what blocks a shadow ray is between the point and the lamp, and takes its light",
    needs: &["kind", "t", "end"],
    causes: &[
        "the distance of the hit is compared with nothing: any hit blocks",
        "distance and t are compared in different units: the direction is no unit vector",
        "what is behind the point blocks: t is negative",
        "the lamp blocks its own light: the ray has to end before it",
        "the answer of the shadow ray is not used",
    ],
    check,
};

fn check(traced: &Traced, asked: &mut LawReport) {
    let glass = glass(traced);
    for (index, ray) in traced.log.rays.iter().enumerate() {
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
            (
                words,
                [
                    is_far && !is_scaled,
                    is_far && is_scaled,
                    is_behind && t < 0.0,
                    is_own,
                    is_unused,
                ],
            )
        });
    }
}

/// The part of the way at the lamp where what blocks may be the lamp itself.
const NEAR: f64 = 1e-2;
