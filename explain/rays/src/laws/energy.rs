use std::collections::BTreeMap;
use std::f64::consts::PI;
use std::sync::Arc;

use super::LawReport;
use super::weight::is_finite;
use crate::log::{Purpose, Ray};
use crate::traced::Traced;
use text::digits::short;

/// Fewer hits say nothing of a mean.
const FEW: usize = 12;
/// How many standard errors of the mean above 1 are no chance: beyond 1e-8 for a single object.
const SURE: f64 = 6.0;

/// What a largest value may be above that of its formula.
const ROUND: f64 = 1.0 + 1e-3;

/// A hit: its ray, the sum of the weights that leave it, and that without the lots that were drawn.
type Hit = (usize, f64, f64);

pub fn check(traced: &Traced, asked: &mut LawReport) {
    let mut objects: BTreeMap<Option<&Arc<str>>, Vec<Hit>> = BTreeMap::new();
    for (parent, children) in traced.children.iter().enumerate() {
        let scattered = children.iter().map(|&it| traced.ray(it));
        let scattered = scattered.filter(|it| !it.is_shadow() && !it.is(&Purpose::Transmitted));
        // a hit that sends nothing on counts, too: roulette makes up for it in the others
        let mut weights = scattered.map(|ray| {
            let weight = ray.factors.weight.filter(|it| is_finite(*it))?.max();
            Some([weight, weight * ray.factors.choice.unwrap_or(1.0)])
        });
        let sum = weights.try_fold([0.0; 2], |sum, it| Some([sum[0] + it?[0], sum[1] + it?[1]]));
        let Some([weight, before]) = sum.filter(|_| traced.end_point(parent).is_some()) else {
            continue;
        };
        let hits = objects.entry(traced.ray(parent).object.as_ref()).or_default();
        hits.push((parent, weight, before));
    }
    for hits in objects.into_values() {
        if hits.len() < FEW || hits.iter().all(|it| it.1 == 0.0) {
            continue;
        }
        let count = hits.len() as f64;
        let mean = hits.iter().map(|it| it.1).sum::<f64>() / count;
        let variance = hits.iter().map(|it| (it.1 - mean) * (it.1 - mean)).sum::<f64>() / count;
        let error = SURE * (variance / count).sqrt() + 16.0 * traced.tolerance();
        let holds = mean <= 1.0 + error;
        let first = hits.iter().find(|it| holds || it.1 > 1.0).unwrap_or(&hits[0]);
        asked.rays += hits.len() - 1;
        asked.count(first.0, holds, || {
            let words = format!(
                "hits a surface that sends on {} times the light that arrives, in the mean of {} hits",
                short(mean),
                hits.len()
            );
            (words, causes(traced, &hits, first.2, mean / (1.0 + error)))
        });
    }
}

/// What is missing, by the mean that is sure, and what the first hit that is told sends on without the lots that were drawn.
fn causes(traced: &Traced, hits: &[Hit], before: f64, mean: f64) -> [(&'static str, bool); 4] {
    let mut drawn = hits.iter().map(|it| it.2).filter(|sum| *sum > 0.0);
    let is_even = drawn.all(|sum| (sum - before).abs() <= 1e-3 * sum);
    let least = if is_even { before / ROUND } else { mean };
    // the factors that are logged there decide between π and the cosine
    let largest = |of: &dyn Fn(&Ray) -> Option<f64>| {
        let rays = hits.iter().flat_map(|it| &traced.children[it.0]);
        rays.filter_map(|&ray| of(traced.ray(ray))).reduce(f64::max)
    };
    let has_pi = largest(&|ray| Some(ray.factors.f?.max())).is_some_and(|f| f <= ROUND / PI);
    let pdf = largest(&|ray| ray.factors.pdf.filter(|_| !ray.is_shadow()));
    let is_uniform = pdf.map(|pdf| pdf <= 0.5 * ROUND / PI);
    let lacks_pi = least <= PI && !has_pi && !(is_even && is_uniform == Some(true));
    let lacks_cosine = is_even && least <= 2.0 && is_uniform != Some(false);
    [
        ("density-leaves-out-lobe", !is_even && is_uniform != Some(true)),
        ("pi-or-cosine-missing", lacks_pi && lacks_cosine),
        ("cosine-missing", lacks_cosine && !lacks_pi),
        ("pi-missing", lacks_pi && !lacks_cosine),
    ]
}
