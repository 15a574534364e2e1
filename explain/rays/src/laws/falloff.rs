use std::collections::BTreeMap;

use super::LawReport;
use crate::log::{Purpose, Ray};
use crate::traced::Traced;
use groundtruth::math::power;
use text::digits::short;

/// The powers of the distance that light falls with by mistake.
const WRONG: [(&str, f64); 3] =
    [("falls-with-1", 1.0), ("falls-with-3", 3.0), ("falls-with-4", 4.0)];
/// Fewer rays, and distances that differ less, show no power.
const FEW: usize = 8;
const RANGE: f64 = 1.2;
/// How near to a power all rays of a lamp have to be: that of the next whole number is farther.
const NEAR: f64 = 2e-3;

pub fn check(traced: &Traced, asked: &mut LawReport) {
    let mut lamps: BTreeMap<_, Vec<(usize, f64, f64)>> = BTreeMap::new();
    for (index, ray) in traced.rays().filter(|(_, ray)| is_lit(ray)) {
        let far = traced.way_to_lamp(ray).map(|way| way.length());
        let light = ray.radiance.map(|light| light.max());
        if let (Some(far), Some(light)) = (far.filter(|far| far.is_finite() && *far > 0.0), light) {
            lamps.entry(&ray.light).or_default().push((index, far, light));
        }
    }
    for rays in lamps.into_values() {
        let range = |value: &dyn Fn(f64, f64) -> f64| {
            let values = || rays.iter().map(|&(_, far, light)| value(far, light));
            values().fold(0.0, f64::max) / values().fold(f64::INFINITY, f64::min)
        };
        if rays.len() < FEW || range(&|far, _| far) < RANGE {
            continue;
        }
        let falls = |exponent: f64| range(&|far, light| light * power(far, exponent)) <= 1.0 + NEAR;
        let wrong = WRONG.map(|(key, exponent)| (key, falls(exponent)));
        let is_wrong = wrong.iter().any(|it| it.1);
        if !(falls(0.0) || falls(2.0) || is_wrong) {
            continue;
        }
        let nearest = rays.iter().min_by(|a, b| a.1.total_cmp(&b.1)).unwrap_or(&rays[0]);
        let farthest = rays.iter().max_by(|a, b| a.1.total_cmp(&b.1)).unwrap_or(&rays[0]);
        for &(index, far, light) in &rays {
            asked.count(index, !is_wrong, || {
                let is_near = far * far < nearest.1 * farthest.1;
                let &(_, other, brightness) = if is_near { farthest } else { nearest };
                let part = short(light / brightness);
                let [far, other] = [far, other].map(short);
                let words = format!(
                    "brings {part} times as much from a lamp {far} away as from {other} away"
                );
                (words, wrong)
            });
        }
    }
}

/// Whether a ray reached its lamp and says what it brings.
fn is_lit(ray: &Ray) -> bool {
    let is_free = ray.t.is_none() && (ray.object.is_none() || ray.object == ray.light);
    ray.is(&Purpose::Shadow) && is_free && ray.radiance.is_some_and(|light| light.max() > 0.0)
}
