//! The albedo of lobes, against integrals of the same accuracy.

use std::f64::consts::FRAC_PI_2;

use groundtruth::lobes::{Branch, GlossySpecular};

use super::{QUADRATURE, every_lobe, projected_integral};
use crate::prelude::*;
use crate::support::optics::acos_of_one_minus;
use crate::support::optics::albedo_about_the_mirror_direction;
use crate::support::optics::by_angles;
use crate::support::stage::at_angle;

/// The code integrates with another rule and variable; both sums have some rounding errors.
const ACCURACY: f64 = 1e-12;

/// Law: the albedo of the glossy lobe is `k_s c_s ∫ cosᵉα cosθ_i dω`, to a relative error of 1e-12: for lobes
/// from the broadest to the narrowest, seen from straight above to within 1e-6 of grazing, where the horizon
/// cuts off half of them. Oracle: composite Gauss–Legendre quadrature about the mirror direction.
/// Book: reflectance.
#[test]
fn the_glossy_albedo_is_exact_to_twelve_digits() {
    for exponent in [0.0, 0.25, 1.0, 10.0, 2000.0, 1e6] {
        for cosine in [1.0, 0.999, 0.9, 0.5, 0.1, 0.01, 1e-3, 1e-6] {
            let lobe =
                Lobe::from(GlossySpecular { reflectance: Rgb::new(0.5, 1.0, 0.25), exponent });
            let wo = at_angle(Normal::Z, cosine, 0.7);
            let expected = albedo_about_the_mirror_direction(exponent, wo.z());
            let found = lobe.albedo(wo);
            near!(found.g / expected, 1.0, ACCURACY, "e = {exponent}, cosine {cosine}");
            assert_eq!(found, found.g * Rgb::new(0.5, 1.0, 0.25));
        }
    }
}

/// Law: the oracle is right where there are closed forms: `2π/(e + 2)` from straight above, and for `e = 0`
/// the part of the cosine-weighted sky on the mirror direction's side, `π (1 + cos_o)/2`. Oracle: the closed
/// forms.
#[test]
fn the_quadrature_of_the_albedo_has_the_closed_forms() {
    for e in [0.0, 0.25, 1.0, 10.0, 2000.0, 1e6] {
        near!(albedo_about_the_mirror_direction(e, 1.0) * (e + 2.0) / TAU, 1.0, 1e-13, "e = {e}");
    }
    for cosine in [1.0, 0.9, 0.5, 0.1, 1e-3, 1e-6] {
        let share = albedo_about_the_mirror_direction(0.0, cosine) / (0.5 * PI);
        near!(share / (1.0 + cosine), 1.0, 1e-13, "{cosine}");
    }
    near!(acos(0.25), acos_of_one_minus(0.75), 1e-15);
}

/// The albedo of a lobe, not by its own code: the integral of its `f`, or the textbook's reflectance for a
/// single direction.
fn outside_albedo(lobe: &Lobe, wo: Vector) -> f64 {
    let relative = |eta: f64| if wo.z() < 0.0 { 1.0 / eta } else { eta };
    let sine = (wo.x() * wo.x() + wo.y() * wo.y()).sqrt();
    // from the denser side: the angles of the reversed path
    let reflected = |eta: f64| match relative(eta) {
        1.0 => 0.0,
        eta if eta > 1.0 => by_angles(sine, eta),
        eta if sine >= eta => 1.0,
        eta => by_angles(sine / eta, 1.0 / eta),
    };
    match lobe {
        Lobe::GlossySpecular(_) if wo.z() < 0.0 => 0.0,
        Lobe::GlossySpecular(glossy) => {
            glossy.reflectance.max() * albedo_about_the_mirror_direction(glossy.exponent, wo.z())
        }
        Lobe::GlossyReflection(_) if wo.z() < 0.0 => 0.0,
        Lobe::GlossyReflection(glossy) => match glossy.rule {
            // the whole reflectance: see `ch25::every_direction_is_above_the_surface`
            GlossyRule::Book => glossy.reflectance.max(),
            GlossyRule::Normalised => {
                let scale = glossy.reflectance.max() * (glossy.exponent + 2.0) / (2.0 * PI);
                scale * albedo_about_the_mirror_direction(glossy.exponent, wo.z())
            }
        },
        Lobe::PerfectSpecular(mirror) => mirror.reflectance.max(),
        Lobe::PerfectTransmitter(glass) if sine >= relative(glass.eta) => 0.0,
        Lobe::PerfectTransmitter(glass) => {
            glass.transmittance / (relative(glass.eta) * relative(glass.eta))
        }
        Lobe::FresnelReflector(glass) => reflected(glass.eta),
        Lobe::FresnelTransmitter(glass) => {
            (1.0 - reflected(glass.eta)) / (relative(glass.eta) * relative(glass.eta))
        }
        lobe => projected_integral(FRAC_PI_2, |wi| lobe.f(wo, wi).max()),
    }
}

/// Law: a lobe's albedo is the share of uniform light that it scatters, and a lobe that claims to conserve
/// energy scatters no more than arrives. The refracting ones count radiance, which grows by η² in the denser
/// medium. The glossy lobe does not claim it, as `2π/(e + 2) > 1` for small `e` (ch. 13, 15). Oracle:
/// quadrature, Fresnel's equations in terms of angles, and the lobes' data.
/// Book: properties of BRDFs: reciprocity and energy.
#[test]
fn no_lobe_that_conserves_energy_reflects_more_than_all() {
    let mut claimed = 0;
    for lobe in every_lobe() {
        for cosine in [1.0, 0.7, 0.2, 0.05, -0.3, -0.9] {
            let wo = at_angle(Normal::Z, cosine, 2.0);
            let (albedo, expected) = (lobe.albedo(wo).max(), outside_albedo(&lobe, wo));
            let is_diffuse = lobe.branch() == Branch::Diffuse;
            let tolerance = if is_diffuse { QUADRATURE } else { ACCURACY };
            let apart = (albedo - expected).abs();
            assert!(
                apart <= tolerance * expected + 1e-15,
                "{lobe:?} at {cosine}: albedo {albedo}, expected {expected}, apart by {apart:e}"
            );
            if lobe.claims().conserves_energy {
                let eta = lobe.relative_eta(wo).unwrap_or(1.0);
                assert!(
                    eta * eta * albedo <= 1.0 + 1e-14,
                    "{lobe:?} at {cosine}: {albedo}, η {eta}"
                );
                claimed += 1;
            }
        }
    }
    assert!(claimed > 20, "{claimed} claims tested");
    let broad = Lobe::from(GlossySpecular { reflectance: Rgb::WHITE, exponent: 0.0 });
    assert!(!broad.claims().conserves_energy, "{broad:?} claims to conserve energy");
    near!(broad.albedo(Vector::Z).r, PI, 1e-12);
}
