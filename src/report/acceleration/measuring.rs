//! Each structure on each scene, for more and more objects.

use std::hint::black_box;

use super::stages::{Stage, Things};
use super::structures::{BuiltStructure, Counts, Structure};
use super::{Run, Skipped, StageData, sizes};
use crate::math::Ray;
use crate::report::clock::{medians, time};
use crate::report::{Interrupted, Settings, Watch};

/// Rays whose answers are compared and whose costs are counted first.
const PROBES: usize = 256;
/// Rays whose costs are counted where that does not take long.
const COUNTED: usize = 4096;
/// Structures that test more objects for each ray are left out: they are lists, nearly.
const MOST_TESTS: f64 = 2e5;
/// Tests in one round of timing, about: a tenth of a second.
const TESTS: f64 = 1e7;
/// Rounds of timing.
const ROUNDS: usize = 3;

pub fn stage(stage: &Stage, settings: &Settings, watch: &Watch) -> Result<StageData, Interrupted> {
    let rays = stage.rays(settings.side);
    let mut data = StageData {
        stage: stage.name.to_owned(),
        about: stage.about.to_owned(),
        runs: Vec::new(),
        skipped: Vec::new(),
        agree: true,
    };
    for n in sizes(settings.objects) {
        let things = (stage.things)(n, settings.seed);
        let mut expected = None;
        for structure in Structure::all() {
            match run(structure, &things, &rays) {
                Ok((run, answers)) => {
                    data.agree &= *expected.get_or_insert_with(|| answers.clone()) == answers;
                    data.runs.push(run);
                }
                Err(why) => {
                    let (structure, objects) = (structure.name(), things.count());
                    data.skipped.push(Skipped { structure, objects, why });
                }
            }
            watch.step()?;
        }
    }
    Ok(data)
}

/// The distances that some rays find.
type Answers = Vec<Option<f64>>;

/// Builds, counts, then times as many rays as there is time for; or says why not.
fn run(structure: Structure, things: &Things, rays: &[Ray]) -> Result<(Run, Answers), String> {
    if let Some(why) = structure.unfit(things) {
        return Err(why.to_owned());
    }
    let many = |tests: f64| format!("each ray tests {tests:.0} objects");
    if structure.is_exhaustive() && things.count() as f64 > MOST_TESTS {
        return Err(many(things.count() as f64));
    }
    // by all threads: the time of this one says nothing
    let (built, building) = time(|| structure.build(things));
    let counted = structure.build_counted(things);
    let probes = spread(rays, PROBES);
    let (mut tests, mut steps) = count(&counted, things, &probes);
    if tests > MOST_TESTS {
        return Err(many(tests));
    }
    let answers = probes.iter().map(|ray| built.nearest(things, ray, None)).collect();
    if tests * (COUNTED as f64) < TESTS {
        (tests, steps) = count(&counted, things, &spread(rays, COUNTED));
    }

    let affordable = (TESTS / tests.max(1.0)) as usize;
    let timed = spread(rays, affordable.max(PROBES));
    let mut picture = || {
        for ray in &timed {
            black_box(built.nearest(things, black_box(ray), None));
        }
    };
    let round = medians(ROUNDS, &mut [&mut picture])[0];
    let run = Run {
        structure: structure.name(),
        objects: things.count(),
        build_seconds: building.wall,
        memory_bytes: counted.memory_bytes(),
        picture_seconds: round.cpu * rays.len() as f64 / timed.len() as f64,
        disturbed: round.is_disturbed(),
        timed_rays: timed.len(),
        tests_per_ray: tests,
        steps_per_ray: steps,
    };
    Ok((run, answers))
}

/// At most so many of the rays, spread over the picture by the golden ratio, in their order.
fn spread(rays: &[Ray], most: usize) -> Vec<&Ray> {
    if most >= rays.len() {
        return rays.iter().collect();
    }
    let golden = 0.5 * (5.0_f64.sqrt() - 1.0);
    let place = |i: usize| ((i as f64 * golden).fract() * rays.len() as f64) as usize;
    let mut places: Vec<usize> = (0..most).map(place).collect();
    places.sort_unstable();
    places.into_iter().map(|i| &rays[i]).collect()
}

/// Tests, and nodes or cells, for each ray.
fn count(built: &BuiltStructure, things: &Things, rays: &[&Ray]) -> (f64, Option<f64>) {
    let counts = Counts::default();
    for ray in rays {
        built.nearest(things, ray, Some(&counts));
    }
    let each = |total: u64| total as f64 / rays.len() as f64;
    (each(counts.tests.get()), counts.steps.get().map(each))
}
