use std::collections::BTreeMap;
use std::sync::Arc;

use super::LawReport;
use super::geometry::{Leaving, is_near, leaving, mirrored, spread};
use super::refracted::{Ratios, logged, ratio, usual_ratios};
use crate::log::{Purpose, Ray};
use crate::traced::{Traced, median};
use groundtruth::lobes::fresnel;
use groundtruth::math::{Vector, ln, power};
use text::digits::short;

/// Fewer rays show no function of the angle.
const FEW: usize = 8;
/// How near all shares have to be to a formula. Where formulas differ by less, a picture does not show it.
const NEAR: f64 = 2e-3;
/// The part of the rays that has to follow it: at grazing angles the indices are known badly.
const MOST: f64 = 0.95;
/// By how much numbers have to differ to be said to.
const DIFFER: f64 = 5e-2;

/// What a share of light is: that of a transmitted ray; of the ray reflected beside one, which absorption behind the surface does not
/// change; or of a ray reflected in place of one, or by a mirror.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Of {
    Transmitted,
    Beside,
    Instead,
}

struct Share {
    index: usize,
    /// The part of the light that it has, with its probability.
    part: f64,
    choice: f64,
    cos: f64,
    /// How far the ray goes that has this part.
    far: f64,
    /// What [`transmitted`] gives.
    formulas: [f64; 3],
    of: Of,
}

/// The object, the ratio of its indices in hundredths, and what the share is: a vessel has several.
type Group<'a> = (Option<&'a Arc<str>>, i64, Of);

impl Share {
    /// The part by a formula, if what is transmitted is this function of it.
    fn by(&self, at: usize, of: &dyn Fn(f64) -> f64) -> f64 {
        let transmitted = of(self.formulas[at]);
        if self.of == Of::Transmitted { transmitted } else { 1.0 - transmitted }
    }
}

pub fn check(traced: &Traced, asked: &mut LawReport) {
    let usual = usual_ratios(traced);
    let mut groups: BTreeMap<Group<'_>, Vec<Share>> = BTreeMap::new();
    for it in leaving(traced) {
        if let Some((eta, share)) = share(traced, &it, &usual) {
            let group = (it.parent.object.as_ref(), (100.0 * eta).round() as i64, share.of);
            groups.entry(group).or_default().push(share);
        }
    }
    for shares in groups.into_values().filter(|shares| shares.len() >= FEW) {
        judge(&shares, 16.0 * traced.tolerance(), asked);
    }
}

/// Whether nearly all parts are these but for a constant, which is the colour of the surface.
fn are(shares: &[Share], error: f64, of: impl Fn(&Share) -> f64) -> bool {
    let near = |value: f64, middle: f64| (value - middle).abs() <= error * middle.max(NEAR);
    let ratios: Vec<f64> = shares.iter().map(|it| it.part / of(it)).collect();
    let Some(middle) = median(ratios.clone()) else { return false };
    let alike = ratios.iter().filter(|ratio| near(**ratio, middle)).count();
    // what is reflected is no more than all of it; what is transmitted may count its spread
    let is_colour = shares[0].of != Of::Beside || middle <= 1.0 + NEAR;
    alike as f64 >= MOST * shares.len() as f64 && is_colour
}

/// Whether the parts are those of a formula but for a constant and for what a medium absorbs: Beer's law, the same share of light
/// over each unit of length.
fn are_absorbed(shares: &[Share], at: usize) -> bool {
    let known = shares.iter().filter(|it| it.far.is_finite());
    let points = known.map(|it| (it.far, ln(it.part / it.by(at, &|part| part))));
    let points: Vec<(f64, f64)> = points.collect();
    let least = points.iter().min_by(|a, b| a.0.total_cmp(&b.0));
    let most = points.iter().max_by(|a, b| a.0.total_cmp(&b.0));
    let Some((&(near, first), &(far, last))) = least.zip(most) else { return false };
    let absorption = (first - last) / (far - near);
    let is_on = |&&(t, y): &&(f64, f64)| (y - first + absorption * (t - near)).abs() <= 2.0 * NEAR;
    let on = points.iter().filter(is_on).count();
    absorption > 0.0 && on as f64 >= MOST * shares.len() as f64
}

fn judge(shares: &[Share], rounding: f64, asked: &mut LawReport) {
    let same = |part: f64| part;
    let is = |of: &dyn Fn(f64) -> f64| (0..2).any(|at| are(shares, NEAR, |it| it.by(at, of)));
    let differ = |of: fn(&Share) -> f64| spread(shares.iter().map(of)) > DIFFER;
    let is_undivided = differ(|it| it.choice)
        && (0..2).any(|at| are(shares, NEAR, |it| it.choice * it.by(at, &same)));
    let is_cosine =
        shares[0].of == Of::Instead && differ(|it| it.part) && are(shares, NEAR, |it| it.cos);
    let is_twice = match shares[0].of {
        Of::Instead => (0..2).any(|at| are(shares, NEAR, |it| power(it.by(at, &same), 2.0))),
        _ => is(&|part| part * part),
    };
    let is_single = is(&|part| 2.0 * part - 1.0);
    // inside it hardly depends on the angle, but by more than rounding
    let is_dense = are(shares, rounding, |it| it.by(2, &same))
        && !are(shares, rounding, |_| 1.0)
        && !is(&same);
    let holds = match shares[0].of {
        // what else a surface reflects may depend on the angle in other ways
        Of::Instead => !(is_undivided || is_cosine || is_dense),
        _ => {
            // a mistake that predicts the numbers is no absorption that happens to be near them
            let is_absorbed = !(is_single || is_twice || is_undivided)
                && (0..2).any(|at| are_absorbed(shares, at));
            !is_dense && (are(shares, NEAR, |_| 1.0) || is(&same) || is_absorbed)
        }
    };
    let causes = [
        ("other-cosine", is_dense),
        ("one-polarisation", is_single),
        ("counts-twice", is_twice),
        ("choice-missing", is_undivided),
        ("mirror-cosine", is_cosine),
    ];
    for share in shares {
        let should = share.by(0, &same);
        let is_near = (share.part - should).abs() <= NEAR * should.max(NEAR);
        asked.count(share.index, holds || is_near, || {
            let [part, should, cos] = [share.part, should, share.cos].map(short);
            let whose = match share.of {
                Of::Beside => "has a reflected ray beside it with",
                _ => "has",
            };
            let words = match is_cosine {
                true => format!("has {part} of the light, as the cosine to its normal, {cos}"),
                false => format!(
                    "{whose} {part} of the light, where Fresnel's equations give it {should}"
                ),
            };
            (words, causes)
        });
    }
}

/// The index behind the surface over that in front, 0 if it is not known, and the share.
fn share(traced: &Traced, it: &Leaving<'_>, usual: &Ratios) -> Option<(f64, Share)> {
    let facing = it.facing()?;
    let factors = &it.ray.factors;
    let (weight, choice) = (factors.weight?.max(), factors.choice);
    let beside = |kind: &Purpose| {
        traced.children[it.from].iter().map(|&it| traced.ray(it)).find(|ray| ray.is(kind))
    };
    let length = |ray: &Ray| ray.end_point().map_or(f64::INFINITY, |end| end.distance(ray.origin));
    let (of, part, eta, far) = match it.ray.kind {
        Some(Purpose::Transmitted) => {
            let [front, behind] =
                [it.arriving, it.leaving].map(|v: Vector| v.cross(facing).length());
            let seen = (front > 0.05 && behind > 0.05).then(|| front / behind);
            let eta = logged(traced, it).map(|ratio| 1.0 / ratio).or(seen)?;
            match beside(&Purpose::Reflected) {
                Some(ray) => (Of::Beside, ray.factors.weight?.max(), Some(eta), length(ray)),
                None => (Of::Transmitted, weight * choice?, Some(eta), length(it.ray)),
            }
        }
        Some(Purpose::Reflected) if beside(&Purpose::Transmitted).is_none() => {
            let eta = ratio(traced, it, usual).map(|ratio| 1.0 / ratio);
            // what scatters is no mirror
            let is_mirrored = is_near(it.leaving, mirrored(it.arriving, facing), NEAR);
            let part = is_mirrored.then_some(weight * choice.unwrap_or(1.0))?;
            (Of::Instead, part, eta, length(it.ray))
        }
        _ => return None,
    };
    let cos = it.arriving.dot(facing).abs();
    let formulas = eta.map_or([0.0; 3], |eta| transmitted(cos, eta));
    // the lots of a ray beside another one, or of a mirror, may depend on anything
    let choice = choice.filter(|_| of != Of::Beside && eta.is_some()).unwrap_or(1.0);
    let share = Share { index: it.index, part, choice, cos, far, formulas, of };
    let is_told = part.is_finite() && (0..3).all(|at| share.by(at, &|part| part) > NEAR);
    is_told.then_some((eta.unwrap_or(0.0), share))
}

/// What is transmitted: by Fresnel's equations, by Schlick's formula with the cosine in the thinner medium, and with the other.
fn transmitted(cos: f64, eta: f64) -> [f64; 3] {
    let cos_behind = (1.0 - (1.0 - cos * cos) / (eta * eta)).max(0.0).sqrt();
    let normal = fresnel(1.0, eta).reflected;
    let schlick = |cos: f64| (1.0 - normal) * (1.0 - power(1.0 - cos, 5.0));
    let [thin, dense] = [cos.min(cos_behind), cos.max(cos_behind)];
    [fresnel(cos, eta).transmitted, schlick(thin), schlick(dense)]
}
