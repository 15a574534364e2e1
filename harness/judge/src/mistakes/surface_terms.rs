//! Mistakes of shading and of scattering at opaque surfaces (Suffern, ch. 13–15, 24, 25): changed values of terms.

use std::f64::consts::PI;

use groundtruth::lobes::{Lobe, Normals};
use groundtruth::math::{Normal, Ray, Vector, power};
use groundtruth::rgb::Rgb;
use groundtruth::trace;

use super::glass_terms::is_mirrored;
use super::{Mistake, ObservedTerm};

pub(super) const ALL: &[Mistake] = &[
    Mistake::factor("lambertian-without-pi", |term| diffuse(term).map(|_| PI)),
    Mistake::factor("lambertian-pi-twice", |term| diffuse(term).map(|_| 1.0 / PI)),
    Mistake::factor("no-cosine", |term| Some(1.0 / term.direct()?.1)),
    Mistake::factor("cosine-of-viewer", |term| {
        let ((_, cos_i), surface) = (term.direct()?, term.ray.surface.as_ref()?);
        Some(surface.normals.shading.dot(surface.wo).max(0.0) / cos_i)
    }),
    Mistake::factor("cosine-twice", |term| Some(term.direct()?.1)),
    Mistake::factor("no-highlight", |term| highlight(term).map(|_| 0.0)),
    Mistake::factor("highlight-without-cosine", |term| Some(1.0 / highlight(term)?.1)),
    Mistake::factor("highlight-normalised", |term| Some((highlight(term)?.0 + 2.0) / (2.0 * PI))),
    Mistake::term("highlight-of-half-vector", |term| with_highlight(term, half_vector)),
    Mistake::term("highlight-of-half-vector", |term| {
        with_highlight(term, |n, wo, wi| power(half_vector(n, wo, wi), 4.0))
    })
    .in_form("with four times the exponent"),
    Mistake::term("highlight-without-two", |term| {
        with_highlight(term, |n, wo, wi| times_mirrored(1.0, n, wo, wi))
    }),
    Mistake::term("sphere-normal-not-unit", sphere_normal_not_unit),
    Mistake::term("terminator-lit", |term| {
        let (sample, surface) = (term.single_sample()?, term.ray.surface.as_ref()?);
        let is_behind = surface.normals.geometry.dot(sample.direction) <= 0.0;
        (is_behind && term.arriving.is_black()).then(|| term.term.weight * sample.radiance)
    }),
    Mistake::factor("mirror-with-cosine", |term| {
        term.cosine_of_ray().filter(|_| is_mirrored(term))
    }),
    Mistake::term("mirror-without-two", mirrored_once),
    Mistake::term("mirror-without-kr", |term| match term.traced()? {
        Lobe::PerfectSpecular(_) => term.unweighed(),
        _ => None,
    }),
    Mistake::factor("gloss-with-cosine", |term| match term.traced()? {
        Lobe::GlossyReflection(_) => term.cosine_of_ray(),
        _ => None,
    }),
    Mistake::factor("gloss-without-density", |term| match term.traced()? {
        Lobe::GlossyReflection(_) => term.density(),
        _ => None,
    }),
];

/// The cosine of direct light that a Lambertian lobe scatters.
fn diffuse(term: &ObservedTerm<'_>) -> Option<f64> {
    let (lobe, cos_i) = term.direct()?;
    matches!(lobe, Lobe::Lambertian(_)).then_some(cos_i)
}

/// The exponent of the highlight of direct light, and the cosine of that light.
fn highlight(term: &ObservedTerm<'_>) -> Option<(f64, f64)> {
    let (Lobe::GlossySpecular(lobe), cos_i) = term.direct()? else { return None };
    Some((lobe.exponent, cos_i))
}

/// The value of a term of direct light, with another cosine in the place of `r·ω_o`, of `n`, `ω_o` and `ω_i`.
///
/// Where `r·ω_o` is negative, our highlight is black and no term of it is heard, but the other may not be. So it is added
/// to the Lambertian term, which comes first; materials without one lack that part of the highlight.
fn with_highlight(
    term: &ObservedTerm<'_>,
    other: impl Fn(Normal, Vector, Vector) -> f64,
) -> Option<Rgb> {
    let ((lobe, _), surface) = (term.direct()?, term.ray.surface.as_ref()?);
    let wi = term.light_direction()?;
    let (n, wo) = (surface.normals.shading, surface.wo);
    let (right, wrong) = (times_mirrored(2.0, n, wo, wi), other(n, wo, wi).max(0.0));
    let highlights = surface.lobes.iter().find_map(|(lobe, _)| match lobe {
        Lobe::GlossySpecular(highlight) => Some(highlight),
        _ => None,
    });
    match (lobe, highlights) {
        (Lobe::GlossySpecular(highlight), _) if right > 0.0 => {
            Some(term.times(power(wrong / right, highlight.exponent)))
        }
        (Lobe::Lambertian(matte), Some(highlight)) if right <= 0.0 => {
            let f = PI * power(wrong, highlight.exponent);
            let ratio = |specular: f64, diffuse: f64| specular * f / diffuse;
            let [specular, diffuse] = [highlight.reflectance, matte.reflectance].map(Rgb::to_array);
            let value = term.value().to_array();
            Some(Rgb::from([0, 1, 2].map(|i| match diffuse[i] > 0.0 {
                true => value[i] * (1.0 + ratio(specular[i], diffuse[i])),
                false => value[i],
            })))
        }
        _ => None,
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
fn sphere_normal_not_unit(term: &ObservedTerm<'_>) -> Option<Rgb> {
    let _ = term.direct()?;
    let r = term.ray.surface.as_ref()?.radius?;
    let other = with_highlight(term, |n, wo, wi| times_mirrored(2.0 * r * r, n, wo, wi));
    Some(r * other.unwrap_or_else(|| term.value()))
}

/// What arrives at an opaque mirror from `(n·ω_o) n − ω_o`, along the surface, by a tree of rays that begins there.
fn mirrored_once(term: &ObservedTerm<'_>) -> Option<Rgb> {
    /// Above the surface by this share of the distance from the viewer.
    const ABOVE: f64 = 1e-9;
    // at the depth limit no ray is cast
    let (Some(Lobe::PerfectSpecular(_)), Some(_)) = (term.traced(), term.from) else { return None };
    let surface = term.ray.surface.as_ref().filter(|surface| surface.eta().is_none())?;
    let Normals { shading, geometry } = surface.normals;
    let along = (shading.dot(surface.wo) * shading - surface.wo).unit()?;
    // below an interpolated normal's surface, but not below a ball, which such a ray touches
    let side = if geometry.dot(along) < -1e-6 { -ABOVE } else { ABOVE };
    let ray = Ray::new(surface.point + (side * surface.t) * geometry, along);
    let draws = term.world.draws([0, 0], 0);
    Some(term.term.weight * trace::radiance(term.world, &ray, draws, &mut ()))
}
