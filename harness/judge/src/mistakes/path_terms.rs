//! Mistakes of path tracers (Suffern, ch. 26): changed values of terms.

use std::f64::consts::PI;

use groundtruth::lobes::Lobe;
use groundtruth::rgb::Rgb;
use groundtruth::trace::TermSource;

use super::{Mistake, ObservedTerm};

/// By Veach's balance heuristic, from the weight by the power heuristic.
fn balanced(mis: f64) -> f64 {
    1.0 / (mis + (mis * (1.0 - mis)).sqrt())
}

/// The weight of the other way to find the same light.
fn others(mis: f64) -> f64 {
    (1.0 - mis) / mis
}

/// What becomes of the weights of lights that are sampled.
fn of_samples(term: &ObservedTerm<'_>, factor: fn(f64) -> f64) -> Option<f64> {
    let TermSource::Direct { mis, .. } = term.term.source else { return None };
    mis.filter(|mis| *mis > 0.0).map(factor)
}

/// The same of lights that paths hit.
fn of_hits(term: &ObservedTerm<'_>, factor: fn(f64) -> f64) -> Option<f64> {
    let (TermSource::Emission { mis } | TermSource::Background { mis }) = term.term.source else {
        return None;
    };
    mis.filter(|mis| *mis > 0.0).map(factor)
}

pub(super) const ALL: &[Mistake] = &[
    Mistake::term("light-counted-twice", light_counted_twice),
    Mistake::term("light-counted-twice", |term| {
        term.direct().and_then(|_| light_counted_twice(term))
    })
    .in_form("in full where they are sampled alone"),
    Mistake::term("light-counted-twice", |term| {
        light_counted_twice(term).filter(|_| term.direct().is_none())
    })
    .in_form("in full where a path hits them alone"),
    Mistake::factor("mis-two-heuristics", |term| of_samples(term, balanced)),
    Mistake::factor("mis-two-heuristics", |term| of_hits(term, balanced))
        .in_form("the other way round"),
    Mistake::factor("mis-other-weight", |term| of_samples(term, others)),
    Mistake::factor("mis-other-weight", |term| of_hits(term, others))
        .in_form("or where a path hits them"),
    Mistake::factor("path-cosine-twice", cosine),
    Mistake::factor("path-cosine-twice", |term| Some(2.0 * cosine(term)?))
        .in_form("with the density 1/2π of even directions"),
    Mistake::term("path-without-reflectance", |term| term.unweighed().filter(|_| is_diffuse(term))),
    Mistake::factor("path-without-density", |term| term.density().filter(|_| is_diffuse(term))),
    Mistake::factor("path-pi-twice", |term| is_diffuse(term).then_some(1.0 / PI)),
    Mistake::factor("choice-not-compensated", |term| match term.term.source {
        TermSource::Traced { lobe_probability, .. } => Some(lobe_probability),
        _ => None,
    }),
    Mistake::factor("roulette-not-compensated", |term| match term.term.source {
        TermSource::Traced { survival, .. } => Some(survival),
        _ => None,
    }),
];

/// Whether a Lambertian lobe sent the ray along which the light arrives.
fn is_diffuse(term: &ObservedTerm<'_>) -> bool {
    matches!(term.traced(), Some(Lobe::Lambertian(_)))
}

/// Of the angle of such a ray.
fn cosine(term: &ObservedTerm<'_>) -> Option<f64> {
    term.cosine_of_ray().filter(|_| is_diffuse(term))
}

/// Takes off the weights by which sampled lights and paths that hit them share the same light.
fn light_counted_twice(term: &ObservedTerm<'_>) -> Option<Rgb> {
    match term.term.source {
        TermSource::Emission { mis: Some(_) } | TermSource::Background { mis: Some(_) } => {
            Some(term.arriving)
        }
        TermSource::Direct { f, cos_i, pdf, mis: Some(_), .. } => {
            Some(((cos_i / pdf.unwrap_or(1.0)) * f) * term.arriving)
        }
        _ => None,
    }
}
