use std::collections::BTreeMap;
use std::sync::Arc;

use super::LawReport;
use super::geometry::{Leaving, leaving};
use super::refracted::logged;
use crate::log::Purpose;
use crate::traced::{Traced, median};
use groundtruth::lobes::fresnel;
use groundtruth::math::{Vector, power};
use text::digits::short;

/// Fewer rays show no function of the angle.
const FEW: usize = 8;
/// How near all shares have to be to a formula. Where formulas differ by less, a picture does not show it.
const NEAR: f64 = 2e-3;
/// The part of the rays that has to follow it: at grazing angles the indices are known badly.
const MOST: f64 = 0.95;

/// A transmitted ray: the part of the light that it has, and the parts that formulas give it.
struct Share {
    index: usize,
    part: f64,
    formulas: [f64; 3],
}

pub fn check(traced: &Traced, asked: &mut LawReport) {
    let mut groups: BTreeMap<(Option<&Arc<str>>, bool), Vec<Share>> = BTreeMap::new();
    for it in leaving(traced).filter(|it| it.ray.is(&Purpose::Transmitted)) {
        if let Some((enters, share)) = share(traced, &it) {
            groups.entry((it.parent.object.as_ref(), enters)).or_default().push(share);
        }
    }
    for shares in groups.into_values().filter(|shares| shares.len() >= FEW) {
        let near = |value: f64, middle: f64| (value - middle).abs() <= NEAR * middle.max(NEAR);
        // what all parts are but for a constant, if a formula gives it
        let constant = |of: &dyn Fn(&Share) -> f64| {
            let ratios: Vec<f64> = shares.iter().map(|it| it.part / of(it)).collect();
            let middle = median(ratios.clone())?;
            let alike = ratios.iter().filter(|ratio| near(**ratio, middle)).count();
            (alike as f64 >= MOST * shares.len() as f64).then_some(middle)
        };
        let is_even = constant(&|_| 1.0).is_some();
        let holds = is_even || (0..3).any(|at| constant(&|it| it.formulas[at]).is_some());
        let is = |of: &dyn Fn(f64) -> f64| {
            (0..3).any(|at| constant(&|it| of(it.formulas[at])).is_some())
        };
        let causes = [
            ("one-polarisation", is(&|part| 2.0 * part - 1.0)),
            ("counts-twice", is(&|part| part * part)),
        ];
        for share in &shares {
            let [part, should] = [share.part, share.formulas[0]].map(short);
            let is_off = !near(share.part, share.formulas[0]);
            asked.count(share.index, holds || !is_off, || {
                (
                    format!("has {part} of the light, where Fresnel's equations give it {should}"),
                    causes,
                )
            });
        }
    }
}

/// Whether the ray enters a denser medium, and its share.
fn share(traced: &Traced, it: &Leaving<'_>) -> Option<(bool, Share)> {
    let facing = it.facing()?;
    let weight = it.ray.factors.weight?.max();
    let is_beside = |child: &&usize| traced.ray(**child).is(&Purpose::Reflected);
    let beside = traced.children[it.from].iter().find(is_beside);
    let part = match (beside, it.ray.factors.choice) {
        (Some(&beside), _) => 1.0 - traced.ray(beside).factors.weight?.max(),
        (None, Some(choice)) => weight * choice,
        (None, None) => return None,
    };
    let [front, behind] = [it.arriving, it.leaving].map(|v: Vector| v.cross(facing).length());
    let seen = (front > 0.05 && behind > 0.05).then(|| front / behind);
    let eta = logged(traced, it).map(|ratio| 1.0 / ratio).or(seen)?;
    let [cos, cos_behind] = [it.arriving, it.leaving].map(|v| v.dot(facing).abs());
    let normal = fresnel(1.0, eta).reflected;
    let schlick = |cos: f64| (1.0 - normal) * (1.0 - power(1.0 - cos, 5.0));
    let formulas = [fresnel(cos, eta).transmitted, schlick(cos), schlick(cos.min(cos_behind))];
    let is_told = part.is_finite() && formulas.iter().all(|part| *part > NEAR);
    is_told.then_some((eta > 1.0, Share { index: it.index, part, formulas }))
}
