//! Page 1: intersections, ours beside the textbook's: error against time.

mod drawing;
mod judging;
mod timing;

use oracle::hard::Family;
use rayon::prelude::*;
use serde::Serialize;

use self::judging::{Judged, Subject};
use super::{Findings, Interrupted, Page, Settings, Watch};

/// Which intersection routine to use: by error, lost and wrong hits, and nanoseconds.
pub struct Intersections;

/// What the page shows.
#[derive(Clone, Debug, Serialize)]
pub struct Data {
    /// Rays for each shape and family, but for those whose exact answer takes long.
    pub cases: usize,
    /// One for each kind of shape that the oracle knows, then one for each composite kind.
    pub kinds: Vec<KindData>,
}

/// One kind of shape.
#[derive(Clone, Debug, Serialize)]
pub struct KindData {
    /// Its name.
    pub kind: String,
    /// Rays for each family.
    pub cases: usize,
    /// One for each family of hard cases.
    pub families: Vec<FamilyData>,
}

/// One kind of shape on one family of hard cases.
#[derive(Clone, Debug, Serialize)]
pub struct FamilyData {
    /// Its name.
    pub family: String,
    /// Shapes that the library refuses to build; their rays are left out.
    pub refused: usize,
    /// Rays whose answer does not turn on rounding.
    pub judged: usize,
    /// Those of them that hit.
    pub hits: usize,
    /// The library's routine.
    pub ours: Routine,
    /// The textbook's.
    pub textbook: Routine,
    /// Whether other programs took turns with the measurement of any of the times.
    pub disturbed: bool,
}

/// How good one routine is.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Routine {
    /// The median error of the distance, in units of u · cond.
    pub median: Option<f64>,
    /// The 99.9th percentile of the error; of fewer than 1000 hits, the worst.
    pub p999: Option<f64>,
    /// The worst error.
    pub worst: Option<f64>,
    /// Rays whose nearest hit was not found: a later one, or none.
    pub lost: usize,
    /// Rays that hit nothing, for which a hit was found.
    pub wrong: usize,
    /// Nanoseconds for a ray that hits.
    pub hit_ns: Option<f64>,
    /// Nanoseconds for a ray that misses.
    pub miss_ns: Option<f64>,
}

/// Of degree 4 and above, or of some parts: their exact answers take ten times as long as the
/// others'.
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
/// Of parts of degree 4, or of some dozens of parts.
const SLOWEST: [&str; 5] =
    ["RoundRimmedBowl", "BeveledBox", "BeveledCylinder", "BeveledRing", "BeveledWedge"];

/// The number of rays for each family of a kind.
fn rays(kind: &str, settings: &Settings) -> usize {
    let share = match kind {
        kind if SLOW.contains(&kind) => 4,
        kind if SLOWEST.contains(&kind) => 16,
        _ => 1,
    };
    settings.cases.div_ceil(share)
}

impl Page for Intersections {
    fn name(&self) -> &'static str {
        "intersections"
    }

    fn title(&self) -> &'static str {
        "Intersections: speed against error"
    }

    fn question(&self) -> &'static str {
        "What does an intersection that is right on hard cases cost, beside the book's formula?"
    }

    /// Each kind and family is judged, and each kind is timed.
    fn steps(&self, _: &Settings) -> u64 {
        ((Family::ALL.len() + 1) * Subject::all().count()) as u64
    }

    fn run(&self, settings: &Settings, watch: &Watch) -> Result<Box<dyn Findings>, Interrupted> {
        let mut kinds = Vec::new();
        for subject in Subject::all() {
            let name = subject.name();
            let cases = rays(&name, settings);
            let judge = |&family: &Family| {
                watch.step()?;
                Ok(Judged::new(subject, family, settings.seed, cases))
            };
            let judged: Vec<Judged> =
                Family::ALL.par_iter().map(judge).collect::<Result<_, _>>()?;
            // when all threads are at rest
            let families = judged.into_iter().map(timing::timed).collect();
            watch.step()?;
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
