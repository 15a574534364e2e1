//! Page 2: acceleration structures, time against number of objects.

mod drawing;
mod measuring;
pub mod stages;
pub mod structures;

use serde::Serialize;

use self::stages::{STAGES, Stage};
use self::structures::Structure;
use super::{Findings, Page};

/// Compares acceleration structures by time, memory and tests, over the number of objects.
pub const PAGE: Page = Page {
    name: "acceleration",
    title: "Acceleration: time against number of objects",
    question: "Which structure finds the first hit fastest, for how many objects, in which scenes?",
    steps: |it| (STAGES.len() * sizes(it.objects).len() * Structure::ALL.len()) as u64,
    measure: |settings, progress| {
        let stages = STAGES.iter().map(|stage| measuring::stage(stage, settings, progress));
        let stages = stages.collect::<Result<_, _>>()?;
        Ok(Findings::new(&Data { side: settings.side, stages }, drawing::page))
    },
};

/// The data of the page.
#[derive(Serialize)]
struct Data {
    /// The width and height of the picture in pixels.
    side: u32,
    stages: Vec<StageData>,
}

/// One kind of scene.
#[derive(Serialize)]
struct StageData {
    /// Its name and description.
    #[serde(flatten)]
    stage: &'static Stage,
    runs: Vec<Run>,
    skipped: Vec<Skipped>,
    /// Whether all structures gave the same distances, bit for bit, for the rays that were
    /// compared.
    agree: bool,
}

/// The measurement of one structure and number of objects.
#[derive(Serialize)]
struct Run {
    structure: String,
    /// The number of objects or triangles.
    objects: usize,
    /// The elapsed time to build it, on all threads.
    build_seconds: f64,
    /// The memory of the structure, without the objects.
    memory_bytes: Option<u64>,
    /// The time to find the first hit of the ray of every pixel, on one thread.
    picture_seconds: f64,
    /// Whether other programs disturbed the measurement of `picture_seconds`.
    disturbed: bool,
    /// The number of rays that were timed, evenly spread over the picture; `picture_seconds` is
    /// extrapolated from them.
    timed_rays: usize,
    /// The number of objects tested per ray.
    tests_per_ray: f64,
    /// The number of nodes or cells visited per ray.
    steps_per_ray: f64,
}

/// A structure that was not measured.
#[derive(Serialize)]
struct Skipped {
    structure: String,
    /// The number of objects or triangles.
    objects: usize,
    why: String,
}

/// Numbers of objects, two for each factor of ten, up to `max`.
fn sizes(max: u32) -> Vec<u32> {
    let all = [100, 316, 1000, 3162, 10_000, 31_623, 100_000, 316_228, 1_000_000];
    all.into_iter().filter(|&n| n <= max.max(all[0])).collect()
}
