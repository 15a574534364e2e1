//! Page 2: acceleration structures, time against number of objects.

mod drawing;
mod measuring;
pub mod stages;
pub mod structures;

use serde::Serialize;

use self::stages::STAGES;
use self::structures::Structure;
use super::{Findings, Interrupted, Page, Progress, Settings};

/// Compares acceleration structures by time, memory and tests, over the number of objects.
pub struct Acceleration;

/// The data of the page.
#[derive(Clone, Debug, Serialize)]
pub struct Data {
    /// The width and height of the picture in pixels.
    pub side: u32,
    /// The results for each kind of scene.
    pub stages: Vec<StageData>,
}

/// One kind of scene.
#[derive(Clone, Debug, Serialize)]
pub struct StageData {
    /// Its name.
    pub stage: String,
    /// Its contents and purpose.
    pub about: String,
    /// The measurements.
    pub runs: Vec<Run>,
    /// The structures that were not measured.
    pub skipped: Vec<Skipped>,
    /// Whether all structures gave the same distances, bit for bit, for the rays that were
    /// compared.
    pub agree: bool,
}

/// The measurement of one structure and number of objects.
#[derive(Clone, Debug, Serialize)]
pub struct Run {
    /// The structure's name.
    pub structure: String,
    /// The number of objects or triangles.
    pub objects: usize,
    /// The elapsed time to build it, on all threads.
    pub build_seconds: f64,
    /// The memory of the structure, without the objects.
    pub memory_bytes: Option<u64>,
    /// The time to find the first hit of the ray of every pixel, on one thread.
    pub picture_seconds: f64,
    /// Whether other programs disturbed the measurement of `picture_seconds`.
    pub disturbed: bool,
    /// The number of rays that were timed, evenly spread over the picture; `picture_seconds` is
    /// extrapolated from them.
    pub timed_rays: usize,
    /// The number of objects tested per ray.
    pub tests_per_ray: f64,
    /// The number of nodes or cells visited per ray.
    pub steps_per_ray: Option<f64>,
}

/// A structure that was not measured.
#[derive(Clone, Debug, Serialize)]
pub struct Skipped {
    /// The structure's name.
    pub structure: String,
    /// The number of objects or triangles.
    pub objects: usize,
    /// The reason.
    pub why: String,
}

/// Numbers of objects, two for each factor of ten, up to `max`.
fn sizes(max: u32) -> Vec<u32> {
    let all = [100, 316, 1000, 3162, 10_000, 31_623, 100_000, 316_228, 1_000_000];
    all.into_iter().filter(|&n| n <= max.max(all[0])).collect()
}

impl Page for Acceleration {
    fn name(&self) -> &'static str {
        "acceleration"
    }

    fn title(&self) -> &'static str {
        "Acceleration: time against number of objects"
    }

    fn question(&self) -> &'static str {
        "Which structure finds the first hit fastest, for how many objects, in which scenes?"
    }

    fn steps(&self, settings: &Settings) -> u64 {
        (STAGES.len() * sizes(settings.objects).len() * Structure::all().len()) as u64
    }

    fn run(
        &self,
        settings: &Settings,
        progress: &Progress,
    ) -> Result<Box<dyn Findings>, Interrupted> {
        let mut data = Data { side: settings.side, stages: Vec::new() };
        for stage in STAGES {
            data.stages.push(measuring::stage(stage, settings, progress)?);
        }
        Ok(Box::new(data))
    }
}

impl Findings for Data {
    fn data(&self) -> serde_json::Result<serde_json::Value> {
        serde_json::to_value(self)
    }

    fn drawing(&self) -> String {
        drawing::page(self)
    }
}
