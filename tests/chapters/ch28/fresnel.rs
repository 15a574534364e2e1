//! Fresnel's equations and Beer's law by themselves.

use groundtruth::lobes::{FresnelReflector, FresnelTransmitter, fresnel, refract};
use testkit::properties::*;

use crate::prelude::*;
use crate::support::optics::by_angles;
use crate::support::stage::*;

/// Ratios of indices from a tenth to ten, many near 1.
fn eta() -> impl Strategy<Value = f64> {
    prop_oneof![
        0.1..10.0_f64,
        1.0..3.0_f64,
        (-15.0..-1.0_f64).prop_map(|e| 1.0 + power(10.0, e)),
        (-15.0..-1.0_f64).prop_map(|e| 1.0 - power(10.0, e)),
    ]
}

/// R + T may differ from 1 by this much: a few roundings of each, and of their sum.
const SUM: f64 = 8.0 * U;

proptest! {
    #![proptest_config(laws())]

    /// Law: light that is not reflected is transmitted: R + T = 1 within 8u, and both are from 0 to 1. T is
    /// computed from the transmitted amplitudes, not as 1 − R. Oracle: conservation of energy (numerics).
    /// Book: Fresnel's equations.
    #[test]
    fn reflected_and_transmitted_light_add_up_to_all(cos_i in cosine(), eta in eta()) {
        let f = fresnel(cos_i, eta);
        prop_assert!((f.reflected + f.transmitted - 1.0).abs() <= SUM, "{f:?}");
        prop_assert!((0.0..=1.0 + SUM).contains(&f.reflected), "{f:?}");
        prop_assert!((0.0..=1.0 + SUM).contains(&f.transmitted), "{f:?}");
    }

    /// Law: R is half the sum of `sin²(θ_i − θ_t)/sin²(θ_i + θ_t)` and `tan²(θ_i − θ_t)/tan²(θ_i + θ_t)`,
    /// for unpolarised light, and T the rest. Oracle: those sums and differences of angles.
    /// Book: Fresnel's equations.
    #[test]
    fn reflection_is_fresnels_in_terms_of_angles(sine in 0.001..0.999_f64, eta in 1.01..4.0_f64) {
        let cos_i = ((1.0 - sine) * (1.0 + sine)).sqrt();
        let (seen, expected) = (fresnel(cos_i, eta).reflected, by_angles(sine, eta));
        let passed = fresnel(cos_i, eta).transmitted;
        // a difference of angles near zero loses digits, relative to its size
        let tolerance = 64.0 * U / ((eta - 1.0) * sine) / cos_i;
        let tolerance = tolerance * expected.max(1e-3);
        prop_assert!((seen - expected).abs() <= tolerance, "R is {seen}, expected {expected}");
        let rest = 1.0 - expected;
        prop_assert!((passed - rest).abs() <= tolerance + SUM, "T is {passed}, expected {rest}");
    }

    /// Law: between equal media nothing is reflected, also at grazing incidence; between other media grazing
    /// light is reflected entirely. Both hold exactly. Oracle: 0 and 1 (numerics).
    /// Book: Fresnel's equations.
    #[test]
    fn equal_media_reflect_nothing_and_grazing_light_is_reflected_whole(
        cos_i in cosine(),
        eta in eta(),
    ) {
        prop_assert_eq!(fresnel(cos_i, 1.0).reflected, 0.0);
        prop_assert_eq!(fresnel(0.0, 1.0).reflected, 0.0);
        prop_assert_eq!(fresnel(cos_i, 1.0).transmitted, 1.0);
        prop_assume!(eta != 1.0);
        prop_assert_eq!(fresnel(0.0, eta).reflected, 1.0);
        prop_assert_eq!(fresnel(0.0, eta).transmitted, 0.0);
    }

    /// Law: at the critical angle R is continuous: beyond it 1, before it
    /// `1 − R = T ≤ 2 (1 + η²)/(η cosθ_i) √margin`, margin the distance of `sin²θ_i/η²` from 1. Oracle: T is
    /// `2 η cosθ_i cosθ_t` times the inverse squares of sums of positive terms, each sum at least its term
    /// without cosθ_t. (The factor is 4√2 at least: 4 itself, as sometimes stated, is too little for any η.)
    /// Book: Fresnel's equations.
    #[test]
    fn reflection_is_continuous_at_the_critical_angle(
        eta in 0.2..0.99_f64,
        exponent in -14.0..-1.0_f64,
        beyond in any::<bool>(),
    ) {
        let margin = power(10.0, exponent);
        let sine_squared = eta * eta * (if beyond { 1.0 + margin } else { 1.0 - margin });
        prop_assume!(sine_squared < 1.0);
        let cos_i = (1.0 - sine_squared).sqrt();
        let f = fresnel(cos_i, eta);
        // the cosine is rounded, so that the margin is known to some u
        let bound =
            2.0 * (1.0 + eta * eta) / (eta * cos_i) * (margin + 16.0 * U / (eta * eta)).sqrt();
        let least = if beyond && margin > 1e-12 { 1.0 } else { 1.0 - bound - SUM };
        prop_assert!(f.reflected >= least && f.reflected <= 1.0 + SUM, "{f:?} {least}");
        if beyond && margin > 1e-12 {
            prop_assert_eq!(f.transmitted, 0.0);
        } else if margin > 1e-12 {
            below!(f.reflected, 1.0);
            above!(f.transmitted, 0.5 * margin.sqrt());
        }
    }

    /// Law: R and T from the other side, at the refracted angle and with `1/η`, are the same.
    /// Oracle: that exchange (Helmholtz; numerics). cosθ_t is known to u over its square.
    /// Book: Fresnel's equations.
    #[test]
    fn reflection_is_the_same_from_the_other_side(cos_i in 0.01..1.0_f64, eta in 0.4..2.5_f64) {
        let wo = at_angle(Normal::Z, cos_i, 0.5);
        let Some(t) = refract(wo, Normal::Z, eta) else { return Ok(()) };
        let (there, back) = (fresnel(wo.z(), eta), fresnel(-t.z(), 1.0 / eta));
        let tolerance = 64.0 * U / (t.z() * t.z() * wo.z());
        let [r, t] = [there.reflected - back.reflected, there.transmitted - back.transmitted];
        prop_assert!(r.abs() <= tolerance && t.abs() <= tolerance, "{there:?} and back {back:?}");
        prop_assert!(eta == 1.0 || there.transmitted < 1.0, "all of it passes: {there:?}");
    }

    /// Law: near η = 1 the reflectance keeps its digits: straight on it is `((η − 1)/(η + 1))²`, to a few u
    /// of its root. Oracle: that formula; η ≥ 1 + 1e-9.
    #[test]
    fn reflection_near_index_one_keeps_its_digits(exponent in -9.0..-1.0_f64) {
        let eta = 1.0 + power(10.0, exponent);
        let root = (eta - 1.0) / (eta + 1.0);
        let seen = fresnel(1.0, eta).reflected.sqrt();
        prop_assert!((seen - root).abs() <= 4.0 * U, "{seen} {root}");
    }

    /// Law: the weights of the two lobes are Fresnel's R and, as radiance, `T/η²`; seen from the inner side
    /// with `1/η`. Oracle: the values of R and T.
    /// Book: the material Dielectric.
    #[test]
    fn the_lobes_weigh_light_by_fresnels_shares(
        wo in local(),
        eta in 0.4..2.5_f64,
        back in any::<bool>(),
    ) {
        let (wo, relative) = if back { (-wo, 1.0 / eta) } else { (wo, eta) };
        let share = fresnel(wo.z().abs(), relative);
        let weight =
            |lobe: Lobe| lobe.sample(wo, [0.5; 2]).map_or(Rgb::BLACK, |sample| sample.weight);
        prop_assert_eq!(weight(FresnelReflector { eta }.into()), Rgb::grey(share.reflected));
        let passing = weight(FresnelTransmitter { eta }.into()).r * relative * relative;
        near!(passing, share.transmitted, 4.0 * U);
    }

    /// Law: transmittances multiply over lengths; each channel by itself. Oracle: one exponential of the
    /// sum, which errs by u of its exponent.
    /// Book: 28.4, colour filtering.
    #[test]
    fn transmittances_multiply(sigma in color(), a in 0.0..50.0_f64, b in 0.0..50.0_f64) {
        let product = sigma.transmittance(a) * sigma.transmittance(b);
        close!(product, sigma.transmittance(a + b), 8.0 * U * (1.0 + a + b));
        for channel in product.to_array() {
            above!(channel, 0.0);
            at_most!(channel, 1.0);
        }
    }

}

/// Law: the transmittance is 1 wherever σ or t is 0, also if the other is ∞; otherwise an infinite σ or t is
/// black. Oracle: the limits (numerics).
/// Book: 28.4, colour filtering.
#[test]
fn transmittance_is_one_without_medium_or_without_length() {
    let inf = f64::INFINITY;
    let sigma = Rgb::new(0.0, 1.0, inf);
    assert_eq!(sigma.transmittance(inf), Rgb::new(1.0, 0.0, 0.0));
    assert_eq!(sigma.transmittance(0.0), Rgb::WHITE);
    assert_eq!(sigma.transmittance(1e-3).b, 0.0);
    // the book's colour filter, per unit length: σ = −ln cf
    let half = Rgb::grey(std::f64::consts::LN_2);
    close!(half.transmittance(3.0), Rgb::grey(0.125), 8.0 * U);
}

/// Law: straight on, R is .04 between air and glass, .020059 air and water, .172395 air and diamond,
/// .003608 water and glass, .055081 glass and diamond, .084487 water and diamond, the same for `1/η`, and
/// T is `4η/(η + 1)²`. Oracle: the table of ch. 28, and the closed form.
/// Book: Fresnel's equations.
#[test]
fn normal_incidence_reflects_as_in_the_table() {
    let table = [
        (1.5, 0.04),
        (1.33, 0.020059),
        (2.42, 0.172395),
        (1.5 / 1.33, 0.003608),
        (2.42 / 1.5, 0.055081),
        (2.42 / 1.33, 0.084487),
    ];
    for (eta, expected) in table {
        for eta in [eta, 1.0 / eta] {
            let seen = fresnel(1.0, eta);
            near!(seen.reflected, expected, 5e-7, "{eta}");
            let passing = 4.0 * eta / ((eta + 1.0) * (eta + 1.0));
            near!(seen.transmitted, passing, SUM, "{eta}");
        }
    }
}

/// Law: at Brewster's angle, 56.3099° for glass, only one polarisation is reflected: R = .073964, half of
/// .147929. Oracle: those numbers (ch. 28); the tangent of the angle is η.
/// Book: Fresnel's equations.
#[test]
fn at_brewsters_angle_half_of_the_light_is_never_reflected() {
    let cos_i = 1.0 / (1.0 + 1.5 * 1.5_f64).sqrt();
    let found = fresnel(cos_i, 1.5);
    let r = found.reflected;
    assert!((found.transmitted - (1.0 - 0.073964)).abs() < 5e-7, "T is {}", found.transmitted);
    assert!((r - 0.073964).abs() < 5e-7 && (2.0 * r - 0.147929).abs() < 5e-7, "{r}");
    near!(cos(groundtruth::math::to_radians(56.3099)), cos_i, 1e-6);
    // reflected and refracted ray are at right angles there
    let wo = at_angle(Normal::Z, cos_i, 0.0);
    let t = refract(wo, Normal::Z, 1.5).expect("from the rarer side");
    let reflected = Vector::new(-wo.x(), -wo.y(), wo.z());
    near!(t.dot(reflected), 0.0, 16.0 * U);
}
