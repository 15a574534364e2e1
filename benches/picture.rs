//! How long does a small picture of the glass sphere take, on all cores?

use criterion::{Criterion, criterion_group, criterion_main};
use groundtruth::render;
use groundtruth::world::World;

fn glass_sphere(c: &mut Criterion) {
    let entry = gallery::find("ch28/glass-sphere").expect("it is in the gallery");
    let mut scene = (entry.build)();
    scene.image.resize(96, 96);
    let world = World::build(&scene).expect("gallery scenes are valid");
    let mut group = c.benchmark_group("picture");
    group.sample_size(10);
    group.bench_function("glass-sphere/96x96", |b| b.iter(|| render::render(&world)));
}

criterion_group!(benches, glass_sphere);
criterion_main!(benches);
