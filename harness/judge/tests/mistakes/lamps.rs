//! Mistakes of area lights, by a lamp so small that its light is that of a point.

use std::f64::consts::PI;

use groundtruth::lights::Area;
use groundtruth::materials::Emissive;
use groundtruth::math::Vector;
use groundtruth::rgb::Rgb;
use groundtruth::scene::Scene;
use groundtruth::scene::build::*;
use groundtruth::shapes::{Rectangle, Sampling};

use super::stage::*;

/// The side of the lamp.
const SIDE: f64 = 0.01;
/// It is 500 times as far away as it is wide, so that its cosines vary by about a thousandth.
const TOLERANCE: f64 = 0.01;
const KD: f64 = 0.5;
/// The radiance of the lamp.
const LS: f64 = 1000.0;

/// A plane under a small square lamp, 4 above and 3 aside: at a distance of 5, both cosines are 4/5. `b` turns its
/// shining side.
fn under_a_lamp(sampling: Option<Sampling>, b: Vector) -> Scene {
    let mut scene = plane(matte(0.0, KD, Rgb::WHITE), 10.0);
    let lamp = Rectangle { corner: point(3.0, 4.0, 0.0), a: SIDE * Vector::X, b: SIDE * b };
    add(&mut scene, "lamp", lamp, Emissive::new(LS, Rgb::WHITE));
    light(&mut scene, Area { object: "lamp".to_owned(), sampling });
    scene
}

/// Law: without the lamp's cosine, 1/d² or area, direct light lacks that factor, however the lamp is sampled. Oracle:
/// `k_d/π L cosθ_i cosθ' A/d²`.
#[test]
fn factors_of_a_small_lamp() {
    let irradiance = LS * KD / PI * 0.8 * 0.8 * SIDE * SIDE / 25.0;
    for sampling in [None, Some(Sampling::Area), Some(Sampling::SolidAngle)] {
        let scene = under_a_lamp(sampling, Vector::Z);
        assert!((value(&ours(&scene)) / irradiance - 1.0).abs() < TOLERANCE);
        expect("no-lamp-cosine", &scene, irradiance / 0.8, TOLERANCE);
        expect("no-lamp-distance", &scene, 25.0 * irradiance, TOLERANCE);
        expect("no-lamp-area", &scene, irradiance / (SIDE * SIDE), TOLERANCE);
        expect("lamp-of-receiver", &scene, KD * irradiance, TOLERANCE);
        expect("lamp-cosine-twice", &scene, 0.8 * irradiance, TOLERANCE);
        let lacking = "no-lamp-distance";
        expect_form(lacking, "but has 1/d", &scene, 5.0 * irradiance, TOLERANCE);
        let both = 25.0 * irradiance / 0.8;
        expect_form(lacking, "and the cosine at the lamp", &scene, both, TOLERANCE);
    }
}
