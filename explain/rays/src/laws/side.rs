use std::collections::HashSet;
use std::sync::Arc;

use super::LawReport;
use super::geometry::{Leaving, glass, leaving};
use crate::log::Purpose;
use crate::traced::Traced;
use text::digits::short;

pub fn check(traced: &Traced, asked: &mut LawReport) {
    // whether directions below and above are as frequent: drawn over the whole sphere
    let sides: Vec<bool> = leaving(traced)
        .filter(|it| it.ray.is(&Purpose::Diffuse))
        .filter_map(|it| Some(it.facing()?.dot(it.leaving) < 0.0))
        .collect();
    let below = sides.iter().filter(|below| **below).count();
    let is_sphere = sides.len() >= 20 && (2 * below).abs_diff(sides.len()) < sides.len() / 2;
    let glass = glass(traced);
    for it in leaving(traced) {
        let (should_pass, is_lamp) = match it.ray.kind {
            Some(Purpose::Diffuse | Purpose::Glossy) => (false, false),
            Some(Purpose::Transmitted) => (true, false),
            Some(Purpose::Shadow) if lights(&it, &glass) => (false, true),
            _ => continue,
        };
        let (Some(facing), Some(normal)) = (it.facing(), it.normal()) else { continue };
        let is_turned = it.ray.is_shadow() && traced.conventions.shadow_from_lamp;
        let cos = facing.dot(if is_turned { -it.leaving } else { it.leaving });
        // along the surface the side is a matter of rounding, of a lamp one of the shading normal
        let within = if is_lamp { BEHIND } else { traced.tolerance() };
        let holds = if should_pass { cos <= within } else { cos >= -within };
        asked.count(it.index, holds, || {
            let is_scattered = !should_pass && !is_lamp;
            let is_turned_away = normal.dot(it.arriving) > 0.0;
            let is_shading = it.parent.shading_normal.is_some_and(|n| n.dot(it.leaving) > 0.0);
            let causes = [
                ("normal-not-turned", is_scattered && is_turned_away),
                ("about-shading-normal", is_scattered && !is_turned_away && is_shading),
                ("whole-sphere", is_scattered && is_sphere),
                ("lamp-behind-surface", is_lamp),
            ];
            let side = match (should_pass, is_lamp) {
                (true, _) => "stays on the viewer's side of",
                (_, true) => "brings light from behind",
                _ => "goes below",
            };
            (format!("{side} the surface that it leaves, at a cosine of {}", short(cos)), causes)
        });
    }
}

/// The sine below the surface that a smooth normal may turn a lamp to.
const BEHIND: f64 = 0.05;

/// Whether the ray of a lamp adds light to a surface that nothing passes.
fn lights(it: &Leaving<'_>, glass: &HashSet<&Arc<str>>) -> bool {
    let [weight, radiance] = [it.ray.factors.weight, it.ray.radiance];
    weight.zip(radiance).is_some_and(|(weight, light)| weight.max() > 0.0 && light.max() > 0.0)
        && it.parent.object.as_ref().is_some_and(|name| !glass.contains(name))
        && it.parent.shading_normal.is_none()
}
