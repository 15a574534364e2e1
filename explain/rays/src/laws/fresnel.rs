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

/// A transmitted ray: the part of the light that it has, or that which the ray reflected beside it has, and the parts that
/// formulas give to what is transmitted.
struct Share {
    index: usize,
    part: f64,
    formulas: [f64; 3],
    /// Whether it is the part of the reflected ray: absorption behind the surface does not change it.
    is_reflected: bool,
}

impl Share {
    /// The part by a formula, if what is transmitted is this function of it.
    fn by(&self, at: usize, of: &dyn Fn(f64) -> f64) -> f64 {
        let transmitted = of(self.formulas[at]);
        if self.is_reflected { 1.0 - transmitted } else { transmitted }
    }
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
        // whether all parts are these but for a constant, which is the colour of the surface
        let are = |of: &dyn Fn(&Share) -> f64| {
            let ratios: Vec<f64> = shares.iter().map(|it| it.part / of(it)).collect();
            let Some(middle) = median(ratios.clone()) else { return false };
            let alike = ratios.iter().filter(|ratio| near(**ratio, middle)).count();
            // what is reflected is no more than all of it; what is transmitted may count its spread
            let is_colour = shares.iter().all(|it| !it.is_reflected) || middle <= 1.0 + NEAR;
            alike as f64 >= MOST * shares.len() as f64 && is_colour
        };
        let is = |of: &dyn Fn(f64) -> f64| (0..3).any(|at| are(&|it: &Share| it.by(at, of)));
        let holds = are(&|_| 1.0) || is(&|part| part);
        let causes = [
            ("one-polarisation", is(&|part| 2.0 * part - 1.0)),
            ("counts-twice", is(&|part| part * part)),
        ];
        for share in &shares {
            let should = share.by(0, &|part| part);
            asked.count(share.index, holds || near(share.part, should), || {
                let [part, should] = [share.part, should].map(short);
                let whose = match share.is_reflected {
                    true => "has a reflected ray beside it with",
                    false => "has",
                };
                let words = format!(
                    "{whose} {part} of the light, where Fresnel's equations give it {should}"
                );
                (words, causes)
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
    let is_reflected = beside.is_some();
    let part = match (beside, it.ray.factors.choice) {
        (Some(&beside), _) => traced.ray(beside).factors.weight?.max(),
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
    let share = Share { index: it.index, part, formulas, is_reflected };
    let is_told = part.is_finite() && (0..3).all(|at| share.by(at, &|part| part) > NEAR);
    is_told.then_some((eta > 1.0, share))
}
