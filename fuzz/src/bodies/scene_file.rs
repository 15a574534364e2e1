//! The scene file: any text gives a world or one error with its position, in bounded time and memory.

use std::path::Path;

use groundtruth::render::{self, Renderer};
use groundtruth::trace;
use groundtruth::trace::RayBudget;
use scenefile::from_toml;
use scenefile::to_toml;

/// Rows and columns of pixels that are sampled in each world.
const CORNERS: u32 = 2;
/// The largest number of ray-object tests of one sample: larger ray trees take too long here.
const MAX_TESTS: f64 = 1e5;

/// Reads a scene, traces a few of its rays, writes it and reads it again.
pub fn run(data: &[u8]) {
    let Ok(text) = std::str::from_utf8(data) else { return };
    let path = Path::new("fuzz/no-such-folder/scene.toml");
    let (scene, world) = match from_toml(text, path) {
        Ok(read) => read,
        Err(error) => {
            let message = error.to_string();
            assert!(message.starts_with("fuzz/no-such-folder/scene.toml"), "no place: {message}");
            return;
        }
    };

    let written = to_toml(&scene).expect("a scene from a file can be written");
    let (again, _) = from_toml(&written, path).expect("what is written can be read");
    let twice = to_toml(&again).expect("a scene from a file can be written");
    assert_eq!(written, twice, "writing and reading change nothing");

    let [width, height] = world.picture_size();
    let max_rays = (MAX_TESTS / (1.0 + world.objects().len() as f64)) as u64;
    for y in 0..CORNERS.min(height) {
        for x in 0..CORNERS.min(width) {
            let mut budget = RayBudget::up_to(max_rays);
            world.sample([x, y], 0, &mut (), &mut budget);
            if budget.is_exceeded() {
                return;
            }
            let mut counts = trace::RayCounts::default();
            let recorded = render::sample(&world, [x, y], 0, &mut counts);
            let unrecorded = render::sample(&world, [x, y], 0, &mut ());
            let bits = |color: groundtruth::rgb::Rgb| color.to_array().map(f64::to_bits);
            assert_eq!(bits(recorded), bits(unrecorded), "a recorder cannot change the picture");
            let has_ray = render::camera_sample(&world, [x, y], 0).is_some_and(|s| s.ray.is_some());
            assert_eq!(counts.camera, u64::from(has_ray));
        }
    }
}
