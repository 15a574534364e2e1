use std::collections::{BTreeMap, HashSet};
use std::f64::consts::PI;
use std::sync::Arc;

use super::LawReport;
use super::geometry::{Leaving, leaving, spread};
use crate::log::{Factors, Purpose};
use crate::traced::Traced;
use groundtruth::math::Vector;
use groundtruth::rgb::Rgb;
use text::digits::{short, three};

/// Fewer rays of an object show no habit.
const FEW: usize = 8;
/// How near numbers have to be to be all the same.
const EVEN: f64 = 1e-3;

/// The name of the object that rays leave.
type Left<'a> = Option<&'a Arc<str>>;

pub fn check(traced: &Traced, asked: &mut LawReport) {
    let tolerance = 2.0 * traced.tolerance();
    let mut cosines = vec![None; traced.log.rays.len()];
    leaving(traced).for_each(|it| cosines[it.index] = cosine(&it));
    let matte = matte(traced, &cosines);
    for (index, ray) in traced.rays() {
        let Factors { weight: Some(weight), f: Some(f), cos, pdf, choice, mis, .. } = &ray.factors
        else {
            continue;
        };
        let [pdf, choice, mis] = [pdf, choice, mis].map(|it| it.unwrap_or(1.0));
        // of a scattered ray the MIS weight belongs to what is emitted at its hit
        let apart = if ray.is_shadow() { 1.0 } else { 1.0 / mis };
        let parts = alike(traced, index);
        let fits = |factor: f64, tolerance: f64| {
            let expected = factor * mis / (pdf * choice) * *f;
            [1.0, apart, 1.0 / parts].iter().any(|it| is_near(*weight, *it * expected, tolerance))
        };
        // a cosine that is not logged may be within f, unless f is the same in all directions
        let own = cosines[index];
        let unlogged =
            own.filter(|own| cos.is_none() && fits(*own, tolerance / own.max(tolerance)));
        let is_matte =
            || traced.parent(index).is_some_and(|it| matte.contains(&it.object.as_ref()));
        let cos = cos.or(unlogged).or(own.filter(|_| !ray.is_shadow() && is_matte()));
        let factor = cos.unwrap_or(1.0) * mis / (pdf * choice);
        let expected = factor * *f;
        if !(is_finite(expected) && is_finite(*weight)) {
            continue;
        }
        asked.count(index, unlogged.is_some() || fits(cos.unwrap_or(1.0), tolerance), || {
            let is = |times: f64| {
                let near = |it: Rgb| is_near(*weight, times * it, tolerance);
                times.is_finite() && (near(expected) || near(apart * expected))
            };
            let cosine = cos.or(own).unwrap_or(1.0);
            let is_albedo = f.max() > 0.0 && is_near(*weight, Rgb::grey(factor), tolerance);
            let causes = [
                ("cosine-missing", cos.is_some() && is(1.0 / cosine)),
                ("cosine-twice", is(cosine)),
                ("pdf-missing", is(pdf)),
                ("pi-missing", is(PI)),
                ("pi-too-much", is(1.0 / PI)),
                ("choice-missing", is(choice)),
                ("mis-missing", (mis - 1.0).abs() > EVEN && is(1.0 / mis)),
                ("choice-twice", is(1.0 / choice)),
                ("brdf-missing", is_albedo),
            ];
            let [is, should] = [weight, &expected].map(|it| three(it.to_array()));
            (format!("counts {is}, where its factors give {should}"), causes)
        });
    }
    lots(traced, asked);
}

/// The cosine of a ray to the normal that shading uses.
fn cosine(it: &Leaving<'_>) -> Option<f64> {
    let normal = it.parent.shading_normal.and_then(Vector::unit).or(it.normal());
    normal.map(|normal| normal.dot(it.leaving).abs())
}

/// How many rays of its kind leave its hit: several may share what their surface brings.
fn alike(traced: &Traced, index: usize) -> f64 {
    let is_alike = |it: &&usize| traced.ray(**it).kind == traced.ray(index).kind;
    let count = |parent: usize| traced.children[parent].iter().filter(is_alike).count();
    traced.parents[index].map_or(1, count) as f64
}

/// The objects whose `f` is the same in all directions, by rays that log a density on the hemisphere and no cosine.
fn matte<'a>(traced: &'a Traced, cosines: &[Option<f64>]) -> HashSet<Left<'a>> {
    let mut objects: BTreeMap<Left<'a>, Vec<[f64; 2]>> = BTreeMap::new();
    for (index, parent) in traced.pairs().filter(|it| !traced.ray(it.0).is_shadow()) {
        let Factors { f, pdf, cos, .. } = &traced.ray(index).factors;
        let is_told = cos.is_none() && pdf.is_some_and(|pdf| pdf <= (1.0 + EVEN) / PI);
        if let (Some(f), Some(cosine), true) = (f, cosines[index], is_told) {
            let object = traced.ray(parent).object.as_ref();
            objects.entry(object).or_default().push([f.max(), cosine]);
        }
    }
    objects.retain(|_, rays| {
        let is_even = |at: usize| spread(rays.iter().map(|it| it[at])) <= EVEN;
        rays.len() >= FEW && is_even(0) && !is_even(1)
    });
    objects.into_keys().collect()
}

/// Rays of which `f` is not logged: if the weights of an object are all the same, or all as the cosine, whether lots were drawn
/// or not, the lots are not made up for.
fn lots(traced: &Traced, asked: &mut LawReport) {
    let mut objects: BTreeMap<Left<'_>, Vec<(usize, f64, [f64; 2])>> = BTreeMap::new();
    for it in leaving(traced).filter(|it| it.ray.factors.f.is_none()) {
        let is_scattered = matches!(it.ray.kind, Some(Purpose::Diffuse | Purpose::Path));
        let weight =
            it.ray.factors.weight.map(|it| it.max()).filter(|it| is_scattered && *it > 0.0);
        if let (Some(weight), Some(cosine)) = (weight, cosine(&it)) {
            let choice = it.ray.factors.choice.unwrap_or(1.0);
            let rays = objects.entry(it.parent.object.as_ref()).or_default();
            rays.push((it.index, choice, [weight, weight / cosine]));
        }
    }
    for rays in objects.into_values() {
        let drawn = rays.iter().filter(|it| it.1 < 1.0 - EVEN).count();
        let is_even = |times: &dyn Fn(f64) -> f64| {
            [0, 1].iter().any(|at| spread(rays.iter().map(|it| it.2[*at] * times(it.1))) <= EVEN)
        };
        let is_left_out = is_even(&|_| 1.0);
        if drawn < FEW || rays.len() - drawn < FEW || !(is_left_out || is_even(&|choice| choice)) {
            continue;
        }
        for &(index, choice, [weight, _]) in rays.iter().filter(|it| it.1 < 1.0 - EVEN) {
            asked.count(index, !is_left_out, || {
                let [weight, choice] = [weight, choice].map(short);
                let words = format!("counts {weight}, as rays do that were chosen for certain, and was chosen with the probability {choice}");
                (words, [("choice-missing", true)])
            });
        }
    }
}

pub fn is_finite(color: Rgb) -> bool {
    color.to_array().iter().all(|x| x.is_finite())
}

/// Whether two colours are the same but for this relative error of the larger channel.
pub fn is_near(a: Rgb, b: Rgb, tolerance: f64) -> bool {
    let size =
        |color: Rgb| color.to_array().into_iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    size(a - b) <= tolerance * size(a).max(size(b))
}
