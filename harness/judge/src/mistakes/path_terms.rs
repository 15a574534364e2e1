//! Mistakes of path tracers (Suffern, ch. 26): changed values of terms.

use std::f64::consts::PI;

use groundtruth::lobes::Lobe;
use groundtruth::rgb::Rgb;
use groundtruth::trace::TermSource;

use super::{How, Mistake, ObservedTerm};

const COSINE_TWICE: Mistake = Mistake::term("path-cosine-twice", |term| match term.traced() {
    Some(Lobe::Lambertian(_)) => term.times(cosine(term)),
    _ => term.value(),
});

const COUNTED_TWICE: Mistake = Mistake::term("light-counted-twice", light_counted_twice);

pub(super) const ALL: &[Mistake] = &[
    COUNTED_TWICE,
    COUNTED_TWICE.in_form(
        "in full where they are sampled alone",
        How::Term(|term| match term.term.source {
            TermSource::Direct { .. } => light_counted_twice(term),
            _ => term.value(),
        }),
    ),
    COUNTED_TWICE.in_form(
        "in full where a path hits them alone",
        How::Term(|term| match term.term.source {
            TermSource::Direct { .. } => term.value(),
            _ => light_counted_twice(term),
        }),
    ),
    COSINE_TWICE,
    COSINE_TWICE.in_form(
        "with the density 1/2π of even directions",
        How::Term(|term| match term.traced() {
            Some(Lobe::Lambertian(_)) => term.times(2.0 * cosine(term)),
            _ => term.value(),
        }),
    ),
    Mistake::term("path-without-reflectance", |term| match term.term.source {
        TermSource::Traced { lobe: Lobe::Lambertian(_), lobe_probability, survival, .. } => {
            (1.0 / (lobe_probability * survival)) * term.arriving
        }
        _ => term.value(),
    }),
    Mistake::term("path-without-density", |term| match term.term.source {
        TermSource::Traced { lobe: Lobe::Lambertian(_), pdf: Some(pdf), .. } => term.times(pdf),
        _ => term.value(),
    }),
    Mistake::term("path-pi-twice", |term| match term.traced() {
        Some(Lobe::Lambertian(_)) => term.times(1.0 / PI),
        _ => term.value(),
    }),
    Mistake::term("choice-not-compensated", |term| match term.term.source {
        TermSource::Traced { lobe_probability, .. } => term.times(lobe_probability),
        _ => term.value(),
    }),
    Mistake::term("roulette-not-compensated", |term| match term.term.source {
        TermSource::Traced { survival, .. } => term.times(survival),
        _ => term.value(),
    }),
];

/// Of the angle of the ray along which the light arrives.
fn cosine(term: &ObservedTerm<'_>) -> f64 {
    term.cosine_of_ray().map_or(1.0, f64::abs)
}

/// Takes off the weights by which sampled lights and paths that hit them share the same light.
fn light_counted_twice(term: &ObservedTerm<'_>) -> Rgb {
    match term.term.source {
        TermSource::Emission { mis: Some(_) } | TermSource::Background { mis: Some(_) } => {
            term.arriving
        }
        TermSource::Direct { f, cos_i, pdf, mis: Some(_), .. } => {
            ((cos_i / pdf.unwrap_or(1.0)) * f) * term.arriving
        }
        _ => term.value(),
    }
}
