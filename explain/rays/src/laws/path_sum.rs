use std::collections::HashMap;
use std::sync::Arc;

use super::LawReport;
use super::weight::{is_finite, is_near};
use crate::log::Purpose;
use crate::traced::Traced;
use groundtruth::rgb::Rgb;
use text::digits::three;

/// What a ray adds to its camera ray.
struct Part<'a> {
    throughput: Rgb,
    /// Its factor in its parent alone.
    weight: Rgb,
    light: Rgb,
    mis: f64,
    /// The lamp of a shadow ray, if it is blocked.
    blocked: Option<Option<&'a Arc<str>>>,
    is_shadow: bool,
}

pub fn check(traced: &Traced, asked: &mut LawReport) {
    let tolerance = 64.0 * traced.tolerance();
    let has_hit = |ray: usize| traced.end_point(ray).is_some();
    let is_root =
        |it: &usize| traced.parents[*it].is_none() && traced.ray(*it).is(&Purpose::Camera);
    let roots = || (0..traced.log.rays.len()).filter(is_root);
    let is_dark = |it: usize| traced.ray(it).radiance.is_some_and(|light| light.max() == 0.0);
    let is_black = roots().any(|it| !has_hit(it) && is_dark(it));
    let mut lamps: HashMap<Option<&Arc<str>>, Rgb> = HashMap::new();
    for ray in traced.log.rays.iter().filter(|ray| ray.is_shadow()) {
        lamps.extend(ray.radiance.filter(|it| it.max() > 0.0).map(|it| (ray.light.as_ref(), it)));
    }
    for root in roots() {
        let Some(radiance) = traced.ray(root).radiance.filter(|it| is_finite(*it)) else {
            continue;
        };
        let Some(parts) = parts(traced, root, is_black) else { continue };
        let sum = |value: &dyn Fn(&Part<'_>) -> Rgb| parts.iter().map(value).sum::<Rgb>();
        let with_mis = |it: &Part<'_>| it.mis * it.throughput * it.light;
        let expected = sum(&with_mis);
        let without_mis = sum(&|it| it.throughput * it.light);
        if !is_finite(expected) {
            continue;
        }
        let is = |color: Rgb| is_near(radiance, color, tolerance);
        asked.count(root, is(expected) || is(without_mis), || {
            let of_lamp = |it: &Part<'_>| it.blocked.and_then(|lamp| lamps.get(&lamp).copied());
            let only = |shadow: bool| {
                sum(&|it| if it.is_shadow == shadow { with_mis(it) } else { Rgb::BLACK })
            };
            let alone = |it: &Part<'_>| {
                if it.is_shadow { it.weight * it.light } else { with_mis(it) }
            };
            let unblocked = |it: &Part<'_>| {
                with_mis(it) + of_lamp(it).map_or(Rgb::BLACK, |light| it.throughput * light)
            };
            let causes = [
                ("direct-without-throughput", is(sum(&alone))),
                ("blocked-added", is(sum(&unblocked))),
                ("hits-left-out", is(only(true))),
                ("direct-left-out", is(only(false))),
            ];
            let [is, should] = [radiance, expected].map(|it| three(it.to_array()));
            (format!("brings {is}, where the rays of its path bring {should}"), causes)
        });
    }
}

/// What the rays of a path add, if the log has it all.
fn parts(traced: &Traced, root: usize, is_black: bool) -> Option<Vec<Part<'_>>> {
    let (mut parts, mut open) = (Vec::new(), vec![root]);
    while let Some(index) = open.pop() {
        let (ray, is_root) = (traced.ray(index), index == root);
        if ray.direct.is_some() || !ray.is_shadow() && !is_root && ray.radiance.is_some() {
            return None;
        }
        let weight = ray.factors.weight.or(is_root.then_some(Rgb::WHITE))?;
        let own =
            if traced.conventions.throughput_before && !is_root { weight } else { Rgb::WHITE };
        let throughput = own * ray.factors.throughput.or(is_root.then_some(Rgb::WHITE))?;
        // what comes from the background may not be in the log
        let is_open = !ray.is_shadow() && traced.end_point(index).is_none() && !is_black;
        let light = match ray.is_shadow() {
            true => ray.radiance?,
            false => ray.emitted.or((!is_open).then_some(Rgb::BLACK))?,
        };
        let mis = if ray.is_shadow() { 1.0 } else { ray.factors.mis.unwrap_or(1.0) };
        let is_blocked = ray.is_shadow() && (ray.t.is_some() || ray.object.is_some());
        let blocked = is_blocked.then_some(ray.light.as_ref());
        parts.push(Part { throughput, weight, light, mis, blocked, is_shadow: ray.is_shadow() });
        open.extend(&traced.children[index]);
    }
    (parts.len() > 1).then_some(parts)
}
