//! Mistakes of shading and of scattering at surfaces (Suffern, ch. 13–15, 24, 25, 27, 28): changed values of terms.

use std::f64::consts::PI;

use groundtruth::lobes::{Fresnel, Lobe, fresnel, polarised};
use groundtruth::math::{Vector, power};
use groundtruth::rgb::Rgb;
use groundtruth::trace::TermSource;

use super::{Mistake, RayHeard, TermHeard};

pub(super) const ALL: &[Mistake] = &[
    Mistake::term(
        13,
        "lambertian-without-pi",
        "direct light that a Lambertian BRDF reflects lacks 1/π",
        |term| match term.direct() {
            Some((Lobe::Lambertian(_), _)) => term.times(PI),
            _ => term.value(),
        },
    ),
    Mistake::term(
        14,
        "no-cosine",
        "direct light lacks the cosine of its angle to the normal",
        |term| term.direct().map_or(term.value(), |(_, cos_i)| term.times(1.0 / cos_i)),
    ),
    Mistake::term(
        14,
        "cosine-of-viewer",
        "direct light has the cosine of the viewer's angle instead of the light's",
        cosine_of_viewer,
    ),
    Mistake::term(
        14,
        "cosine-twice",
        "direct light has the cosine of its angle to the normal twice",
        |term| term.direct().map_or(term.value(), |(_, cos_i)| term.times(cos_i)),
    ),
    Mistake::term(
        15,
        "highlight-without-cosine",
        "highlights lack the cosine of the light's angle to the normal",
        |term| match term.direct() {
            Some((Lobe::GlossySpecular(_), cos_i)) => term.times(1.0 / cos_i),
            _ => term.value(),
        },
    ),
    Mistake::term(15, "highlight-normalised", "highlights are multiplied by (e + 2)/2π", |term| {
        match term.direct() {
            Some((Lobe::GlossySpecular(lobe), _)) => term.times((lobe.exponent + 2.0) / (2.0 * PI)),
            _ => term.value(),
        }
    }),
    Mistake::term(
        15,
        "highlight-of-half-vector",
        "highlights are (n·h)^e of the half vector (Blinn) instead of (r·ω_o)^e",
        highlight_of_half_vector,
    ),
    Mistake::term(
        24,
        "mirror-with-cosine",
        "light from a mirror direction is multiplied by the cosine of its angle to the normal",
        |term| match term.traced() {
            Some(Lobe::PerfectSpecular(_) | Lobe::FresnelReflector(_)) => {
                term.times(cosine_of_ray(term))
            }
            _ => term.value(),
        },
    ),
    Mistake::term(
        25,
        "gloss-with-cosine",
        "glossy reflection has the cosine of the ray's angle in f cos θ, but not in the density",
        |term| match term.traced() {
            Some(Lobe::GlossyReflection(_)) => term.times(cosine_of_ray(term)),
            _ => term.value(),
        },
    ),
    Mistake::term(
        25,
        "gloss-without-density",
        "the rays of glossy reflection count f cos θ, not divided by their density",
        |term| match term.term.source {
            TermSource::Traced { lobe: Lobe::GlossyReflection(_), pdf: Some(pdf), .. } => {
                term.times(pdf)
            }
            _ => term.value(),
        },
    ),
    Mistake::term(27, "no-eta-squared", "transmitted radiance lacks 1/η²", |term| {
        refracted(term).map_or(term.value(), |eta| term.times(eta * eta))
    }),
    Mistake::term(
        27,
        "eta-squared-inverted",
        "transmitted radiance is multiplied by η² instead of 1/η²",
        |term| refracted(term).map_or(term.value(), |eta| term.times((eta * eta) * (eta * eta))),
    ),
    Mistake::term(27, "total-reflection-black", "total internal reflection is black", |term| {
        match term.traced() {
            Some(Lobe::PerfectSpecular(_) | Lobe::FresnelReflector(_)) if is_total(term) => {
                Rgb::BLACK
            }
            _ => term.value(),
        }
    }),
    Mistake::term(
        28,
        "schlick",
        "Fresnel's equations are replaced by Schlick's approximation",
        |term| with_fresnel(term, |cos_i, eta| shares(schlick(cos_i, eta))),
    ),
    Mistake::term(
        28,
        "fresnel-swapped",
        "the reflected and the transmitted share of Fresnel's equations are exchanged",
        |term| {
            with_fresnel(term, |cos_i, eta| {
                let Fresnel { reflected, transmitted } = fresnel(cos_i, eta);
                Fresnel { reflected: transmitted, transmitted: reflected }
            })
        },
    ),
    Mistake::term(
        28,
        "fresnel-perpendicular-only",
        "only perpendicular polarisation counts in Fresnel's equations",
        |term| with_fresnel(term, |cos_i, eta| polarised(cos_i, eta).s),
    ),
    Mistake::ray(28, "no-absorption", "media do not absorb light", |ray| ray.sum),
    Mistake::ray(
        28,
        "absorption-without-distance",
        "media absorb the same share of light over any distance, that of a unit length",
        absorption_without_distance,
    ),
];

fn cosine_of_viewer(term: &TermHeard<'_>) -> Rgb {
    match (term.direct(), &term.ray.surface) {
        (Some((_, cos_i)), Some(surface)) => {
            term.times(surface.normals.shading.dot(surface.wo).max(0.0) / cos_i)
        }
        _ => term.value(),
    }
}

fn cosine_of_ray(term: &TermHeard<'_>) -> f64 {
    term.cosine_of_ray().map_or(1.0, f64::abs)
}

/// Where `r·ω_o` is negative, our highlight is black and no term of it is heard, but Blinn's may not be. So it is added
/// to the Lambertian term, which comes first; materials without one lack that part of Blinn's highlight.
fn highlight_of_half_vector(term: &TermHeard<'_>) -> Rgb {
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

/// The index behind the surface over the one in front of it, of a term that was refracted.
fn refracted(term: &TermHeard<'_>) -> Option<f64> {
    match term.traced()? {
        Lobe::PerfectTransmitter(_) | Lobe::FresnelTransmitter(_) => {
            term.ray.surface.as_ref()?.eta()
        }
        _ => None,
    }
}

/// Whether the term leaves a surface on which the viewer sees total internal reflection.
fn is_total(term: &TermHeard<'_>) -> bool {
    term.ray.surface.as_ref().is_some_and(|surface| surface.reflects_totally())
}

/// The value of a term with other shares than Fresnel's. Total internal reflection stays as it is.
fn with_fresnel(term: &TermHeard<'_>, shares: impl Fn(f64, f64) -> Fresnel) -> Rgb {
    let (Some(lobe), Some(surface)) = (term.traced(), &term.ray.surface) else {
        return term.value();
    };
    let Some(eta) = surface.eta().filter(|_| !surface.reflects_totally()) else {
        return term.value();
    };
    let cos_i = surface.cos_o().abs();
    let (right, wrong) = (fresnel(cos_i, eta), shares(cos_i, eta));
    match lobe {
        Lobe::FresnelReflector(_) => term.times(wrong.reflected / right.reflected),
        Lobe::FresnelTransmitter(_) => term.times(wrong.transmitted / right.transmitted),
        _ => term.value(),
    }
}

fn shares(reflected: f64) -> Fresnel {
    Fresnel { reflected, transmitted: 1.0 - reflected }
}

/// `R₀ + (1 − R₀)(1 − cosθ)⁵` (Schlick 1994), with the angle on the side of the viewer.
fn schlick(cos_i: f64, eta: f64) -> f64 {
    let root = (eta - 1.0) / (eta + 1.0);
    let r0 = root * root;
    r0 + (1.0 - r0) * power(1.0 - cos_i.min(1.0), 5.0)
}

/// `c_f` instead of `c_f^t`.
fn absorption_without_distance(ray: &RayHeard<'_>) -> Rgb {
    match &ray.ray.surface {
        Some(surface) => ray.transmittance.powc(1.0 / surface.t) * ray.sum,
        None => ray.arriving(),
    }
}
