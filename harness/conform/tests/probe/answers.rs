//! Questions about rays, cameras, samples, lights and textures, against closed forms.

use serde_json::json;

use super::{ask, close};

/// A few dozen roundings of numbers below 100.
const ROUNDING: f64 = 1e-12;

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
