use std::collections::BTreeMap;

use super::LawReport;
use super::geometry::{Leaving, leaving};
use super::weight::is_finite;
use crate::log::Purpose;
use crate::traced::Traced;
use groundtruth::lobes::fresnel;
use groundtruth::rgb::Rgb;
use text::digits::short;

/// How near a share is to Fresnel's to be taken for it.
const NEAR: f64 = 1e-2;
/// Sines below this say nothing of the ratio of indices.
const STEEP: f64 = 1e-2;

pub fn check(traced: &Traced, asked: &mut LawReport) {
    let mut pairs: BTreeMap<usize, [Option<Leaving<'_>>; 2]> = BTreeMap::new();
    for it in leaving(traced) {
        let place = match it.ray.kind {
            Some(Purpose::Reflected) => 0,
            Some(Purpose::Transmitted) => 1,
            _ => continue,
        };
        pairs.entry(it.from).or_default()[place].get_or_insert(it);
    }
    for pair in pairs.into_values() {
        let [Some(mirrored), Some(through)] = pair else { continue };
        let weights = mirrored.ray.factors.weight.zip(through.ray.factors.weight);
        let Some((reflected, transmitted)) = weights else { continue };
        if is_finite(reflected) && is_finite(transmitted) {
            judge(traced, asked, &through, mirrored.index, [reflected, transmitted]);
        }
    }
}

fn judge(
    traced: &Traced,
    asked: &mut LawReport,
    through: &Leaving<'_>,
    index: usize,
    [reflected, transmitted]: [Rgb; 2],
) {
    let Some(facing) = through.facing() else { return };
    let [front, behind] = [through.arriving, through.leaving].map(|v| v.cross(facing).length());
    // the sines say which index is behind
    let eta = (front > STEEP && behind > STEEP).then(|| front / behind);
    let squared = eta.map_or(1.0, |eta| eta * eta);
    let sum = |factor: f64| (reflected + factor * transmitted).max();
    let r = eta.map(|eta| fresnel(-through.arriving.dot(facing), eta).reflected);
    let near = |a: f64, b: f64| (a - b).abs() <= NEAR;
    let is_exchanged = r.is_some_and(|r| {
        !near(r, 0.5) && near(reflected.max(), 1.0 - r) && near(transmitted.max(), r)
    });
    let holds = sum(1.0).min(sum(squared)) <= 1.0 + 16.0 * traced.tolerance() && !is_exchanged;
    asked.count(index, holds, || {
        let whole = near(reflected.max(), 1.0) && near(transmitted.max(), 1.0);
        let is_other = eta.is_some() && near(sum(1.0 / squared), 1.0);
        let [reflected, transmitted] = [reflected, transmitted].map(|it| short(it.max()));
        (
            format!("counts {reflected}, and the transmitted ray beside it {transmitted}"),
            [
                ("parts-exchanged", is_exchanged),
                ("both-whole", whole),
                ("other-eta-squared", is_other),
            ],
        )
    });
}
