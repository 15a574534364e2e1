//! Mistakes of transparent surfaces and media (Suffern, ch. 27, 28): changed values of terms.

use groundtruth::lobes::{Fresnel, Lobe, fresnel, polarised};
use groundtruth::math::power;
use groundtruth::rgb::Rgb;
use groundtruth::trace::RayKind;

use super::changes::NOT_INVERTED;
use super::{How, Mistake, ObservedRay, ObservedTerm};

const SCHLICK: Mistake =
    Mistake::term("schlick", |term| with_fresnel(term, |cos_i, eta| shares(schlick(cos_i, eta))));

const NO_ABSORPTION: Mistake = Mistake::ray("no-absorption", |ray| ray.sum);

pub(super) const ALL: &[Mistake] = &[
    Mistake::term("no-eta-squared", |term| {
        refracted(term).map_or(term.value(), |eta| term.times(eta * eta))
    }),
    Mistake::term("eta-squared-inverted", |term| {
        refracted(term).map_or(term.value(), |eta| term.times((eta * eta) * (eta * eta)))
    }),
    Mistake::term("total-reflection-black", |term| match is_mirrored(term) && is_total(term) {
        true => Rgb::BLACK,
        false => term.value(),
    }),
    Mistake::term("glass-without-mirror", |term| {
        match is_mirrored(term) && is_transparent(term) && !is_total(term) {
            true => Rgb::BLACK,
            false => term.value(),
        }
    }),
    Mistake::term("transmission-without-kt", |term| match term.traced() {
        Some(Lobe::PerfectTransmitter(lobe)) => term.times(1.0 / lobe.transmittance),
        _ => term.value(),
    }),
    NOT_INVERTED.in_form("in Fresnel's equations alone", How::Term(fresnel_not_inverted)),
    NOT_INVERTED.in_form("in the factor 1/η² alone", How::Term(factor_not_inverted)),
    SCHLICK,
    SCHLICK.in_form(
        "with the larger of both angles",
        How::Term(|term| {
            with_fresnel(term, |cos_i, eta| shares(schlick(cosine_in_air(cos_i, eta), eta)))
        }),
    ),
    Mistake::term("fresnel-swapped", |term| {
        with_fresnel(term, |cos_i, eta| {
            let Fresnel { reflected, transmitted } = fresnel(cos_i, eta);
            Fresnel { reflected: transmitted, transmitted: reflected }
        })
    }),
    Mistake::term("fresnel-perpendicular-only", |term| {
        with_fresnel(term, |cos_i, eta| polarised(cos_i, eta).s)
    }),
    Mistake::term("fresnel-parallel-only", |term| {
        with_fresnel(term, |cos_i, eta| polarised(cos_i, eta).p)
    }),
    Mistake::term("fresnel-without-half", |term| {
        with_fresnel(term, |cos_i, eta| shares((2.0 * fresnel(cos_i, eta).reflected).min(1.0)))
    }),
    Mistake::term("fresnel-transmits-all", |term| {
        with_fresnel(term, |cos_i, eta| Fresnel { transmitted: 1.0, ..fresnel(cos_i, eta) })
    }),
    Mistake::term("fresnel-index-inverted", |term| {
        with_fresnel(term, |cos_i, eta| fresnel(cos_i, 1.0 / eta))
    }),
    NO_ABSORPTION,
    NO_ABSORPTION
        .in_form("along reflected rays", How::Ray(|ray| not_along(ray, RayKind::Reflected))),
    NO_ABSORPTION
        .in_form("along transmitted rays", How::Ray(|ray| not_along(ray, RayKind::Transmitted))),
    NO_ABSORPTION
        .in_form("along the camera's rays", How::Ray(|ray| not_along(ray, RayKind::Camera))),
    Mistake::ray("absorption-without-distance", |ray| absorption_over(ray, |t| 1.0 / t)),
    Mistake::ray("absorption-twice", |ray| absorption_over(ray, |_| 2.0)),
];

/// The index behind the surface over the one in front of it, of a term that was refracted and has the factor 1/η².
fn refracted(term: &ObservedTerm<'_>) -> Option<f64> {
    match term.traced().filter(|_| term.world.transparency.scales_radiance)? {
        Lobe::PerfectTransmitter(_) | Lobe::FresnelTransmitter(_) => {
            term.ray.surface.as_ref()?.eta()
        }
        _ => None,
    }
}

fn is_mirrored(term: &ObservedTerm<'_>) -> bool {
    matches!(term.traced(), Some(Lobe::PerfectSpecular(_) | Lobe::FresnelReflector(_)))
}

fn is_transparent(term: &ObservedTerm<'_>) -> bool {
    term.ray.surface.as_ref().is_some_and(|surface| surface.eta().is_some())
}

/// Whether the term leaves a surface on which the viewer sees total internal reflection.
fn is_total(term: &ObservedTerm<'_>) -> bool {
    term.ray.surface.as_ref().is_some_and(|surface| surface.reflects_totally())
}

/// Whether the viewer is inside.
fn is_inside(term: &ObservedTerm<'_>) -> bool {
    term.ray.surface.as_ref().is_some_and(|surface| surface.cos_o() < 0.0)
}

/// The value of a term with other shares than Fresnel's. Total internal reflection stays as it is.
fn with_fresnel(term: &ObservedTerm<'_>, shares: impl Fn(f64, f64) -> Fresnel) -> Rgb {
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

/// The cosine of the larger of the angles of incidence and of refraction.
fn cosine_in_air(cos_i: f64, eta: f64) -> f64 {
    match eta < 1.0 {
        true => ((eta - 1.0) * (eta + 1.0) + cos_i * cos_i).max(0.0).sqrt() / eta,
        false => cos_i,
    }
}

fn fresnel_not_inverted(term: &ObservedTerm<'_>) -> Rgb {
    match is_inside(term) {
        true => with_fresnel(term, |cos_i, eta| fresnel(cos_i, 1.0 / eta)),
        false => term.value(),
    }
}

fn factor_not_inverted(term: &ObservedTerm<'_>) -> Rgb {
    match refracted(term).filter(|_| is_inside(term)) {
        Some(eta) => term.times((eta * eta) * (eta * eta)),
        None => term.value(),
    }
}

/// In a scene whose indices are not inverted inside, that have it right again in Fresnel's equations. Where reflection is
/// total by these, nothing passes.
pub(super) fn fresnel_right(term: &ObservedTerm<'_>) -> Rgb {
    let Some(surface) = term.ray.surface.as_ref().filter(|_| is_inside(term)) else {
        return term.value();
    };
    let Some(wrong) = surface.eta() else { return term.value() };
    let cos_i = surface.cos_o().abs();
    let (ours, right) = (fresnel(cos_i, wrong), fresnel(cos_i, 1.0 / wrong));
    match term.traced() {
        Some(Lobe::FresnelReflector(_)) => term.times(right.reflected / ours.reflected),
        Some(Lobe::FresnelTransmitter(_)) => term.times(right.transmitted / ours.transmitted),
        _ => term.value(),
    }
}

/// The same, in the factor 1/η².
pub(super) fn factor_right(term: &ObservedTerm<'_>) -> Rgb {
    factor_not_inverted(term)
}

/// The same, in both.
pub(super) fn both_right(term: &ObservedTerm<'_>) -> Rgb {
    let arriving = fresnel_right(term);
    match refracted(term).filter(|_| is_inside(term)) {
        Some(eta) => ((eta * eta) * (eta * eta)) * arriving,
        None => arriving,
    }
}

/// The same, in the test for total internal reflection alone.
pub(super) fn total_right(term: &ObservedTerm<'_>) -> Rgb {
    let surface = term.ray.surface.as_ref().filter(|_| is_inside(term));
    let Some((surface, wrong)) = surface.and_then(|it| Some((it, it.eta()?))) else {
        return term.value();
    };
    let cos_i = surface.cos_o().abs();
    if fresnel(cos_i, 1.0 / wrong).transmitted > 0.0 {
        return term.value();
    }
    match term.traced() {
        Some(Lobe::FresnelReflector(_)) => term.times(1.0 / fresnel(cos_i, wrong).reflected),
        Some(Lobe::PerfectSpecular(_)) => term.arriving,
        Some(Lobe::FresnelTransmitter(_) | Lobe::PerfectTransmitter(_)) => Rgb::BLACK,
        _ => term.value(),
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
