//! Pictures for time measurements.

use groundtruth::film::Film;
use groundtruth::render;
use groundtruth::world::World;

/// Renders a whole picture on this thread.
pub fn picture(world: &World) -> Film {
    let [width, height] = world.picture_size();
    let mut film = Film::new(width, height);
    for pixel in (0..height).flat_map(|y| (0..width).map(move |x| [x, y])) {
        film.set(pixel, render::pixel(world, pixel));
    }
    film
}
