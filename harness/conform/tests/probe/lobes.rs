//! Questions about lobes and Fresnel's equations, against closed forms.

use ask::Draw;
use groundtruth::math::Vector;
use serde_json::json;

use super::{ask, numbers};

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
