//! Measures each structure on each scene, for increasing numbers of objects.

use std::hint::black_box;

use super::stages::{Objects, Stage};
use super::structures::{BuiltStructure, Counts, Structure};
use super::{Run, Skipped, StageData, sizes};
use crate::clock::{medians, time};
use crate::{Interrupted, ReportProgress, Settings};
use groundtruth::accel::Method;
use groundtruth::math::Ray;

/// The number of rays whose hits are compared and whose tests are counted first.
const PROBES: usize = 256;
/// The number of rays whose tests are counted if they are few.
const COUNTED: usize = 4096;
/// Structures that test more objects per ray are skipped: they are almost lists.
const MAX_TESTS: f64 = 2e5;
/// The approximate number of tests in one round of timing: a tenth of a second.
const TESTS: f64 = 1e7;
/// The number of rounds of timing.
const ROUNDS: usize = 3;

pub fn stage(
    stage: &'static Stage,
    settings: &Settings,
    progress: &ReportProgress,
) -> Result<StageData, Interrupted> {
    let rays = stage.rays(settings.side);
    let mut data = StageData { stage, runs: Vec::new(), skipped: Vec::new(), agree: true };
    for n in sizes(settings.objects) {
        let objects = (stage.objects)(n, settings.seed);
        let mut expected = None;
        for structure in Structure::ALL {
            match run(structure, &objects, &rays) {
                Ok((run, answers)) => {
                    data.agree &= *expected.get_or_insert_with(|| answers.clone()) == answers;
                    data.runs.push(run);
                }
                Err(why) => {
                    let (structure, objects) = (structure.name(), objects.count());
                    data.skipped.push(Skipped { structure, objects, why });
                }
            }
            progress.step()?;
        }
    }
    Ok(data)
}

/// The distances of the hits of some rays.
type Answers = Vec<Option<f64>>;

/// Builds the structure, counts tests, and times some rays; an error is the reason to skip it.
fn run(structure: Structure, objects: &Objects, rays: &[Ray]) -> Result<(Run, Answers), String> {
    let many = |tests: f64| format!("each ray tests {tests:.0} objects");
    let all = objects.count() as f64;
    match structure {
        Structure::Nested(_) if objects.groups.is_empty() => {
            return Err("the scene has no groups to nest".to_owned());
        }
        Structure::Plain(Method::List) if all > MAX_TESTS => return Err(many(all)),
        _ => {}
    }
    // on all threads: only the elapsed time is meaningful
    let (built, building) = time(|| structure.build(objects, objects.mesh.as_ref()));
    // of a mesh: over its triangles as shapes, with the same boxes
    let counted = structure.build(objects, None);
    let probes = spread(rays, PROBES);
    let [mut tests, mut steps] = count(&counted, objects, &probes);
    if tests > MAX_TESTS {
        return Err(many(tests));
    }
    let answers = probes.iter().map(|ray| built.nearest(objects, ray, [(); 2])).collect();
    if tests * (COUNTED as f64) < TESTS {
        [tests, steps] = count(&counted, objects, &spread(rays, COUNTED));
    }

    let affordable = (TESTS / tests.max(1.0)) as usize;
    let timed = spread(rays, affordable.max(PROBES));
    let mut picture = || {
        for ray in &timed {
            black_box(built.nearest(objects, black_box(ray), [(); 2]));
        }
    };
    let round = medians(ROUNDS, &mut [&mut picture])[0];
    let run = Run {
        structure: structure.name(),
        objects: objects.count(),
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

/// At most `max` of the rays, spread over the picture by the golden ratio, in order.
fn spread(rays: &[Ray], max: usize) -> Vec<&Ray> {
    if max >= rays.len() {
        return rays.iter().collect();
    }
    let golden = 0.5 * (5.0_f64.sqrt() - 1.0);
    let index = |i: usize| ((i as f64 * golden).fract() * rays.len() as f64) as usize;
    let mut indices: Vec<usize> = (0..max).map(index).collect();
    indices.sort_unstable();
    indices.into_iter().map(|i| &rays[i]).collect()
}

/// Tests, and nodes or cells, per ray.
fn count(built: &BuiltStructure, objects: &Objects, rays: &[&Ray]) -> [f64; 2] {
    let (groups, within) = (Counts::default(), Counts::default());
    for ray in rays {
        built.nearest(objects, ray, [&groups, &within]);
    }
    let steps = groups.steps.get() + within.steps.get();
    [within.tests.get(), steps].map(|total| total as f64 / rays.len() as f64)
}
