//! The blur of glossy surfaces on whole pictures, against closed forms.

use groundtruth::render::{pixel, render};

use super::glossy;
use crate::prelude::*;

/// The distance of the lamp: from all points of the floor it is seen at the same angle, up to 1e-9.
const FAR: f64 = 1e9;

/// The view straight down on a glossy floor, with a lamp of this angular radius straight above. The lamp
/// does not hide the floor, because the eye is below it.
fn under_a_moon(finish: GlossyReflector, degrees: f64, tracer: Tracer) -> Scene {
    let mut scene = deep_stage(Rgb::BLACK, 1);
    scene.tracer = tracer;
    (scene.image.width, scene.image.height, scene.image.pixel_size) = (3, 2, 0.3);
    scene.camera.eye = Point::new(0.0, 1.0, 0.0);
    scene.camera.up = Vector::Z;
    put(&mut scene, Plane { point: Point::ORIGIN, normal: Vector::Y }, finish);
    let radius = FAR * tan(to_radians(degrees));
    let moon = Disk { center: Point::new(0.0, FAR, 0.0), normal: -Vector::Y, radius };
    let moon = put(&mut scene, moon, Emissive::new(5.0, Rgb::WHITE));
    shine(&mut scene, Area { object: moon.to_string(), sampling: None });
    with_samples(scene, 256)
}

/// Law: seen straight on, a lamp of angular radius α in the mirror direction is reflected with
/// `kr (1 − cos^(e+1) α)` of its radiance by the book's rule, and with `kr (1 − cos^(e+2) α)` by the
/// normalised one, in every pixel and with every tracer that follows the glossy ray. Oracle: the
/// integral of the lobe over the cone; means of 24 replicas.
/// Book: sampling around the mirror direction.
#[test]
fn a_moon_is_blurred_as_the_integral_of_the_lobe_says() {
    let depth = Depth { max_depth: 1 };
    let followed = [
        Tracer::Whitted(Whitted { max_depth: 1 }),
        Tracer::PathTrace(depth),
        Tracer::GlobalTrace(depth),
        Tracer::Path(depth),
    ];
    for (exponent, degrees) in [(1.0, 40.0), (10.0, 20.0), (200.0, 5.0)] {
        for (rule, more) in [(GlossyRule::Book, 1.0), (GlossyRule::Normalised, 2.0)] {
            let missed = power(cos(to_radians(degrees)), exponent + more);
            let expected = 5.0 * 0.8 * (1.0 - missed);
            for tracer in followed {
                let scene = under_a_moon(glossy(0.8, exponent, rule), degrees, tracer);
                let found = replicas(&scene, |world| {
                    let pixels: Vec<f64> = render(world).pixels().iter().map(|p| p.g).collect();
                    pixels.iter().sum::<f64>() / pixels.len() as f64
                });
                let what = format!("{rule:?}, e = {exponent}, {}", tracer.name());
                assert_mean(&what, &found, expected, 24, 0.02);
            }
        }
    }
}

/// Law: by the book's rule, no pixel of a glossy surface whose `k_r` is at most 1 is brighter than the
/// brightest object around it, at any angle. Oracle: the lamp's radiance, for each sample by itself; and
/// some samples must see the lamp.
/// Book: the reflected radiance: k_r c_r L.
#[test]
fn gloss_is_not_brighter_than_what_it_reflects() {
    for exponent in [0.0, 1.0, 30.0] {
        let brightest = [0.0, 1.0, 5.0, 30.0].map(|tilt| {
            let whitted = Tracer::Whitted(Whitted { max_depth: 1 });
            let mut scene = under_a_moon(glossy(1.0, exponent, GlossyRule::Book), 60.0, whitted);
            scene.camera.eye = Point::new(tilt, 1.0, 0.3 * tilt);
            scene.image.samples = 1;
            (scene.image.width, scene.image.height) = (24, 24);
            scene.image.pixel_size = 0.01;
            let world = built(&scene);
            (0..24 * 24).map(|i| pixel(&world, [i % 24, i / 24]).g).fold(0.0, f64::max)
        });
        let most = brightest.into_iter().fold(0.0, f64::max);
        assert!(most <= 5.0 * (1.0 + 1e-12), "e = {exponent}: {brightest:?} are more than 5");
        assert!(most > 4.99, "e = {exponent}: {brightest:?}: no sample sees the lamp");
    }
}
