use super::LawReport;
use crate::traced::Traced;
use groundtruth::math::Vector;
use text::digits::short;

/// A point less the centre over the radius is a unit vector but for the error of the point, which may be large beside the
/// radius; what is not made a unit vector at all is farther from it.
const NEARLY: f64 = 1e-3;

pub fn check(traced: &Traced, asked: &mut LawReport) {
    // the length of the first normal of each object
    let mut lengths = std::collections::HashMap::new();
    for (index, ray) in traced.rays() {
        let Some(normal) = ray.shading_normal.or(ray.normal) else { continue };
        let normals = [ray.normal.unwrap_or(normal), normal];
        if normals.iter().any(|n| !n.is_finite()) {
            continue;
        }
        let [one, other] = normals.map(Vector::length);
        let worst = if (one - 1.0).abs() > (other - 1.0).abs() { one } else { other };
        let first = *lengths.entry(ray.object.as_ref()).or_insert(worst);
        asked.count(index, (worst - 1.0).abs() <= NEARLY.max(traced.tolerance()), || {
            let is_same = (worst - first).abs() <= 16.0 * traced.tolerance() * first;
            let causes =
                [("scaled-by-transform", is_same && worst > 0.0), ("zero-normal", worst == 0.0)];
            (format!("hits a surface whose normal has the length {}", length_words(worst)), causes)
        });
    }
}

/// `0.6`, or `1 + 3e-7`.
fn length_words(length: f64) -> String {
    let off = length - 1.0;
    match off.abs() < 1e-3 {
        true => format!("1 {} {}", if off < 0.0 { '−' } else { '+' }, short(off.abs())),
        false => short(length),
    }
}
