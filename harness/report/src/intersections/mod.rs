//! Page 1: the intersection routines of the library and of the textbook, error against time.

mod drawing;
mod judging;
mod timing;

use oracle::hard::Family;
use rayon::prelude::*;
use serde::Serialize;

use self::judging::{Judged, Subject};
use super::{Findings, Interrupted, Page, Progress, Settings};

/// Compares intersection routines by error, lost and wrong hits, and time.
pub struct Intersections;

/// The data of the page.
#[derive(Clone, Debug, Serialize)]
pub struct Data {
    /// The number of rays for each shape and family, except those whose exact answer takes long.
    pub cases: usize,
    /// The kinds of shapes of the oracle, then the composite kinds.
    pub kinds: Vec<KindData>,
}

/// One kind of shape.
#[derive(Clone, Debug, Serialize)]
pub struct KindData {
    /// Its name.
    pub kind: String,
    /// The number of rays for each family.
    pub cases: usize,
    /// The results for each family of hard cases.
    pub families: Vec<FamilyData>,
}

/// One kind of shape on one family of hard cases.
#[derive(Clone, Debug, Serialize)]
pub struct FamilyData {
    /// Its name.
    pub family: String,
    /// The number of shapes that the library rejects; their rays are skipped.
    pub refused: usize,
    /// The number of rays whose answer does not depend on rounding.
    pub judged: usize,
    /// The number of judged rays that hit.
    pub hits: usize,
    /// The library's routine.
    pub ours: Routine,
    /// The textbook's routine.
    pub textbook: Routine,
    /// Whether other programs disturbed the measurement of any of the times.
    pub disturbed: bool,
}

/// The errors and times of one routine.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Routine {
    /// The median error of the distance, in units of u · cond.
    pub median: Option<f64>,
    /// The 99.9th percentile of the error; the worst error for fewer than 1000 hits.
    pub p999: Option<f64>,
    /// The worst error.
    pub worst: Option<f64>,
    /// The number of rays whose nearest hit was not found: a later one was found, or none.
    pub lost: usize,
    /// The number of rays that miss, for which a hit was found.
    pub wrong: usize,
    /// Nanoseconds for a ray that hits.
    pub hit_ns: Option<f64>,
    /// Nanoseconds for a ray that misses.
    pub miss_ns: Option<f64>,
}

/// Shapes of degree 4 and above, or of several parts: their exact answers take ten times as long.
const SLOW: [&str; 12] = [
    "Torus",
    "PartTorus",
    "Algebraic",
    "SolidCylinder",
    "SolidCone",
    "ThickRing",
    "FlatRimmedBowl",
    "ConcaveLens",
    "Compound",
    "RandomSpheres",
    "Lattice",
    "TessellatedSphere",
];
/// Shapes with parts of degree 4, or of dozens of parts.
const SLOWEST: [&str; 5] =
    ["RoundRimmedBowl", "BeveledBox", "BeveledCylinder", "BeveledRing", "BeveledWedge"];

/// The number of rays for each family of a kind.
fn rays(kind: &str, settings: &Settings) -> usize {
    let divisor = match kind {
        kind if SLOW.contains(&kind) => 4,
        kind if SLOWEST.contains(&kind) => 16,
        _ => 1,
    };
    settings.cases.div_ceil(divisor)
}

impl Page for Intersections {
    fn name(&self) -> &'static str {
        "intersections"
    }

    fn title(&self) -> &'static str {
        "Intersections: speed against error"
    }

    fn question(&self) -> &'static str {
        "What is the cost of an intersection routine that is right on hard cases, compared with the \
         book's formula?"
    }

    /// One step for each kind and family that is judged, and one for each kind that is timed.
    fn steps(&self, _: &Settings) -> u64 {
        ((Family::ALL.len() + 1) * Subject::all().count()) as u64
    }

    fn run(
        &self,
        settings: &Settings,
        progress: &Progress,
    ) -> Result<Box<dyn Findings>, Interrupted> {
        let mut kinds = Vec::new();
        for subject in Subject::all() {
            let name = subject.name();
            let cases = rays(&name, settings);
            let judge = |&family: &Family| {
                progress.step()?;
                Ok(Judged::new(subject, family, settings.seed, cases))
            };
            let judged: Vec<Judged> =
                Family::ALL.par_iter().map(judge).collect::<Result<_, _>>()?;
            // after the parallel part, so that other threads do not disturb the times
            let families = judged.into_iter().map(timing::timed).collect();
            progress.step()?;
            kinds.push(KindData { kind: name, cases, families });
        }
        Ok(Box::new(Data { cases: settings.cases, kinds }))
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
