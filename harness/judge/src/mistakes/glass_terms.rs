//! Mistakes of transparent surfaces and media (Suffern, ch. 27, 28): changed values of terms.

use groundtruth::lobes::{Fresnel, Lobe, fresnel, polarised};
use groundtruth::math::power;
use groundtruth::rgb::Rgb;
use groundtruth::trace::RayKind;

use super::{Mistake, ObservedRay, ObservedSurface, ObservedTerm};

pub(super) const ALL: &[Mistake] = &[
    Mistake::factor("no-eta-squared", |term| refracted(term).map(|eta| eta * eta)),
    Mistake::factor("eta-squared-inverted", |term| refracted(term).map(fourth)),
    Mistake::factor("total-reflection-black", |term| {
        (is_mirrored(term) && surface(term)?.reflects_totally()).then_some(0.0)
    }),
    Mistake::factor("glass-without-mirror", |term| {
        let surface = surface(term)?;
        let _ = surface.eta()?;
        (is_mirrored(term) && !surface.reflects_totally()).then_some(0.0)
    }),
    Mistake::factor("transmission-without-kt", |term| match term.traced()? {
        Lobe::PerfectTransmitter(lobe) => Some(1.0 / lobe.transmittance),
        _ => None,
    }),
    Mistake::term("eta-not-inverted", |term| {
        inside(term)?;
        with_fresnel(term, |cos_i, eta| fresnel(cos_i, 1.0 / eta))
    })
    .in_form("in Fresnel's equations alone"),
    Mistake::factor("eta-not-inverted", factor_inside).in_form("in the factor 1/η² alone"),
    Mistake::fresnel("schlick", |cos_i, eta| shares(schlick(cos_i, eta))),
    Mistake::fresnel("schlick", |cos_i, eta| shares(schlick(cosine_in_air(cos_i, eta), eta)))
        .in_form("with the larger of both angles"),
    Mistake::fresnel("fresnel-swapped", |cos_i, eta| {
        let Fresnel { reflected, transmitted } = fresnel(cos_i, eta);
        Fresnel { reflected: transmitted, transmitted: reflected }
    }),
    Mistake::fresnel("fresnel-perpendicular-only", |cos_i, eta| polarised(cos_i, eta).s),
    Mistake::fresnel("fresnel-parallel-only", |cos_i, eta| polarised(cos_i, eta).p),
    Mistake::fresnel("fresnel-without-half", |cos_i, eta| {
        shares((2.0 * fresnel(cos_i, eta).reflected).min(1.0))
    }),
    Mistake::fresnel("fresnel-transmits-all", |cos_i, eta| Fresnel {
        transmitted: 1.0,
        ..fresnel(cos_i, eta)
    }),
    Mistake::fresnel("fresnel-index-inverted", |cos_i, eta| fresnel(cos_i, 1.0 / eta)),
    Mistake::ray("no-absorption", |ray| ray.sum),
    Mistake::ray("no-absorption", |ray| not_along(ray, RayKind::Reflected))
        .in_form("along reflected rays"),
    Mistake::ray("no-absorption", |ray| not_along(ray, RayKind::Transmitted))
        .in_form("along transmitted rays"),
    Mistake::ray("no-absorption", |ray| not_along(ray, RayKind::Camera))
        .in_form("along the camera's rays"),
    Mistake::ray("absorption-without-distance", |ray| absorption_over(ray, |t| 1.0 / t)),
    Mistake::ray("absorption-twice", |ray| absorption_over(ray, |_| 2.0)),
];

fn fourth(x: f64) -> f64 {
    (x * x) * (x * x)
}

fn surface<'a>(term: &ObservedTerm<'a>) -> Option<&'a ObservedSurface> {
    term.ray.surface.as_ref()
}

/// The surface, if the viewer is inside.
fn inside<'a>(term: &ObservedTerm<'a>) -> Option<&'a ObservedSurface> {
    surface(term).filter(|surface| surface.cos_o() < 0.0)
}

/// The index behind the surface over the one in front of it, of a term that was refracted and has the factor 1/η².
fn refracted(term: &ObservedTerm<'_>) -> Option<f64> {
    match term.traced().filter(|_| term.world.transparency.scales_radiance)? {
        Lobe::PerfectTransmitter(_) | Lobe::FresnelTransmitter(_) => surface(term)?.eta(),
        _ => None,
    }
}

pub(super) fn is_mirrored(term: &ObservedTerm<'_>) -> bool {
    matches!(term.traced(), Some(Lobe::PerfectSpecular(_) | Lobe::FresnelReflector(_)))
}

/// The value of a term with other shares than Fresnel's. Total internal reflection stays as it is.
pub(super) fn with_fresnel(
    term: &ObservedTerm<'_>,
    shares: fn(f64, f64) -> Fresnel,
) -> Option<Rgb> {
    let surface = surface(term).filter(|surface| !surface.reflects_totally())?;
    let (cos_i, eta) = (surface.cos_o().abs(), surface.eta()?);
    with_share(term, [shares(cos_i, eta), fresnel(cos_i, eta)])
}

/// The value of a term with another share of its lobe than ours.
fn with_share(term: &ObservedTerm<'_>, [other, ours]: [Fresnel; 2]) -> Option<Rgb> {
    match term.traced()? {
        Lobe::FresnelReflector(_) => Some(term.times(other.reflected / ours.reflected)),
        Lobe::FresnelTransmitter(_) => Some(term.times(other.transmitted / ours.transmitted)),
        _ => None,
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

/// The cosine of the larger of the angles of incidence and of refraction.
fn cosine_in_air(cos_i: f64, eta: f64) -> f64 {
    match eta < 1.0 {
        true => ((eta - 1.0) * (eta + 1.0) + cos_i * cos_i).max(0.0).sqrt() / eta,
        false => cos_i,
    }
}

/// The index that is not inverted inside, in the factor 1/η² alone.
fn factor_inside(term: &ObservedTerm<'_>) -> Option<f64> {
    refracted(term).filter(|_| inside(term).is_some()).map(fourth)
}

/// In a scene whose indices are not inverted inside, that have it right again in Fresnel's equations. Where reflection is
/// total by these, nothing passes.
pub(super) fn fresnel_right(term: &ObservedTerm<'_>) -> Option<Rgb> {
    let surface = inside(term)?;
    let (cos_i, wrong) = (surface.cos_o().abs(), surface.eta()?);
    with_share(term, [fresnel(cos_i, 1.0 / wrong), fresnel(cos_i, wrong)])
}

/// The same, in the factor 1/η².
pub(super) fn factor_right(term: &ObservedTerm<'_>) -> Option<Rgb> {
    factor_inside(term).map(|factor| term.times(factor))
}

/// The same, in both.
pub(super) fn both_right(term: &ObservedTerm<'_>) -> Option<Rgb> {
    let arriving = fresnel_right(term).unwrap_or_else(|| term.value());
    Some(factor_inside(term).map_or(arriving, |factor| factor * arriving))
}

/// The same, in the test for total internal reflection alone.
pub(super) fn total_right(term: &ObservedTerm<'_>) -> Option<Rgb> {
    let surface = inside(term)?;
    let (cos_i, wrong) = (surface.cos_o().abs(), surface.eta()?);
    if fresnel(cos_i, 1.0 / wrong).transmitted > 0.0 {
        return None;
    }
    match term.traced()? {
        Lobe::FresnelReflector(_) => Some(term.times(1.0 / fresnel(cos_i, wrong).reflected)),
        Lobe::PerfectSpecular(_) => Some(term.arriving),
        Lobe::FresnelTransmitter(_) | Lobe::PerfectTransmitter(_) => Some(Rgb::BLACK),
        _ => None,
    }
}

/// Without absorption along the rays of a kind.
fn not_along(ray: &ObservedRay<'_>, kind: RayKind) -> Rgb {
    if ray.ray.kind == kind { ray.sum } else { ray.arriving() }
}

/// `c_f^(kt)` instead of `c_f^t`, for a factor `k` of the distance `t`.
fn absorption_over(ray: &ObservedRay<'_>, factor: fn(f64) -> f64) -> Rgb {
    match &ray.ray.surface {
        Some(surface) => ray.transmittance.powc(factor(surface.t)) * ray.sum,
        None => ray.arriving(),
    }
}
