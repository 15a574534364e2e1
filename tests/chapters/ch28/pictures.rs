//! Dielectrics on whole pictures and under path tracers, against closed forms.

use groundtruth::cameras::Fisheye;
use groundtruth::render::{film_point, render};

use super::glass;
use crate::prelude::*;
use crate::support::optics;
use crate::support::stage::*;

/// Law: a fisheye that looks straight up from under water sees the whole sky in a disc of 48.7535° of its
/// 90°, as `1 − R` with the exposure `1/η²`, and around it the ground, mirrored in the surface. Oracle: in
/// each pixel the critical angle and Fresnel's equations in angles, from its distance to the middle.
/// Book: fig. 28.7, the world seen from under water.
#[test]
fn a_fisheye_under_water_sees_snells_window() {
    const SIDE: u32 = 61;
    let mut scene = deep_stage(Rgb::WHITE, 1);
    scene.camera.eye = Point::new(0.0, -1.0, 0.0);
    scene.camera.look_at = Point::ORIGIN;
    scene.camera.lens = Fisheye { fov: 180.0, rectangular: false }.into();
    (scene.camera.medium, scene.camera.exposure_time) = (Medium::clear(1.33), 1.0 / 1.7689);
    (scene.image.width, scene.image.height) = (SIDE, SIDE);
    let water = glass(Medium::clear(1.33), Medium::default());
    put(&mut scene, ground(0.0), water);
    let deep = Plane { point: Point::new(0.0, -3.0, 0.0), normal: Vector::Y };
    put(&mut scene, deep, Emissive::new(0.5, Rgb::new(1.0, 0.0, 0.0)));
    let (picture, mut seen) = (render(&built(&scene)), [0, 0]);
    for at in (0..SIDE * SIDE).map(|i| [i % SIDE, i / SIDE]) {
        let [x, y] = film_point(&scene.image, at, [0.5; 2]);
        let degrees = 90.0 * (x * x + y * y).sqrt() / (0.5 * f64::from(SIDE));
        let red = 0.5 / 1.7689;
        let expected = if degrees > 90.0 {
            Rgb::BLACK
        } else if degrees > 48.7535 {
            seen[1] += 1;
            Rgb::new(red, 0.0, 0.0)
        } else {
            seen[0] += 1;
            let r = optics::by_angles(1.33 * sin(to_radians(degrees)), 1.33);
            Rgb::grey(1.0 - r) + Rgb::new(r * red, 0.0, 0.0)
        };
        let found = picture.get(at);
        // R is steep where the window ends
        close!(found, expected, 1e-9, "{at:?}, {degrees}°");
    }
    // the disc's share of the circle, up to its border of pixels
    let share = f64::from(seen[0]) / f64::from(seen[0] + seen[1]);
    assert!((share - power(48.7535 / 90.0, 2.0)).abs() < 0.01, "{share}");
}
