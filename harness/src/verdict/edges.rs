//! Pixels on an edge: their colour changes when their rays move by a rounding error.

use groundtruth::render;
use groundtruth::rgb::Rgb;
use groundtruth::trace;
use groundtruth::world::World;

use super::stored::Stored;

/// The rays move by so many pixels in each direction.
const STEP: f64 = 1e-6;

/// Whether the stored colour of a pixel changes when its rays move by a millionth of a pixel: on which side of an edge
/// such a pixel falls, a renderer's rounding decides.
pub fn is_edge(world: &World, pixel: [u32; 2], stored: Stored) -> bool {
    let value = |color: Rgb| {
        let mut film = groundtruth::film::Film::new(1, 1);
        film.set([0, 0], color);
        stored.values(&film)
    };
    let here = value(moved(world, pixel, [0.0, 0.0]));
    [[-1.0, -1.0], [1.0, -1.0], [-1.0, 1.0], [1.0, 1.0]].into_iter().any(|direction| {
        let there = value(moved(world, pixel, direction.map(|along: f64| along * STEP)));
        here.iter().zip(there).any(|(x, y)| {
            let [x, y] = [*x, y].map(f64::from);
            (x - y).abs() > stored.tolerance(x)
        })
    })
}

/// The pixel, with film points moved by so many pixels.
fn moved(world: &World, pixel: [u32; 2], [dx, dy]: [f64; 2]) -> Rgb {
    let size = world.image.pixel_size;
    let samples = (0..world.samples_per_pixel()).map(|index| {
        let Some((eye, _)) = world.view.eye_of_column(pixel[0], world.image.width) else {
            return Rgb::BLACK;
        };
        let Some(sample) = render::camera_sample(world, pixel, index) else { return Rgb::BLACK };
        let film = [sample.film[0] + dx * size, sample.film[1] + dy * size];
        let draws = world.draws(sample.pixel, index);
        match eye.ray(film, sample.lens.unwrap_or_default()) {
            Some(ray) => sample.weight * trace::radiance(world, &ray, draws, &mut ()),
            None => Rgb::BLACK,
        }
    });
    render::expose(world, samples)
}
