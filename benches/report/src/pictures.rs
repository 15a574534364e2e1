//! Pictures of several seeds, rendered and timed.

use rayon::prelude::*;

use crate::clock::{self, Time};
use crate::{Interrupted, ReportProgress};
use groundtruth::film::Film;
use groundtruth::render;
use groundtruth::scene::Scene;
use groundtruth::world::World;

/// Pictures of one number of samples: each scene with each seed.
pub struct Series {
    samples: u32,
    scenes: Vec<Scene>,
    seeds: Vec<u64>,
}

/// The pictures of a series.
pub struct Pictures {
    pub samples: u32,
    /// The pictures of the first scene by all seeds, then those of the next scene.
    pub films: Vec<Film>,
    /// The median time for one picture on one thread.
    pub time: Time,
}

impl Series {
    /// The pictures of these scenes.
    pub fn new(
        samples: u32,
        scenes: impl IntoIterator<Item = Scene>,
        seeds: impl IntoIterator<Item = u64>,
    ) -> Self {
        let mut scenes: Vec<Scene> = scenes.into_iter().collect();
        scenes.iter_mut().for_each(|scene| scene.image.samples = samples);
        Self { samples, scenes, seeds: seeds.into_iter().collect() }
    }

    pub fn count(&self) -> u32 {
        (self.scenes.len() * self.seeds.len()) as u32
    }
}

/// Renders all pictures of all series, each on one thread and with one progress step.
pub fn rendered(
    series: &[Series],
    progress: &ReportProgress,
) -> Result<Vec<Pictures>, Interrupted> {
    let scenes: Vec<(&Scene, &[u64])> = series
        .iter()
        .flat_map(|series| series.scenes.iter().map(|scene| (scene, &*series.seeds)))
        .collect();
    // in order, so that the results do not depend on the number of threads
    let shots: Result<Vec<Vec<(Film, Time)>>, Interrupted> = scenes
        .into_par_iter()
        .with_max_len(1)
        .map(|(scene, seeds)| {
            let mut world = World::build(scene).expect("the scenes of the pages are valid");
            let shot = |seed: &u64| {
                world.reseed(*seed);
                let shot = clock::time(|| picture(&world));
                progress.step()?;
                Ok(shot)
            };
            seeds.iter().map(shot).collect()
        })
        .collect();
    let mut shots = shots?.into_iter().flatten();
    let of_series = |series: &Series| {
        let (films, times): (Vec<Film>, Vec<Time>) =
            shots.by_ref().take(series.count() as usize).unzip();
        Pictures { samples: series.samples, films, time: Time::median(&times) }
    };
    Ok(series.iter().map(of_series).collect())
}

/// Renders a whole picture on this thread.
fn picture(world: &World) -> Film {
    let [width, height] = world.picture_size();
    let mut film = Film::new(width, height);
    for pixel in (0..height).flat_map(|y| (0..width).map(move |x| [x, y])) {
        film.set(pixel, render::pixel(world, pixel));
    }
    film
}
