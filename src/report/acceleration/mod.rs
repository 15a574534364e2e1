//! Page 2: acceleration, time against number of objects.

mod drawing;
mod measuring;
mod stages;
mod structures;

use serde::Serialize;

use self::stages::STAGES;
use self::structures::Structure;
use super::{Findings, Interrupted, Page, Settings, Watch};

/// Which acceleration structure to use: by time, memory and tests, over the number of objects.
pub struct Acceleration;

/// What the page shows.
#[derive(Clone, Debug, Serialize)]
pub struct Data {
    /// Pixels along each side of the picture.
    pub side: u32,
    /// One for each kind of scene.
    pub stages: Vec<StageData>,
}

/// One kind of scene.
#[derive(Clone, Debug, Serialize)]
pub struct StageData {
    /// Its name.
    pub stage: String,
    /// What it is made of, and why it is here.
    pub about: String,
    /// What was measured.
    pub runs: Vec<Run>,
    /// What was not, and why.
    pub skipped: Vec<Skipped>,
    /// Whether all structures gave the same distances, to the last bit, on the rays that were
    /// compared.
    pub agree: bool,
}

/// One structure over so many objects.
#[derive(Clone, Debug, Serialize)]
pub struct Run {
    /// The structure's name.
    pub structure: String,
    /// Objects, or triangles.
    pub objects: usize,
    /// Seconds to build it, on all threads, by the clock on the wall.
    pub build_seconds: f64,
    /// What the structure takes, without the objects.
    pub memory_bytes: Option<u64>,
    /// Seconds to find the first hit of the ray of every pixel, on one thread.
    pub picture_seconds: f64,
    /// Whether other programs took turns with the measurement of `picture_seconds`.
    pub disturbed: bool,
    /// So many of those rays were timed, evenly spread; the rest is their share.
    pub timed_rays: usize,
    /// Objects tested for each ray.
    pub tests_per_ray: f64,
    /// Nodes or cells visited for each ray.
    pub steps_per_ray: Option<f64>,
}

/// One structure that would take too long.
#[derive(Clone, Debug, Serialize)]
pub struct Skipped {
    /// The structure's name.
    pub structure: String,
    /// Objects, or triangles.
    pub objects: usize,
    /// Why.
    pub why: String,
}

/// Numbers of objects, two for each factor of ten, up to `most`.
fn sizes(most: u32) -> Vec<u32> {
    let all = [100, 316, 1000, 3162, 10_000, 31_623, 100_000, 316_228, 1_000_000];
    all.into_iter().filter(|&n| n <= most.max(all[0])).collect()
}

impl Page for Acceleration {
    fn name(&self) -> &'static str {
        "acceleration"
    }

    fn title(&self) -> &'static str {
        "Acceleration: time against number of objects"
    }

    fn question(&self) -> &'static str {
        "Which structure finds the first hit soonest, among how many objects, in which scenes?"
    }

    fn steps(&self, settings: &Settings) -> u64 {
        (STAGES.len() * sizes(settings.objects).len() * Structure::all().len()) as u64
    }

    fn run(&self, settings: &Settings, watch: &Watch) -> Result<Box<dyn Findings>, Interrupted> {
        let mut data = Data { side: settings.side, stages: Vec::new() };
        for stage in STAGES {
            data.stages.push(measuring::stage(stage, settings, watch)?);
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
