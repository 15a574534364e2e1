//! The recorder's sums without a mistake.

use std::path::Path;

use groundtruth::render;
use groundtruth::world::{DEFAULT_SEED, World};
use judge::mistakes::{self, Mistake};

use super::stage::{bits, small};

/// Columns of the pictures.
const WIDTH: u32 = 24;

/// Law: without a mistake the recorder's picture is the tracer's, bit for bit, also while the pictures of all mistakes
/// are found beside it. Oracle: `render::render`, which records nothing.
#[test]
fn without_a_mistake_the_recorder_has_the_picture_of_the_tracer() {
    let terms = mistakes::all().into_iter().filter(|it| it.is_reweighed());
    let all: Vec<&Mistake> = terms.collect();
    // a scene of almost every chapter
    for gallery::Entry { name, .. } in gallery::scenes().step_by(13) {
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
