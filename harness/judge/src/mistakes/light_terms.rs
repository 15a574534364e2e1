//! Mistakes of lights and of samples (Suffern, ch. 4, 14, 18, 24): changed values of terms.

use std::f64::consts::PI;

use groundtruth::rgb::Rgb;
use groundtruth::trace::{RayKind, TermSource};

use super::observed::LampHeard;
use super::{How, Mistake, ObservedRay, ObservedTerm};

const NO_DISTANCE: Mistake = Mistake::term("no-lamp-distance", |term| {
    term.lamp().map_or(term.value(), |lamp| term.times(lamp.distance_squared))
});

pub(super) const ALL: &[Mistake] = &[
    Mistake::ray("last-sample-left-out", |ray| {
        if ray.is_last_sample { Rgb::BLACK } else { ray.arriving() }
    }),
    Mistake::term("no-ambient", |term| ambient(term, |_| 0.0)),
    Mistake::term("ambient-for-each-light", |term| {
        ambient(term, |term| {
            let lights = term.world.lights.iter().filter(|light| !light.light.is_ambient());
            lights.count() as f64
        })
    }),
    Mistake::term("ambient-over-pi", |term| ambient(term, |_| 1.0 / PI)),
    Mistake::ray("sample-max-to-one", sample_max_to_one),
    Mistake::term("lamps-unseen", |term| emission(term, |kind| kind == RayKind::Camera)),
    Mistake::term("lamps-unseen-in-mirrors", |term| emission(term, |kind| kind != RayKind::Camera)),
    Mistake::term("no-background-in-mirrors", |term| match term.term.source {
        TermSource::Background { .. } if term.ray.kind != RayKind::Camera => Rgb::BLACK,
        _ => term.value(),
    }),
    Mistake::term("no-lamp-cosine", |term| {
        term.lamp().map_or(term.value(), |lamp| term.times(1.0 / lamp.cosine))
    }),
    Mistake::term("lamp-cosine-twice", |term| {
        term.lamp().map_or(term.value(), |lamp| term.times(lamp.cosine))
    }),
    NO_DISTANCE,
    NO_DISTANCE.in_form(
        "but has 1/d",
        How::Term(|term| {
            term.lamp().map_or(term.value(), |lamp| term.times(lamp.distance_squared.sqrt()))
        }),
    ),
    NO_DISTANCE.in_form(
        "and the cosine at the lamp",
        How::Term(|term| {
            let factor = |lamp: LampHeard| term.times(lamp.distance_squared / lamp.cosine);
            term.lamp().map_or(term.value(), factor)
        }),
    ),
    Mistake::term("lamp-of-receiver", lamp_of_receiver),
    Mistake::term("last-light-sample-left-out", |term| match term.term.source {
        TermSource::Direct { pdf: Some(_), .. } if term.is_last_sample => Rgb::BLACK,
        _ => term.value(),
    }),
];

/// The value of a term, black if it is emission that arrives along rays of this kind.
fn emission(term: &ObservedTerm<'_>, is_black: impl Fn(RayKind) -> bool) -> Rgb {
    match term.term.source {
        TermSource::Emission { .. } if is_black(term.ray.kind) => Rgb::BLACK,
        _ => term.value(),
    }
}

/// The value of an ambient term times a factor.
fn ambient(term: &ObservedTerm<'_>, factor: impl Fn(&ObservedTerm<'_>) -> f64) -> Rgb {
    match term.term.source {
        TermSource::Ambient { .. } => term.times(factor(term)),
        _ => term.value(),
    }
}

fn sample_max_to_one(ray: &ObservedRay<'_>) -> Rgb {
    let arriving = ray.arriving();
    let largest = arriving.max();
    match ray.ray.kind {
        RayKind::Camera if largest > 1.0 => arriving / largest,
        _ => arriving,
    }
}

fn lamp_of_receiver(term: &ObservedTerm<'_>) -> Rgb {
    match (term.term.source, term.lamp()) {
        (TermSource::Direct { lobe: groundtruth::lobes::Lobe::Lambertian(matte), .. }, Some(_)) => {
            matte.reflectance * term.value()
        }
        _ => term.value(),
    }
}
