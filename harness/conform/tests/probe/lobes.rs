//! Questions about lobes and Fresnel's equations, against closed forms.

use std::f64::consts::PI;

use ask::Draw;
use groundtruth::math::Vector;
use serde_json::json;
use testkit::properties::*;

use super::{ask, close, numbers};
use testkit::cases::{laws, unit};

/// A few dozen roundings of numbers below 100.
const ROUNDING: f64 = 1e-12;

proptest! {
    #![proptest_config(laws())]

    /// Law: `f = ρ/π`, density `cos θ/π`, albedo ρ. Closed forms (Suffern, ch. 13).
    #[test]
    fn a_lambertian_lobe_is_rho_over_pi(wo in unit(), wi in unit(), length in 0.1..10.0_f64) {
        prop_assume!(wo.z().abs() > 1e-6 && wi.z().abs() > 1e-6);
        let wo = if wo.z() < 0.0 { -wo } else { wo };
        let answer = ask(&json!({"lobe": {
            "lobe": {"lambertian": {"reflectance": [0.8, 0.4, 0]}},
            "wo": (length * wo).to_array(), "wi": wi.to_array(),
        }}));
        let above = if wi.z() > 0.0 { 1.0 } else { 0.0 };
        prop_assert!(close(&answer["f"], &[above * 0.8 / PI, above * 0.4 / PI, 0.0], ROUNDING));
        prop_assert!((answer["pdf"].as_f64().expect("pdf") - above * wi.z() / PI).abs() < ROUNDING);
        prop_assert!(close(&answer["albedo"], &[0.8, 0.4, 0.0], ROUNDING));
    }

    /// Law: `η sin θ_t = sin θ_i` in one plane, and the shares add up to 1. Oracle: cross products.
    #[test]
    fn fresnel_refracts_by_snell(n in unit(), wo in unit(), eta in 0.4..2.5_f64) {
        prop_assume!(n.dot(wo) > 1e-3);
        let answer = ask(&json!({"fresnel": {"wo": wo.to_array(), "n": n.to_array(), "eta": eta}}));
        let share = |name: &str| answer[name].as_f64().expect("a share");
        prop_assert!((share("reflected") + share("transmitted") - 1.0).abs() < ROUNDING);
        for [r, t] in [["r_s", "t_s"], ["r_p", "t_p"]] {
            prop_assert!((share(r) + share(t) - 1.0).abs() < ROUNDING);
        }
        let mean = 0.5 * (share("r_s") + share("r_p"));
        prop_assert!((share("reflected") - mean).abs() < ROUNDING);
        let sine = n.cross(wo).length();
        if answer["refracted"].is_null() {
            prop_assert!(sine > eta - ROUNDING);
            prop_assert_eq!(share("reflected"), 1.0);
        } else {
            let t = numbers(&answer["refracted"]);
            let t = Vector::new(t[0], t[1], t[2]);
            prop_assert!((n.cross(wo) + eta * n.cross(t)).length() < ROUNDING);
            prop_assert!(n.dot(t) <= ROUNDING && (t.length() - 1.0).abs() < ROUNDING);
        }
    }

    /// Law: at Brewster's angle, tan θ = η, no light polarised in the plane of incidence is reflected: the
    /// reflected share is `½ ((1 − η²)/(1 + η²))²`. At normal incidence it is `((η − 1)/(η + 1))²`.
    #[test]
    fn fresnel_agrees_with_brewster_and_head_on(eta in 0.4..2.5_f64) {
        let reflected = |cos_i: f64| {
            let answer = ask(&json!({"fresnel": {"cos_i": cos_i, "eta": eta}}));
            answer["reflected"].as_f64().expect("a share")
        };
        let square = |x: f64| x * x;
        let brewster = 1.0 / (1.0 + eta * eta).sqrt();
        let expected = 0.5 * square((1.0 - eta * eta) / (1.0 + eta * eta));
        prop_assert!((reflected(brewster) - expected).abs() < ROUNDING);
        let answer = ask(&json!({"fresnel": {"cos_i": brewster, "eta": eta}}));
        prop_assert!(answer["r_p"].as_f64().expect("a share") < ROUNDING * ROUNDING);
        prop_assert!((answer["r_s"].as_f64().expect("a share") - 2.0 * expected).abs() < ROUNDING);
        prop_assert!((reflected(1.0) - square((eta - 1.0) / (eta + 1.0))).abs() < ROUNDING);
    }

    /// Law: albedos are as exact as documented. Oracle: for the glossy lobe the closed forms `2π/(e + 2)` at
    /// normal incidence and `π (1 + cosθ)/2` for exponent 0; for the others their definitions.
    #[test]
    fn albedos_are_as_good_as_documented(
        e in 0.0..300.0_f64,
        cosine in 0.001..1.0_f64,
        eta in 0.5..2.0_f64,
    ) {
        let albedo = |lobe: serde_json::Value, cosine: f64| {
            let wo = [((1.0 - cosine) * (1.0 + cosine)).sqrt(), 0.0, cosine];
            numbers(&ask(&json!({"lobe": {"lobe": lobe, "wo": wo}}))["albedo"])[0]
        };
        let glossy = |e: f64| json!({"glossy_specular": {"reflectance": 1, "exponent": e}});
        prop_assert!((albedo(glossy(e), 1.0) - 2.0 * PI / (e + 2.0)).abs() <= 1e-4);
        prop_assert!((albedo(glossy(0.0), cosine) - 0.5 * PI * (1.0 + cosine)).abs() <= 1e-4);
        prop_assert_eq!(albedo(json!({"lambertian": {"reflectance": 0.3}}), cosine), 0.3);
        prop_assert_eq!(albedo(json!({"perfect_specular": {"reflectance": 0.3}}), cosine), 0.3);
        let clear = json!({"perfect_transmitter": {"transmittance": 0.3, "eta": eta}});
        let passes = (1.0 - cosine) * (1.0 + cosine) < eta * eta;
        let expected = if passes { 0.3 / (eta * eta) } else { 0.0 };
        prop_assert!(
            (albedo(clear, cosine) - expected).abs() <= 3.0 * f64::EPSILON / 2.0 * expected
        );
        let shares = ask(&json!({"fresnel": {"cos_i": cosine, "eta": eta}}));
        let mirror = albedo(json!({"fresnel_reflector": {"eta": eta}}), cosine);
        prop_assert!((mirror - shares["reflected"].as_f64().expect("a share")).abs() < ROUNDING);
        let refracting = albedo(json!({"fresnel_transmitter": {"eta": eta}}), cosine) * eta * eta;
        prop_assert!(
            (refracting - shares["transmitted"].as_f64().expect("a share")).abs() < ROUNDING
        );
    }
}

/// Law: the albedo of the glossy lobe at normal incidence is `2π k_s/(e + 2)`. The library uses the
/// midpoint rule with 256 steps on a function of infinite slope at one end, so the error is 256^(−3/2).
#[test]
fn a_glossy_lobe_head_on_has_a_closed_albedo() {
    for e in [0.0, 1.0, 10.0, 200.0] {
        let lobe = json!({"glossy_specular": {"reflectance": 0.5, "exponent": e}});
        let answer = ask(&json!({"lobe": {"lobe": lobe, "wo": [0, 0, 1]}}));
        let expected = 2.0 * PI * 0.5 / (e + 2.0);
        assert!(close(&answer["albedo"], &[expected; 3], 2.5e-4 * expected), "{e}: {answer}");
        assert!(answer.get("f").is_none() && answer.get("sample").is_none());
    }
}

/// Law: a unit vector is used as it is, bit for bit; any other is normalised.
#[test]
fn unit_vectors_are_left_alone() {
    let wo = [0.6, 0.0, 0.8];
    let mirror = |wo: [f64; 3]| {
        let lobe = json!({"perfect_specular": {"reflectance": 1}});
        numbers(&ask(&json!({"lobe": {"lobe": lobe, "wo": wo, "u": [0, 0]}}))["sample"]["wi"])
    };
    assert_eq!(mirror(wo), [-0.6, 0.0, 0.8]);
    assert_eq!(mirror([3.0, 0.0, 4.0]), [-0.6, 0.0, 0.8]);
    // these are unit only up to rounding; normalising them again could change the last bits
    let mut draw = Draw::new(20_241);
    for _ in 0..100 {
        let [x, y, z] = Vector::from(draw.direction()).to_array();
        let wo = [x, y, z.abs()];
        assert_eq!(mirror(wo), [-x, -y, z.abs()], "unit: {wo:?}");
        let found = mirror(wo.map(|c| 3.0 * c));
        let off =
            (Vector::new(found[0], found[1], found[2]) - Vector::new(-x, -y, z.abs())).length();
        assert!(off < 4.0 * f64::EPSILON, "three times as long: {wo:?}, off by {off:e}");
    }
}
