use std::collections::BTreeMap;
use std::f64::consts::PI;
use std::sync::Arc;

use super::LawReport;
use super::weight::is_finite;
use crate::log::Purpose;
use crate::traced::Traced;
use text::digits::short;

/// Fewer hits say nothing of a mean.
const FEW: usize = 12;
/// How many standard errors of the mean above 1 are no chance: beyond 1e-8 for a single object.
const SURE: f64 = 6.0;

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
        objects
            .entry(traced.ray(parent).object.as_ref())
            .or_default()
            .push((parent, weight, before));
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
            // without the lots that were drawn
            let mut before = hits.iter().map(|it| it.2).filter(|sum| *sum > 0.0);
            let is_even = before.all(|sum| (sum - first.2).abs() <= 1e-3 * sum);
            let is_pi = if is_even { first.2 } else { mean } <= PI * (1.0 + error);
            (
                format!("hits a surface that sends on {} times the light that arrives, in the mean of {} hits", short(mean), hits.len()),
                [("density-leaves-out-lobe", !is_even), ("pi-missing", is_pi)],
            )
        });
    }
}
