//! Our mesh compared with those of other libraries: the same triangles, the same rays, one thread, one
//! process, in turns. Each time is the best of `ROUNDS` rounds; the result is the ratio to our time.
//!
//! `scripts/peers.sh`, or without Embree
//! `cargo run --release --manifest-path benches/peers/Cargo.toml`

#[path = "../../bumpy.rs"]
mod bumpy;
#[allow(dead_code)] // some of it is only used by the other comparison
mod embree;

use std::hint::black_box;
use std::time::{Duration, Instant};

use glam::Vec3A;
use groundtruth::accel::Method;
use groundtruth::mesh_bvh::Kernel;
use groundtruth::math::{Point, Ray, Span};
use groundtruth::shapes::{Shape, TriangleMesh};
use obvhs::cwbvh::builder::build_cwbvh_from_tris;
use obvhs::ray::RayHit;
use parry3d_f64::query::RayCast;

const SIDE: u32 = 1024;
const ROUNDS: usize = 7;
/// The largest share of rays on which a peer may differ from us, because of single precision and edges.
const DIFFERENT: f64 = 0.005;

/// Steps of the two meshes: 69 696 and 1 002 000 triangles.
const STEPS: [[u32; 2]; 2] = [bumpy::STEPS, [1002, 501]];

/// The mesh as built by one library; `hit` returns the distance of the first hit.
struct Peer {
    name: String,
    built: Duration,
    hit: Box<dyn Fn(&Ray) -> Option<f64>>,
}

fn timed<T>(build: impl FnOnce() -> T) -> (Duration, T) {
    let start = Instant::now();
    let built = build();
    (start.elapsed(), built)
}

fn ours(vertices: &[Point], triangles: &[[u32; 3]], kernel: Kernel) -> Peer {
    let (vertices, triangles) = (vertices.to_vec(), triangles.to_vec());
    let build = || TriangleMesh::new(vertices, triangles).accelerated_for(Method::Bvh, kernel);
    let (built, mesh) = timed(build);
    let megabytes = mesh.memory_bytes() as f64 / 1e6;
    let hit = move |ray: &Ray| mesh.hit(ray, Span::AHEAD).map(|hit| hit.t);
    let name = format!("groundtruth {kernel:?}, {megabytes:.1} MB");
    Peer { name, built, hit: Box::new(hit) }
}

fn embree(vertices: &[Point], triangles: &[[u32; 3]], robust: bool) -> Option<Peer> {
    let (built, scene) = timed(|| embree::Scene::new(vertices, triangles, robust));
    let scene = scene?;
    let name = if robust { "Embree 4, robust" } else { "Embree 4" }.to_owned();
    Some(Peer { name, built, hit: Box::new(move |ray| Some(scene.hit(ray)?.t)) })
}

fn parry(vertices: &[Point], triangles: &[[u32; 3]]) -> Peer {
    use parry3d_f64::math::Vector;
    let vertices = vertices.iter().map(|p| Vector::new(p.x(), p.y(), p.z())).collect();
    let triangles = triangles.to_vec();
    let build = || parry3d_f64::shape::TriMesh::new(vertices, triangles).expect("a mesh");
    let (built, mesh) = timed(build);
    let hit = move |ray: &Ray| {
        let ([x, y, z], [u, v, w]) = (ray.origin.to_array(), ray.direction.to_array());
        let ray = parry3d_f64::query::Ray::new(Vector::new(x, y, z), Vector::new(u, v, w));
        mesh.cast_local_ray(&ray, f64::MAX, false)
    };
    Peer { name: "parry3d-f64".to_owned(), built, hit: Box::new(hit) }
}

fn single([x, y, z]: [f64; 3]) -> Vec3A {
    Vec3A::new(x as f32, y as f32, z as f32)
}

/// Eight boxes at a time, in single precision.
fn obvhs(vertices: &[Point], triangles: &[[u32; 3]]) -> Peer {
    let corner = |i: u32| single(vertices[i as usize].to_array());
    let triangle = |&[a, b, c]: &[u32; 3]| obvhs::triangle::Triangle {
        v0: corner(a),
        v1: corner(b),
        v2: corner(c),
    };
    let triangles: Vec<_> = triangles.iter().map(triangle).collect();
    let parameters = obvhs::BvhBuildParams::medium_build();
    let build = || build_cwbvh_from_tris(&triangles, parameters, &mut Duration::default());
    let (built, bvh) = timed(build);
    let ordered: Vec<_> = bvh.primitive_indices.iter().map(|&i| triangles[i as usize]).collect();
    let hit = move |ray: &Ray| {
        let ray = obvhs::ray::Ray::new_inf(
            single(ray.origin.to_array()),
            single(ray.direction.to_array()),
        );
        let mut hit = RayHit::none();
        bvh.ray_traverse(ray, &mut hit, |ray, id| ordered[id].intersect(ray))
            .then(|| f64::from(hit.t))
    };
    Peer { name: "obvhs, 8 wide".to_owned(), built, hit: Box::new(hit) }
}

fn main() {
    if std::env::var_os("EMBREE").is_none() {
        println!("Embree is left out: EMBREE does not name its library (scripts/peers.sh)");
    }
    STEPS.into_iter().for_each(compare);
}

/// All peers on one mesh.
fn compare(steps: [u32; 2]) {
    let (vertices, triangles) = bumpy::bumpy_sphere(steps);
    let ours = Kernel::available().into_iter().map(|kernel| ours(&vertices, &triangles, kernel));
    let mut peers: Vec<Peer> = ours.collect();
    peers.extend([parry(&vertices, &triangles), obvhs(&vertices, &triangles)]);
    peers
        .extend([false, true].into_iter().flat_map(|robust| embree(&vertices, &triangles, robust)));
    println!("{} triangles; built in", triangles.len());
    for peer in &peers {
        println!("  {:42} {:7.1} ms", peer.name, 1e3 * peer.built.as_secs_f64());
    }
    let kinds = [
        ("coherent", bumpy::coherent_rays(SIDE)),
        ("incoherent", bumpy::incoherent_rays(SIDE * SIDE)),
    ];
    for (kind, rays) in kinds {
        let mut times = vec![Vec::new(); peers.len()];
        for _ in 0..ROUNDS {
            for (times, peer) in times.iter_mut().zip(&peers) {
                let (time, hits) = timed(|| {
                    rays.iter().filter(|ray| (peer.hit)(black_box(ray)).is_some()).count()
                });
                black_box(hits);
                times.push(time.as_secs_f64());
            }
        }
        println!("{kind} rays, first hit");
        let best: Vec<f64> =
            times.iter().map(|t| t.iter().copied().fold(f64::INFINITY, f64::min)).collect();
        for (time, peer) in best.iter().zip(&peers) {
            let different = rays.iter().filter(|ray| differs(ray, &peers[0], peer)).count();
            let share = different as f64 / rays.len() as f64;
            println!(
                "  {:42} {:6.2} M rays/s, {:5.2} × our time; {different} of {} rays differ",
                peer.name,
                1e-6 * rays.len() as f64 / time,
                time / best[0],
                rays.len(),
            );
            assert!(share <= DIFFERENT, "this is not the same mesh");
        }
    }
}

fn differs(ray: &Ray, one: &Peer, other: &Peer) -> bool {
    match ((one.hit)(ray), (other.hit)(ray)) {
        (Some(a), Some(b)) => (a - b).abs() > 1e-4,
        (a, b) => a.is_some() != b.is_some(),
    }
}
