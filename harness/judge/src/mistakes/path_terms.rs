//! Mistakes of path tracers (Suffern, ch. 26): changed values of terms.

use std::f64::consts::PI;

use groundtruth::lobes::Lobe;
use groundtruth::rgb::Rgb;
use groundtruth::trace::TermSource;

use super::{How, Mistake, ObservedTerm};

const COSINE_TWICE: Mistake = Mistake::factor("path-cosine-twice", cosine);

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

const HEURISTICS: Mistake =
    Mistake::factor("mis-two-heuristics", |term| of_samples(term, balanced));

const OTHER_WEIGHT: Mistake = Mistake::factor("mis-other-weight", |term| of_samples(term, others));

const COUNTED_TWICE: Mistake = Mistake::term("light-counted-twice", light_counted_twice);

pub(super) const ALL: &[Mistake] = &[
    COUNTED_TWICE,
    COUNTED_TWICE.in_form(
        "in full where they are sampled alone",
        How::Term(|term| term.direct().and_then(|_| light_counted_twice(term))),
    ),
    COUNTED_TWICE.in_form(
        "in full where a path hits them alone",
        How::Term(|term| match term.direct() {
            Some(_) => None,
            None => light_counted_twice(term),
        }),
    ),
    HEURISTICS,
    HEURISTICS.in_form("the other way round", How::Factor(|term| of_hits(term, balanced))),
    OTHER_WEIGHT,
    OTHER_WEIGHT.in_form("or where a path hits them", How::Factor(|term| of_hits(term, others))),
    COSINE_TWICE,
    COSINE_TWICE.in_form(
        "with the density 1/2π of even directions",
        How::Factor(|term| Some(2.0 * cosine(term)?)),
    ),
    Mistake::term("path-without-reflectance", |term| {
        is_diffuse(term).then(|| term.unweighed()).flatten()
    }),
    Mistake::factor("path-without-density", |term| {
        is_diffuse(term).then(|| term.density()).flatten()
    }),
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
    is_diffuse(term).then(|| term.cosine_of_ray()).flatten()
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
