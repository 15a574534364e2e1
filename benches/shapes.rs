//! The cost of one ray that hits and of one ray that misses, for each shape.

use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};
use groundtruth::accel::Method;
use groundtruth::kinds::Resources;
use groundtruth::math::{Aabb, Point, Ray, Span, Vector};
use groundtruth::shapes::{Context, Kind, Shape};

/// A ray that hits and a ray that misses. Both are the first such ray of 1024 that pass through the shape's
/// box, or through a box of side 2 if the shape is unbounded. If all rays hit, the miss is the hit reversed.
fn rays(shape: &dyn Shape) -> [Ray; 2] {
    let bounds = shape.bounds();
    let bounds = if bounds.is_bounded() {
        bounds
    } else {
        Aabb::around([Point::new(-1.0, -1.0, -1.0), Point::new(1.0, 1.0, 1.0)])
    };
    let grid_point = |i: u32, j: u32, k: u32| {
        let along = |axis: usize, step: u32| {
            let (low, high) = (bounds.min.along(axis), bounds.max.along(axis));
            low + (high - low) * (f64::from(step) + 0.5) / 8.0
        };
        Point::new(along(0, i), along(1, j), along(2, k))
    };
    let towards = |target: Point, from: Vector| Ray::new(target + 4.0 * from, -from);
    let all: Vec<Ray> = (0..512)
        .flat_map(|n| {
            let target = grid_point(n % 8, n / 8 % 8, n / 64);
            [Vector::new(0.3, 0.9, 0.4), Vector::new(-0.6, 0.1, 0.8)].map(|v| towards(target, v))
        })
        .collect();
    let hits = |ray: &&Ray| shape.hit(ray, Span::AHEAD).is_some();
    let hit = *all.iter().find(hits).expect("some ray hits");
    let away = Ray::new(hit.origin, -hit.direction);
    let miss = all.into_iter().find(|ray| !hits(&ray)).unwrap_or(away);
    [hit, miss]
}

fn shapes(c: &mut Criterion) {
    let mut context = Context::new(Resources::default(), Method::Bvh);
    for entry in Kind::ENTRIES {
        let specimen = &(entry.specimens)()[0];
        let shape = specimen.build(&mut context).expect("specimens are valid");
        let [hit, miss] = rays(&*shape);
        let mut group = c.benchmark_group(format!("shape/{}", entry.module));
        group.bench_function("hit", |b| b.iter(|| shape.hit(black_box(&hit), Span::AHEAD)));
        group.bench_function("miss", |b| b.iter(|| shape.hit(black_box(&miss), Span::AHEAD)));
    }
}

criterion_group!(benches, shapes);
criterion_main!(benches);
