//! Page 1: the intersection routines of the library and of the textbook, error against time.

mod drawing;
mod judging;
mod timing;

use oracle::hard::Family;
use rayon::prelude::*;
use serde::Serialize;

use self::judging::{Judged, TestedShape};
use super::{Findings, Interrupted, Page, ReportProgress, Settings};

/// Compares intersection routines by error, lost and wrong hits, and time.
pub const PAGE: Page = Page {
    name: "intersections",
    title: "Intersections: speed against error",
    question: "What is the cost of an intersection routine that is right on hard cases, compared with \
               the book's formula?",
    // one for each kind and family that is judged, and one for each kind that is timed
    steps: |_| ((Family::ALL.len() + 1) * TestedShape::all().count()) as u64,
    measure: |settings, progress| Ok(Findings::new(&measure(settings, progress)?, drawing::page)),
};

/// The data of the page.
#[derive(Serialize)]
struct Data {
    /// The number of rays for each shape and family, except those whose exact answer takes long.
    cases: usize,
    /// The kinds of shapes of the oracle, then the composite kinds.
    kinds: Vec<KindData>,
}

/// One kind of shape.
#[derive(Serialize)]
struct KindData {
    kind: String,
    /// The number of rays for each family.
    cases: usize,
    /// The results for each family of hard cases.
    families: Vec<FamilyData>,
}

/// One kind of shape on one family of hard cases.
#[derive(Default, Serialize)]
struct FamilyData {
    family: String,
    /// The number of shapes that the library rejects; their rays are skipped.
    refused: usize,
    /// The number of rays whose answer does not depend on rounding.
    judged: usize,
    /// The number of judged rays that hit.
    hits: usize,
    ours: Routine,
    textbook: Routine,
    /// Whether other programs disturbed the measurement of any of the times.
    disturbed: bool,
}

/// The errors and times of one routine.
#[derive(Default, Serialize)]
struct Routine {
    /// The median error of the distance, in units of u · cond.
    median: Option<f64>,
    /// The 99.9th percentile of the error; the worst error for fewer than 1000 hits.
    p999: Option<f64>,
    /// The worst error.
    worst: Option<f64>,
    /// The number of rays whose nearest hit was not found: a later one was found, or none.
    lost: usize,
    /// The number of rays that miss, for which a hit was found.
    wrong: usize,
    /// Nanoseconds for a ray that hits.
    hit_ns: Option<f64>,
    /// Nanoseconds for a ray that misses.
    miss_ns: Option<f64>,
}

impl KindData {
    /// The number of judged rays.
    fn judged(&self) -> usize {
        self.families.iter().map(|family| family.judged).sum()
    }
}

impl Routine {
    /// The number of lost and wrong hits.
    fn failures(&self) -> usize {
        self.lost + self.wrong
    }
}

/// Shapes of degree 4 and above, or of several parts: their exact answers take ten times as long.
const SLOW: &str = "Torus PartTorus Algebraic SolidCylinder SolidCone ThickRing FlatRimmedBowl \
                    ConcaveLens Compound RandomSpheres Lattice TessellatedSphere";
/// Shapes with parts of degree 4, or of dozens of parts.
const SLOWEST: &str = "RoundRimmedBowl BeveledBox BeveledCylinder BeveledRing BeveledWedge";

/// The number of rays for each family of a kind.
fn rays(kind: &str, settings: &Settings) -> usize {
    let is_in = |kinds: &str| kinds.split(' ').any(|it| it == kind);
    let divisor = match kind {
        _ if is_in(SLOW) => 4,
        _ if is_in(SLOWEST) => 16,
        _ => 1,
    };
    settings.cases.div_ceil(divisor)
}

fn measure(settings: &Settings, progress: &ReportProgress) -> Result<Data, Interrupted> {
    let mut kinds = Vec::new();
    for subject in TestedShape::all() {
        let cases = rays(&subject.name, settings);
        let judge = |&family: &Family| {
            progress.step()?;
            Ok(Judged::new(&subject, family, settings.seed, cases))
        };
        let judged: Vec<Judged> = Family::ALL.par_iter().map(judge).collect::<Result<_, _>>()?;
        // after the parallel part, so that other threads do not disturb the times
        let families = judged.into_iter().map(timing::timed).collect();
        progress.step()?;
        kinds.push(KindData { kind: subject.name, cases, families });
    }
    Ok(Data { cases: settings.cases, kinds })
}
