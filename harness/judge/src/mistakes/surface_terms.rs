//! Mistakes of shading and of scattering at opaque surfaces (Suffern, ch. 13–15, 24, 25): changed values of terms.

use std::f64::consts::PI;

use groundtruth::lobes::Lobe;
use groundtruth::math::{Vector, power};
use groundtruth::rgb::Rgb;
use groundtruth::trace::TermSource;

use super::{Mistake, ObservedTerm, known};

pub(super) const ALL: &[Mistake] = &[
    Mistake::term(&known::LAMBERTIAN_WITHOUT_PI, |term| match term.direct() {
        Some((Lobe::Lambertian(_), _)) => term.times(PI),
        _ => term.value(),
    }),
    Mistake::term(&known::LAMBERTIAN_PI_TWICE, |term| match term.direct() {
        Some((Lobe::Lambertian(_), _)) => term.times(1.0 / PI),
        _ => term.value(),
    }),
    Mistake::term(&known::NO_COSINE, |term| {
        term.direct().map_or(term.value(), |(_, cos_i)| term.times(1.0 / cos_i))
    }),
    Mistake::term(&known::COSINE_OF_VIEWER, cosine_of_viewer),
    Mistake::term(&known::COSINE_TWICE, |term| {
        term.direct().map_or(term.value(), |(_, cos_i)| term.times(cos_i))
    }),
    Mistake::term(&known::NO_HIGHLIGHT, |term| match term.direct() {
        Some((Lobe::GlossySpecular(_), _)) => Rgb::BLACK,
        _ => term.value(),
    }),
    Mistake::term(&known::HIGHLIGHT_WITHOUT_COSINE, |term| match term.direct() {
        Some((Lobe::GlossySpecular(_), cos_i)) => term.times(1.0 / cos_i),
        _ => term.value(),
    }),
    Mistake::term(&known::HIGHLIGHT_NORMALISED, |term| match term.direct() {
        Some((Lobe::GlossySpecular(lobe), _)) => term.times((lobe.exponent + 2.0) / (2.0 * PI)),
        _ => term.value(),
    }),
    Mistake::term(&known::HIGHLIGHT_OF_HALF_VECTOR, highlight_of_half_vector),
    Mistake::term(&known::MIRROR_WITH_COSINE, |term| match term.traced() {
        Some(Lobe::PerfectSpecular(_) | Lobe::FresnelReflector(_)) => {
            term.times(cosine_of_ray(term))
        }
        _ => term.value(),
    }),
    Mistake::term(&known::MIRROR_WITHOUT_KR, |term| match term.term.source {
        TermSource::Traced {
            lobe: Lobe::PerfectSpecular(_), lobe_probability, survival, ..
        } => (1.0 / (lobe_probability * survival)) * term.arriving,
        _ => term.value(),
    }),
    Mistake::term(&known::GLOSS_WITH_COSINE, |term| match term.traced() {
        Some(Lobe::GlossyReflection(_)) => term.times(cosine_of_ray(term)),
        _ => term.value(),
    }),
    Mistake::term(&known::GLOSS_WITHOUT_DENSITY, |term| match term.term.source {
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

/// Where `r·ω_o` is negative, our highlight is black and no term of it is heard, but Blinn's may not be. So it is added
/// to the Lambertian term, which comes first; materials without one lack that part of Blinn's highlight.
fn highlight_of_half_vector(term: &ObservedTerm<'_>) -> Rgb {
    let (Some((lobe, _)), Some(surface)) = (term.direct(), &term.ray.surface) else {
        return term.value();
    };
    let Some(wi) = term.to_light() else { return term.value() };
    let (n, wo) = (surface.normals.shading, surface.wo);
    let half = Vector::unit(wi + wo).map_or(0.0, |half| n.dot(half).max(0.0));
    let mirrored = (2.0 * n.dot(wi)) * n - wi;
    let cosine = mirrored.dot(wo);
    let highlights = surface.lobes.iter().find_map(|(lobe, _)| match lobe {
        Lobe::GlossySpecular(highlight) => Some(highlight),
        _ => None,
    });
    match (lobe, highlights) {
        (Lobe::GlossySpecular(highlight), _) if cosine > 0.0 => {
            term.times(power(half / cosine, highlight.exponent))
        }
        (Lobe::Lambertian(matte), Some(highlight)) if cosine <= 0.0 => {
            let f = PI * power(half, highlight.exponent);
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
