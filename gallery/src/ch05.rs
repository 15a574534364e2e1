//! Chapter 5: sampling techniques, shown by the soft shadow of an area light (chapter 18).

use super::List;
use groundtruth::lights::Area;
use groundtruth::materials::{Emissive, Reflective};
use groundtruth::math::Vector;
use groundtruth::rgb::Rgb;
use groundtruth::samplers::{Hammersley, Kind as Sampler, NRooks, Random};
use groundtruth::scene::build::*;
use groundtruth::scene::{Light, Scene, Tracer, Whitted};
use groundtruth::shapes::Rectangle;

pub const SCENES: List = &[
    ("ch05/lamp", || {
        let about = "as figure 5.13b: a mirror sphere under a lamp, 100 multi-jittered samples";
        under_a_lamp(about, 100, None)
    }),
    ("ch05/lamp-random", || {
        let about = "as figure 5.13: 16 random samples leave noise in the shadow";
        under_a_lamp(about, 16, Some(Random {}.into()))
    }),
    ("ch05/lamp-n-rooks", || {
        let about = "as figure 5.13: 16 n-rooks samples, between random and multi-jittered ones";
        under_a_lamp(about, 16, Some(NRooks {}.into()))
    }),
    ("ch05/lamp-hammersley", || {
        let about =
            "as figure 5.13: 16 samples of Hammersley's set, the same in every pixel: bands";
        under_a_lamp(about, 16, Some(Hammersley { shifted: false }.into()))
    }),
];

/// Figure 5.13; the materials of sphere and ground are ours. (The artefacts that the book shows,
/// patterns from two uses that draw samples in the same order, cannot occur here: every use has its
/// own permutation.)
fn under_a_lamp(about: &str, samples: u32, sampler: Option<Sampler>) -> Scene {
    let view = [point(30.0, 13.0, 20.0), point(0.0, -2.0, 0.0)];
    let mut scene = pinhole(about, [400, 400], view, 12_000.0);
    scene.image.samples = samples;
    scene.image.sampler = sampler;
    scene.tracer = Tracer::Whitted(Whitted { max_depth: 2 });
    scene.lights.push(Light::new("lamp light", Area { object: "lamp".to_owned(), sampling: None }));
    let chrome = Reflective {
        phong: phong(0.0, 0.1, Rgb::WHITE, 0.0, 1.0),
        kr: 0.85.into(),
        cr: Rgb::WHITE.into(),
    };
    add(&mut scene, "sphere", sphere(point(0.0, -2.0, 0.0), 0.5), chrome);
    let lamp =
        Rectangle { corner: point(-1.0, -0.5, -1.0), a: 2.0 * Vector::X, b: 2.0 * Vector::Z };
    add(&mut scene, "lamp", lamp, Emissive::new(3.0, Rgb::WHITE));
    let squares = checker3d(0.5, grey(0.5), Rgb::WHITE);
    add(&mut scene, "ground", ground(-2.75), matte(0.0, 0.75, squares));
    scene
}
