//! The recorder's sums without a mistake.

use std::path::Path;

use groundtruth::render;
use groundtruth::world::{DEFAULT_SEED, World};
use judge::mistakes::{self, Mistake};

use super::stage::{bits, small};

/// Columns of the pictures.
const WIDTH: u32 = 24;

/// One scene of each kind of camera, light, material, filter and tracer.
const SCENES: [&str; 18] = [
    "ch04/checker-mitchell",
    "ch09/tilted-up",
    "ch11/fisheye-180",
    "ch12/three-spheres",
    "ch15/page-one",
    "ch16/coloured-shadows",
    "ch17/two-colours",
    "ch18/rectangle",
    "ch18/environment",
    "ch24/hall-of-mirrors",
    "ch25/glossy-hall",
    "ch26/cornell-box",
    "ch26/cornell-box-global-trace",
    "ch27/common-set",
    "ch28/glass-sphere",
    "ch28/snell-window",
    "ch28/three-filters",
    "ch29/sky-dome",
];

/// Law: without a mistake the recorder's picture is the tracer's, bit for bit, also while the pictures of all mistakes
/// are found beside it. Oracle: `render::render`, which records nothing.
#[test]
fn without_a_mistake_the_recorder_has_the_picture_of_the_tracer() {
    let terms = mistakes::all().into_iter().filter(|it| it.is_reweighed());
    let all: Vec<&Mistake> = terms.collect();
    for name in SCENES {
        let scene = small(name, WIDTH, 4);
        let world = World::build(&scene).expect("gallery scenes are valid");
        let expected = bits(&render::render(&world));
        for chosen in [&[] as &[&Mistake], &all] {
            let found = mistakes::replicas(chosen, (&scene, Path::new(""), DEFAULT_SEED));
            let ours = found.expect("gallery scenes are valid").ours;
            let ours: Vec<[u64; 3]> =
                ours.iter().map(|it| it.to_array().map(f64::to_bits)).collect();
            assert_eq!(ours, expected, "{name} beside {} mistakes", chosen.len());
        }
    }
}
