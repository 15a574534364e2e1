//! Questions about rays, cameras, samples, lights and textures, against closed forms.

use serde_json::json;
use testkit::properties::*;

use super::{ask, close, numbers};
use testkit::cases::laws;

/// A few dozen roundings of numbers below 100.
const ROUNDING: f64 = 1e-12;

proptest! {
    #![proptest_config(laws())]

    /// Law: the `n` draws of a pixel are the points of one of the 83 sets, each once.
    #[test]
    fn draws_of_a_pixel_use_up_one_set(pixel in (0_u32..4000, 0_u32..4000), seed in any::<u64>()) {
        let sampler = json!({"multi_jittered": {}});
        let sets = ask(&json!({"samples": {"sampler": sampler, "n": 9, "seed": seed, "sets": 83}}));
        let sorted = |mut points: Vec<Vec<f64>>| {
            points.sort_by(|a, b| a.partial_cmp(b).expect("numbers"));
            points
        };
        let drawn: Vec<Vec<f64>> = (0..9)
            .map(|index| {
                let draw = json!({"pixel": [pixel.0, pixel.1], "index": index});
                numbers(&ask(
                    &json!({"samples": {"sampler": sampler, "n": 9, "seed": seed, "draw": draw}}),
                ))
            })
            .collect();
        let drawn = sorted(drawn);
        let sets = sets.as_array().expect("sets");
        prop_assert_eq!(sets.len(), 83);
        let same = sets.iter().filter(|set| {
            sorted(set.as_array().expect("points").iter().map(numbers).collect()) == drawn
        });
        prop_assert_eq!(same.count(), 1);
    }
}

/// Law: a draw is the sample position in the pixel that the renderer uses, up to rounding on the film.
/// Oracle: the film position minus the pixel's corner.
#[test]
fn a_draw_is_where_the_renderer_samples() {
    let entry = gallery::find("ch28/glass-sphere").expect("it is in the gallery");
    let world = groundtruth::world::World::build(&(entry.build)()).expect("it is valid");
    let (size, half) = (world.image.pixel_size, 300.0);
    for (x, y, index) in [(0, 0, 0), (17, 430, 5), (599, 599, 15), (17, 431, 5)] {
        let sample = groundtruth::render::camera_sample(&world, [x, y], index);
        let film = sample.expect("the picture has no gap").film;
        let corner = [f64::from(x) - half, f64::from(599 - y) - half];
        let place = [film[0] / size - corner[0], film[1] / size - corner[1]];
        let draw = json!({"pixel": [x, y], "index": index});
        let sampler = json!({"multi_jittered": {}});
        let drawn = ask(&json!({"samples": {"sampler": sampler, "n": 16, "draw": draw}}));
        assert!(close(&drawn, &place, ROUNDING), "{x} {y} {index}: {drawn} for {place:?}");
    }
}
