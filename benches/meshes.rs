//! Ray queries per second on a mesh of 70 000 triangles, and the time to build the mesh.

#[path = "bumpy.rs"]
mod bumpy;

use std::hint::black_box;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use groundtruth::accel::Method;
use groundtruth::math::Span;
use groundtruth::shapes::{Shape, TriangleMesh};

/// One measurement casts `SIDE`² rays.
const SIDE: u32 = 64;

fn meshes(c: &mut Criterion) {
    let (vertices, triangles) = bumpy::bumpy_sphere(bumpy::STEPS);
    let build = || TriangleMesh::new(vertices.clone(), triangles.clone()).accelerated(Method::Bvh);
    let mut group = c.benchmark_group("mesh");
    group.sample_size(10);
    group.bench_function("build", |b| b.iter(build));

    let mesh = build();
    group.throughput(Throughput::Elements(u64::from(SIDE * SIDE)));
    let rays = [
        ("coherent", bumpy::coherent_rays(SIDE)),
        ("incoherent", bumpy::incoherent_rays(SIDE * SIDE)),
    ];
    for (name, rays) in &rays {
        let hits = || rays.iter().filter(|ray| mesh.hit(black_box(ray), Span::AHEAD).is_some());
        group.bench_function(format!("nearest/{name}"), |b| b.iter(|| hits().count()));
        let shadows =
            || rays.iter().filter(|ray| mesh.shadow_hit(black_box(ray), Span::AHEAD).is_some());
        group.bench_function(format!("shadow/{name}"), |b| b.iter(|| shadows().count()));
    }
}

criterion_group!(benches, meshes);
criterion_main!(benches);
