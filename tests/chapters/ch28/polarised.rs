//! Fresnel's equations for each polarisation.

use dashu_ratio::RBig;
use groundtruth::lobes::{fresnel, polarised};
use testkit::properties::*;

use crate::prelude::*;

fn exact(x: f64) -> RBig {
    RBig::try_from(x).expect("finite")
}

/// The square root to some 200 bits: three Newton steps from a value of 50 bits.
fn root(x: &RBig) -> RBig {
    let mut y = exact(x.to_f64().value().sqrt());
    for _ in 0..3 {
        y = (&y + x / &y) / RBig::from(2);
    }
    y
}

/// `[R_s, R_p, T_s, T_p]` by Fresnel's equations as textbooks have them, with `n₁ = 1`, `n₂ = η`:
/// `r_s = (n₁ cosθ_i − n₂ cosθ_t)/(n₁ cosθ_i + n₂ cosθ_t)`,
/// `r_p = (n₂ cosθ_i − n₁ cosθ_t)/(n₂ cosθ_i + n₁ cosθ_t)`, and `T = 1 − R`.
fn shares(cos_i: f64, eta: f64) -> [f64; 4] {
    let (c, eta) = (exact(cos_i), exact(eta));
    let one = RBig::ONE;
    let sine_squared = &one - &c * &c;
    let cos_t = root(&(&one - sine_squared / (&eta * &eta)));
    let share = |a: RBig, b: RBig| {
        let r = (&a - &b) / (&a + &b);
        &r * &r
    };
    let r_s = share(c.clone(), &eta * &cos_t);
    let r_p = share(&eta * &c, cos_t);
    let t = [&one - &r_s, &one - &r_p];
    let [t_s, t_p] = t;
    [r_s, r_p, t_s, t_p].map(|share| share.to_f64().value())
}

proptest! {
    #![proptest_config(laws())]

    /// Law: of light in the plane of incidence the square of `(η cosθ_i − cosθ_t)/(η cosθ_i + cosθ_t)` is
    /// reflected, of light across it that of `(cosθ_i − η cosθ_t)/(cosθ_i + η cosθ_t)`; the rest is
    /// transmitted. Oracle: these equations in rational numbers, with a root to 200 bits; a dozen
    /// roundings over cos²θ_t are allowed, the relative precision of cosθ_t.
    /// Book: Fresnel's equations.
    #[test]
    fn each_polarisation_divides_as_fresnel_says(cos_i in 0.001..=1.0_f64, eta in 0.3..4.0_f64) {
        let sine_squared = (1.0 - cos_i) * (1.0 + cos_i);
        prop_assume!(sine_squared < 0.9999 * eta * eta && eta != 1.0);
        let seen = polarised(cos_i, eta);
        let seen = [seen.s.reflected, seen.p.reflected, seen.s.transmitted, seen.p.transmitted];
        let cos_t = (1.0 - sine_squared / (eta * eta)).sqrt();
        for (seen, expected) in seen.into_iter().zip(shares(cos_i, eta)) {
            near!(seen, expected, 12.0 * U / (cos_t * cos_t));
        }
    }

    /// Law: R and T of unpolarised light are the means of both polarisations, of each of which they add
    /// up to 1. Oracle: those sums.
    /// Book: Fresnel's equations.
    #[test]
    fn unpolarised_light_is_the_mean(cos_i in 0.0..=1.0_f64, eta in 0.1..10.0_f64) {
        let (mean, each) = (fresnel(cos_i, eta), polarised(cos_i, eta));
        let half = |s: f64, p: f64| 0.5 * (s + p);
        near!(mean.reflected, half(each.s.reflected, each.p.reflected), 2.0 * U);
        let transmitted = half(each.s.transmitted, each.p.transmitted);
        near!(mean.transmitted, transmitted, 8.0 * U);
        for shares in [each.s, each.p] {
            near!(shares.reflected + shares.transmitted, 1.0, 8.0 * U, "{shares:?}");
        }
    }

    /// Law: light polarised in the plane of incidence is not reflected at Brewster's angle, where tan θ =
    /// η; straight on, both polarisations are equal. Oracle: that angle; `((η − 1)/(η + 1))²`.
    /// Book: Fresnel's equations.
    #[test]
    fn light_in_the_plane_passes_whole_at_brewsters_angle(exponent in -0.5..0.5_f64) {
        let eta = power(10.0, exponent);
        let each = polarised(1.0 / (1.0 + eta * eta).sqrt(), eta);
        // the amplitude is zero up to the precision of cosθ_t
        let amplitude = 12.0 * U * (1.0 + eta * eta) / (eta * eta);
        prop_assert!(each.p.reflected <= amplitude * amplitude, "{each:?}");
        let r_s = (1.0 - eta * eta) / (1.0 + eta * eta);
        near!(each.s.reflected, r_s * r_s, 2.0 * amplitude + 16.0 * U);
        let straight = polarised(1.0, eta);
        let r = (eta - 1.0) / (eta + 1.0);
        for shares in [straight.s, straight.p] {
            near!(shares.reflected, r * r, 8.0 * U);
        }
    }
}
