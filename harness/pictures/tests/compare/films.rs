//! Small pictures of scenes, also through other points of the pixels.

use std::path::Path;

use groundtruth::film::Film;
use groundtruth::rgb::Rgb;
use groundtruth::{render, trace, world::World};

/// Columns and rows.
pub const SIZE: [u32; 2] = [60, 40];

/// A small picture of a scene, from this seed.
pub fn rendered(name: &str, seed: u64) -> Film {
    let mut scene = gallery::find(name).map(|entry| (entry.build)()).expect("listed");
    scene.image.resize(SIZE[0], SIZE[1]);
    scene.image.samples = 4;
    let world = World::build_seeded(&scene, Path::new(""), seed).expect("gallery scenes are valid");
    render::render(&world)
}

/// A scene as a world of one sample per pixel.
pub fn world(name: &str) -> World {
    let mut scene = gallery::find(name).map(|entry| (entry.build)()).expect("listed");
    scene.image.resize(SIZE[0], SIZE[1]);
    scene.image.samples = 1;
    World::build(&scene).expect("gallery scenes are valid")
}

/// The picture of a world from rays through these points of its pixels, in pixels from the lower left corners.
pub fn film_through(world: &World, point: [f64; 2]) -> Film {
    let mut film = Film::new(SIZE[0], SIZE[1]);
    for pixel in (0..SIZE[1]).flat_map(|y| (0..SIZE[0]).map(move |x| [x, y])) {
        let ray =
            world.view.eyes()[0].ray(render::film_point(&world.image, pixel, point), [0.0; 2]);
        let radiance = |ray| trace::radiance(world, &ray, world.draws(pixel, 0), &mut ());
        film.set(pixel, ray.map_or(Rgb::BLACK, radiance));
    }
    film
}
