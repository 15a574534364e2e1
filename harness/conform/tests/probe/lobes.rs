//! Questions about lobes and Fresnel's equations, against closed forms.

use std::f64::consts::PI;

use ask::Draw;
use groundtruth::math::Vector;
use serde_json::json;
use testkit::properties::*;

use super::{ask, numbers};
use testkit::cases::laws;

/// A few dozen roundings of numbers below 100.
const ROUNDING: f64 = 1e-12;

proptest! {
    #![proptest_config(laws())]

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
