//! The cost of recording rays. `silent` records nothing: its time must not grow.

use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};
use explain::RayTree;
use groundtruth::render;
use groundtruth::trace::{RayCounts, Recorder};
use groundtruth::world::World;

/// A row of pixels through the sphere, so that many different paths are measured.
fn row<R: Recorder>(world: &World, mut recorder: impl FnMut() -> R) -> f64 {
    let [width, height] = [world.image.width, world.image.height];
    let columns = (0..width).step_by(16);
    let sample =
        |x| render::sample(world, black_box([x, height / 2]), 0, &mut recorder()).to_array()[0];
    columns.map(sample).sum()
}

fn recorder_cost(c: &mut Criterion) {
    let entry = gallery::find("ch28/glass-sphere").expect("it is in the gallery");
    let world = World::build(&(entry.build)()).expect("gallery scenes are valid");
    let mut group = c.benchmark_group("recorder/glass-sphere");
    group.bench_function("silent", |b| b.iter(|| row(&world, || ())));
    group.bench_function("counted", |b| b.iter(|| row(&world, RayCounts::default)));
    group.bench_function("recorded", |b| b.iter(|| row(&world, || RayTree::of(&world))));
}

criterion_group!(benches, recorder_cost);
criterion_main!(benches);
