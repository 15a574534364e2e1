//! Mistakes of shading and of scattering at opaque surfaces (Suffern, ch. 13–15, 24, 25): changed values of terms.

use std::f64::consts::PI;

use groundtruth::lobes::Lobe;
use groundtruth::math::{Normal, Vector, power};
use groundtruth::rgb::Rgb;
use groundtruth::trace::TermSource;

use super::{How, Mistake, ObservedTerm};

const OF_HALF_VECTOR: Mistake =
    Mistake::term("highlight-of-half-vector", |term| with_highlight(term, half_vector));

pub(super) const ALL: &[Mistake] = &[
    Mistake::term("lambertian-without-pi", |term| match term.direct() {
        Some((Lobe::Lambertian(_), _)) => term.times(PI),
        _ => term.value(),
    }),
    Mistake::term("lambertian-pi-twice", |term| match term.direct() {
        Some((Lobe::Lambertian(_), _)) => term.times(1.0 / PI),
        _ => term.value(),
    }),
    Mistake::term("no-cosine", |term| {
        term.direct().map_or(term.value(), |(_, cos_i)| term.times(1.0 / cos_i))
    }),
    Mistake::term("cosine-of-viewer", cosine_of_viewer),
    Mistake::term("cosine-twice", |term| {
        term.direct().map_or(term.value(), |(_, cos_i)| term.times(cos_i))
    }),
    Mistake::term("no-highlight", |term| match term.direct() {
        Some((Lobe::GlossySpecular(_), _)) => Rgb::BLACK,
        _ => term.value(),
    }),
    Mistake::term("highlight-without-cosine", |term| match term.direct() {
        Some((Lobe::GlossySpecular(_), cos_i)) => term.times(1.0 / cos_i),
        _ => term.value(),
    }),
    Mistake::term("highlight-normalised", |term| match term.direct() {
        Some((Lobe::GlossySpecular(lobe), _)) => term.times((lobe.exponent + 2.0) / (2.0 * PI)),
        _ => term.value(),
    }),
    OF_HALF_VECTOR,
    OF_HALF_VECTOR.in_form(
        "with four times the exponent",
        How::Term(|term| with_highlight(term, |n, wo, wi| power(half_vector(n, wo, wi), 4.0))),
    ),
    Mistake::term("highlight-without-two", |term| {
        with_highlight(term, |n, wo, wi| times_mirrored(1.0, n, wo, wi))
    }),
    Mistake::term("sphere-normal-not-unit", sphere_normal_not_unit),
    Mistake::term("mirror-with-cosine", |term| match term.traced() {
        Some(Lobe::PerfectSpecular(_) | Lobe::FresnelReflector(_)) => {
            term.times(cosine_of_ray(term))
        }
        _ => term.value(),
    }),
    Mistake::term("mirror-without-kr", |term| match term.term.source {
        TermSource::Traced {
            lobe: Lobe::PerfectSpecular(_), lobe_probability, survival, ..
        } => (1.0 / (lobe_probability * survival)) * term.arriving,
        _ => term.value(),
    }),
    Mistake::term("gloss-with-cosine", |term| match term.traced() {
        Some(Lobe::GlossyReflection(_)) => term.times(cosine_of_ray(term)),
        _ => term.value(),
    }),
    Mistake::term("gloss-without-density", |term| match term.term.source {
        TermSource::Traced { lobe: Lobe::GlossyReflection(_), pdf: Some(pdf), .. } => {
            term.times(pdf)
        }
        _ => term.value(),
    }),
];

fn cosine_of_viewer(term: &ObservedTerm<'_>) -> Rgb {
    match (term.direct(), &term.ray.surface) {
        (Some((_, cos_i)), Some(surface)) => {
            term.times(surface.normals.shading.dot(surface.wo).max(0.0) / cos_i)
        }
        _ => term.value(),
    }
}

fn cosine_of_ray(term: &ObservedTerm<'_>) -> f64 {
    term.cosine_of_ray().map_or(1.0, f64::abs)
}

/// The value of a term of direct light, with another cosine in the place of `r·ω_o`, of `n`, `ω_o` and `ω_i`.
///
/// Where `r·ω_o` is negative, our highlight is black and no term of it is heard, but the other may not be. So it is added
/// to the Lambertian term, which comes first; materials without one lack that part of the highlight.
fn with_highlight(term: &ObservedTerm<'_>, other: impl Fn(Normal, Vector, Vector) -> f64) -> Rgb {
    let (Some((lobe, _)), Some(surface)) = (term.direct(), &term.ray.surface) else {
        return term.value();
    };
    let Some(wi) = term.to_light() else { return term.value() };
    let (n, wo) = (surface.normals.shading, surface.wo);
    let (right, wrong) = (times_mirrored(2.0, n, wo, wi), other(n, wo, wi).max(0.0));
    let highlights = surface.lobes.iter().find_map(|(lobe, _)| match lobe {
        Lobe::GlossySpecular(highlight) => Some(highlight),
        _ => None,
    });
    match (lobe, highlights) {
        (Lobe::GlossySpecular(highlight), _) if right > 0.0 => {
            term.times(power(wrong / right, highlight.exponent))
        }
        (Lobe::Lambertian(matte), Some(highlight)) if right <= 0.0 => {
            let f = PI * power(wrong, highlight.exponent);
            let ratio = |specular: f64, diffuse: f64| specular * f / diffuse;
            let [specular, diffuse] = [highlight.reflectance, matte.reflectance].map(Rgb::to_array);
            let value = term.value().to_array();
            let with_highlight = |i: usize| match diffuse[i] > 0.0 {
                true => value[i] * (1.0 + ratio(specular[i], diffuse[i])),
                false => value[i],
            };
            Rgb::new(with_highlight(0), with_highlight(1), with_highlight(2))
        }
        _ => term.value(),
    }
}

/// `(k (n·ω_i) n − ω_i)·ω_o`, which is `r·ω_o` for `k = 2`.
fn times_mirrored(k: f64, n: Normal, wo: Vector, wi: Vector) -> f64 {
    (k * n.dot(wi)) * n.dot(wo) - wi.dot(wo)
}

fn half_vector(n: Normal, wo: Vector, wi: Vector) -> f64 {
    Vector::unit(wi + wo).map_or(0.0, |half| n.dot(half).max(0.0))
}

/// A normal `r n` has `r` times the cosine, and is twice in the mirror direction.
fn sphere_normal_not_unit(term: &ObservedTerm<'_>) -> Rgb {
    let radius = term.ray.surface.as_ref().and_then(|surface| surface.radius);
    match radius.filter(|_| term.direct().is_some()) {
        Some(r) => {
            let k = 2.0 * r * r;
            r * with_highlight(term, |n, wo, wi| times_mirrored(k, n, wo, wi))
        }
        None => term.value(),
    }
}
