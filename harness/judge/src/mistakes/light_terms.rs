//! Mistakes of lights and of samples (Suffern, ch. 4, 14, 18, 24): changed values of terms.

use std::f64::consts::PI;

use groundtruth::lobes::Lobe;
use groundtruth::rgb::Rgb;
use groundtruth::trace::{RayKind, TermSource};

use super::{Mistake, ObservedTerm};

pub(super) const ALL: &[Mistake] = &[
    Mistake::ray("last-sample-left-out", |ray| {
        if ray.ray.is_last_sample { Rgb::BLACK } else { ray.arriving() }
    }),
    Mistake::factor("no-ambient", |term| is_ambient(term).then_some(0.0)),
    Mistake::factor("ambient-for-each-light", |term| {
        let lights = term.world.lights.iter().filter(|light| !light.light.is_ambient());
        is_ambient(term).then(|| lights.count() as f64)
    }),
    Mistake::factor("ambient-over-pi", |term| is_ambient(term).then_some(1.0 / PI)),
    Mistake::ray("sample-max-to-one", |ray| {
        let (arriving, is_whole) = (ray.arriving(), ray.ray.kind == RayKind::Camera);
        if is_whole && arriving.max() > 1.0 { arriving / arriving.max() } else { arriving }
    }),
    Mistake::factor("lamps-unseen", |term| {
        (is_emission(term) && term.ray.kind == RayKind::Camera).then_some(0.0)
    }),
    Mistake::factor("lamps-unseen-in-mirrors", |term| {
        (is_emission(term) && term.ray.kind != RayKind::Camera).then_some(0.0)
    }),
    Mistake::factor("no-background-in-mirrors", |term| match term.term.source {
        TermSource::Background { .. } if term.ray.kind != RayKind::Camera => Some(0.0),
        _ => None,
    }),
    Mistake::factor("no-lamp-cosine", |term| Some(1.0 / term.lamp()?.cosine)),
    Mistake::factor("lamp-cosine-twice", |term| Some(term.lamp()?.cosine)),
    Mistake::factor("no-lamp-distance", |term| Some(term.lamp()?.distance_squared)),
    Mistake::factor("no-lamp-distance", |term| Some(term.lamp()?.distance_squared.sqrt()))
        .in_form("but has 1/d"),
    Mistake::factor("no-lamp-distance", |term| {
        term.lamp().map(|lamp| lamp.distance_squared / lamp.cosine)
    })
    .in_form("and the cosine at the lamp"),
    Mistake::term("lamp-of-receiver", |term| match term.direct()? {
        (Lobe::Lambertian(matte), _) => term.lamp().map(|_| matte.reflectance * term.value()),
        _ => None,
    }),
    Mistake::factor("last-light-sample-left-out", |term| match term.term.source {
        TermSource::Direct { pdf: Some(_), .. } if term.ray.is_last_sample => Some(0.0),
        _ => None,
    }),
];

fn is_emission(term: &ObservedTerm<'_>) -> bool {
    matches!(term.term.source, TermSource::Emission { .. })
}

fn is_ambient(term: &ObservedTerm<'_>) -> bool {
    matches!(term.term.source, TermSource::Ambient { .. })
}
