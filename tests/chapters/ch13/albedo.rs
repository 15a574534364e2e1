//! What lobes send back of uniform light, against integrals that are as exact.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use groundtruth::lobes::{GlossyRule, GlossySpecular, Lobe};
use groundtruth::math::{Normal, Vector, acos, atan2, cos, exp, ln, ln_1p, sin};
use groundtruth::rgb::Rgb;

use super::{QUADRATURE, every_lobe, projected_integral};
use crate::ch14::stage::at_angle;
use crate::ch28::fresnel::by_angles;

/// Nodes in `[−1, 1]` and weights of the Gauss–Legendre rule of so many points: roots of the
/// Legendre polynomial by Newton's method, from its recurrence.
fn gauss_legendre(n: u32) -> Vec<(f64, f64)> {
    let legendre = |x: f64| {
        let (mut before, mut p) = (1.0, x);
        for k in 1..n {
            let k = f64::from(k);
            (before, p) = (p, ((2.0 * k + 1.0) * x * p - k * before) / (k + 1.0));
        }
        (p, f64::from(n) * (x * p - before) / (x * x - 1.0))
    };
    let node = |i: u32| {
        let mut x = cos(PI * (f64::from(i) + 0.75) / (f64::from(n) + 0.5));
        for _ in 0..6 {
            let (p, slope) = legendre(x);
            x -= p / slope;
        }
        let (_, slope) = legendre(x);
        (x, 2.0 / ((1.0 - x * x) * slope * slope))
    };
    (0..n).map(node).collect()
}

/// The integral of `f` from `a` to `b`.
fn integral(rule: &[(f64, f64)], [a, b]: [f64; 2], f: impl Fn(f64) -> f64) -> f64 {
    let (middle, half) = (0.5 * (a + b), 0.5 * (b - a));
    half * rule.iter().map(|(x, weight)| weight * f(middle + half * x)).sum::<f64>()
}

/// `∫ cosᵉα max(0, cosθ_i) dω` about the mirror direction, which is `α_h` above the horizon, `sin
/// α_h = cos_o`: rings `α`, and of each the arc `|φ| ≤ φ_h` above the horizon, over which `cosθ_i =
/// cosα cosθ_o + sinα sinθ_o cosφ` is integrated by itself. Panels grow by factors of two from the
/// width of the lobe, from `α_h` and from the end; where the arc begins to shrink, like a root, the
/// variable is the root.
pub fn albedo_about_the_mirror_direction(e: f64, cos_o: f64) -> f64 {
    let rule = gauss_legendre(24);
    let sin_o = ((1.0 - cos_o) * (1.0 + cos_o)).sqrt();
    let horizon = atan2(cos_o, sin_o);
    let ring = |alpha: f64, beyond: f64| {
        let (along, across) = (cos(alpha) * cos_o, sin(alpha) * sin_o);
        // beyond the horizon by so much: 1 − cos(π − φ_h) = sin(beyond)/(sinα sinθ_o)
        let short = (sin(beyond) / across).clamp(0.0, 2.0);
        let arc = if beyond > 0.0 { PI - acos_of_one_minus(short) } else { PI };
        let whole = 2.0 * integral(&rule, [0.0, arc], |phi| along + across * cos(phi));
        // cosᵉα by the logarithm: a large exponent multiplies the rounding of a cosine near 1
        let log = if alpha > 1.0 { ln(cos(alpha)) } else { 0.5 * ln_1p(-sin(alpha) * sin(alpha)) };
        exp(e * log) * sin(alpha) * whole
    };
    let mut edges = vec![0.0, horizon, FRAC_PI_2];
    for scale in [1.0 / (e + 2.0).sqrt(), horizon] {
        let powers = (-3..64).map(|k| scale * exp(f64::from(k) * std::f64::consts::LN_2));
        edges.extend(powers.filter(|edge| *edge < FRAC_PI_2));
    }
    // `cosᵉα` of a small exponent has an infinite slope at its end
    edges.extend((1..30).map(|k| FRAC_PI_2 - exp(-f64::from(k) * std::f64::consts::LN_2)));
    edges.sort_by(f64::total_cmp);
    edges.dedup_by(|a, b| *a - *b < 1e-9 * *b);
    let panel = |pair: &[f64]| {
        let [a, b] = [pair[0], pair[1]];
        if 0.5 * (a + b) < horizon {
            return integral(&rule, [a, b], |alpha| ring(alpha, 0.0));
        }
        let part = |s: f64| 2.0 * s * ring(horizon + s * s, s * s);
        integral(&rule, [(a - horizon).max(0.0).sqrt(), (b - horizon).sqrt()], part)
    };
    edges.windows(2).map(panel).sum()
}

/// `acos(1 − x)`, without the cancellation for small x.
fn acos_of_one_minus(x: f64) -> f64 {
    2.0 * atan2(x.sqrt(), (2.0 - x).sqrt())
}

/// The code integrates by another rule and variable; both err by some roundings of the sum.
const ACCURACY: f64 = 1e-12;

/// Law: the albedo of the glossy lobe is `k_s c_s ∫ cosᵉα cosθ_i dω`, to 1e-12 of it: for lobes
/// from the broadest to needles, seen from straight above to within 1e-6 of grazing, where the
/// horizon cuts off half of them. Oracle: composite Gauss–Legendre quadrature about the mirror
/// direction.
#[test]
fn the_glossy_albedo_is_exact_to_twelve_digits() {
    let mut worst = (0.0, 0.0, 0.0);
    for exponent in [0.0, 0.25, 1.0, 10.0, 2000.0, 1e6] {
        for cosine in [1.0, 0.999, 0.9, 0.5, 0.1, 0.01, 1e-3, 1e-6] {
            let lobe =
                Lobe::from(GlossySpecular { reflectance: Rgb::new(0.5, 1.0, 0.25), exponent });
            let wo = at_angle(Normal::Z, cosine, 0.7);
            let expected = albedo_about_the_mirror_direction(exponent, wo.z());
            let found = lobe.albedo(wo);
            let error = (found.g / expected - 1.0).abs();
            if error > worst.0 {
                worst = (error, exponent, cosine);
            }
            assert!(
                error <= ACCURACY,
                "e = {exponent}, cosine {cosine}: albedo {}, expected {expected}, apart by {error:e} of it",
                found.g
            );
            assert_eq!(found, found.g * Rgb::new(0.5, 1.0, 0.25));
        }
    }
    println!("largest relative error {:e}, at e = {}, cosine {}", worst.0, worst.1, worst.2);
}

/// Law: the oracle is right where there are closed forms: `2π/(e + 2)` from straight above, and for
/// `e = 0` the part of the cosine-weighted sky on the mirror direction's side, `π (1 + cos_o)/2`.
/// Oracle: these.
#[test]
fn the_quadrature_of_the_albedo_has_the_closed_forms() {
    for e in [0.0, 0.25, 1.0, 10.0, 2000.0, 1e6] {
        let (found, expected) = (albedo_about_the_mirror_direction(e, 1.0), TAU / (e + 2.0));
        assert!((found / expected - 1.0).abs() < 1e-13, "e = {e}: {found}, expected {expected}");
    }
    for cosine in [1.0, 0.9, 0.5, 0.1, 1e-3, 1e-6] {
        let found = albedo_about_the_mirror_direction(0.0, cosine);
        let expected = 0.5 * PI * (1.0 + cosine);
        assert!((found / expected - 1.0).abs() < 1e-13, "{cosine}: {found}, expected {expected}");
    }
    assert!((acos(0.25) - acos_of_one_minus(0.75)).abs() < 1e-15);
}

/// What a lobe sends back of uniform light, by other means than its own: the integral of its `f`,
/// or the textbook's share for a single direction.
fn outside_albedo(lobe: &Lobe, wo: Vector) -> f64 {
    let relative = |eta: f64| if wo.z() < 0.0 { 1.0 / eta } else { eta };
    let sine = (wo.x() * wo.x() + wo.y() * wo.y()).sqrt();
    // from the denser side the angles are those of the way back
    let reflected = |eta: f64| match relative(eta) {
        1.0 => 0.0,
        eta if eta > 1.0 => by_angles(sine, eta),
        eta if sine >= eta => 1.0,
        eta => by_angles(sine / eta, 1.0 / eta),
    };
    match lobe {
        Lobe::Lambertian(_) => projected_integral(FRAC_PI_2, |wi| lobe.f(wo, wi).max()),
        Lobe::GlossySpecular(_) if wo.z() < 0.0 => 0.0,
        Lobe::GlossySpecular(glossy) => {
            glossy.reflectance.max() * albedo_about_the_mirror_direction(glossy.exponent, wo.z())
        }
        Lobe::GlossyReflection(_) if wo.z() < 0.0 => 0.0,
        Lobe::GlossyReflection(glossy) => match glossy.rule {
            // all of it: see `ch25::every_direction_is_above_the_surface`
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
    }
}

/// Law: a lobe's albedo is what it sends back, and a lobe that claims to conserve energy sends out
/// no more than arrives: the refracted ones count radiance, which grows by η² in the denser medium.
/// The glossy lobe, which does not claim it, does not: `2π/(e + 2) > 1` for small `e` (ch. 13, 15).
/// Oracle: quadrature, Fresnel's equations in terms of angles, and the lobes' data.
#[test]
fn no_lobe_that_conserves_energy_reflects_more_than_all() {
    let mut claimed = 0;
    for lobe in every_lobe() {
        for cosine in [1.0, 0.7, 0.2, 0.05, -0.3, -0.9] {
            let wo = at_angle(Normal::Z, cosine, 2.0);
            let (albedo, expected) = (lobe.albedo(wo).max(), outside_albedo(&lobe, wo));
            let is_diffuse = matches!(lobe, Lobe::Lambertian(_));
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
    assert!(!broad.claims().conserves_energy && (broad.albedo(Vector::Z).r - PI).abs() < 1e-12);
}
