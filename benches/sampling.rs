//! The cost of drawing one sample point, of mapping it, of applying a filter to it, and of building the
//! sample sets that it comes from.

use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};
use groundtruth::filters;
use groundtruth::math::{Pcg32, maps};
use groundtruth::samplers::{self, Purpose, SampleSets, SetKey};

/// Samples per pixel.
const N: u32 = 64;

/// The time of one draw; the `N` samples of each pixel are drawn in order.
fn draws(c: &mut Criterion) {
    let mut group = c.benchmark_group("draw");
    group.bench_function("uniform number of the generator", |b| {
        let mut random = Pcg32::new(0, 0);
        b.iter(|| random.uniform());
    });
    for (name, kind) in samplers::named() {
        let sampler = kind.build(&mut ()).expect("specimens are valid");
        let sets = SampleSets::new(&*sampler, N, 0);
        let mut count = 0;
        group.bench_function(name, |b| {
            b.iter(|| {
                count += 1;
                let key = SetKey::new(0, [black_box(count / N), 7], Purpose::Pixel);
                sets.draw(key, count % N)
            });
        });
    }
}

fn sets(c: &mut Criterion) {
    let mut group = c.benchmark_group("sets of 64");
    group.sample_size(20);
    for (name, kind) in samplers::named() {
        let sampler = kind.build(&mut ()).expect("specimens are valid");
        group.bench_function(name, |b| b.iter(|| SampleSets::new(&*sampler, black_box(N), 0)));
    }
}

/// Random points of the unit square, few enough for the first-level cache.
fn points() -> Vec<[f64; 2]> {
    let mut random = Pcg32::new(0, 0);
    (0..256).map(|_| [random.uniform(), random.uniform()]).collect()
}

/// The time of one call of `map`; the calls cycle through 256 points.
fn of_points<T>(b: &mut criterion::Bencher<'_>, map: impl Fn([f64; 2]) -> T) {
    let points = points();
    let mut next = 0;
    b.iter(|| {
        next = (next + 1) % points.len();
        map(black_box(points[next]))
    });
}

fn mapped(c: &mut Criterion) {
    let mut group = c.benchmark_group("map");
    group.bench_function("disk", |b| of_points(b, maps::disk));
    group.bench_function("hemisphere, e = 1", |b| of_points(b, |u| maps::hemisphere(u, 1.0)));
    group.bench_function("hemisphere, e = 2.5", |b| of_points(b, |u| maps::hemisphere(u, 2.5)));
    group.bench_function("sphere", |b| of_points(b, maps::sphere));
}

fn filtered(c: &mut Criterion) {
    let mut group = c.benchmark_group("filter, both axes");
    for entry in filters::Kind::ENTRIES {
        let filter = (entry.specimens)()[0].build(&mut ()).expect("specimens are valid");
        group.bench_function(entry.module, |b| of_points(b, |u| u.map(|u| filter.draw(u))));
    }
}

criterion_group!(benches, draws, sets, mapped, filtered);
criterion_main!(benches);
