//! Ambient occlusion of a mesh: our renderer compared with a hand-written loop over Embree. The image has
//! 512×512 pixels with 64 samples each; a sample is a camera ray and a cosine-distributed shadow ray. Both
//! programs use all processors and run in turns: `scripts/peers.sh occlusion`

#[path = "../../../bumpy.rs"]
#[allow(dead_code)] // only the other comparison uses its rays
mod bumpy;
#[path = "../embree.rs"]
mod embree;

use std::time::Instant;

use groundtruth::cameras::{Pinhole, Viewpoint};
use groundtruth::lights::AmbientOccluder;
use groundtruth::materials::Matte;
use groundtruth::math::{Frame, Normal, Pcg32, Point, Ray, Vector, maps};
use groundtruth::render::Canvas;
use groundtruth::rgb::Rgb;
use groundtruth::scene::{Image, Light, Material, Object, Scene};
use groundtruth::shapes::Mesh;
use groundtruth::world::World;
use rayon::prelude::*;

const SIDE: u32 = 512;
const SAMPLES: u32 = 64;
const ROUNDS: usize = 5;
const EYE: Point = Point::new(0.5, 1.0, 4.0);
/// From the eye to the view plane, in pixels: the mesh fills the picture.
const DISTANCE: f64 = 750.0;

fn world(vertices: &[Point], triangles: &[[u32; 3]]) -> World {
    let camera = Viewpoint::new(EYE, Point::ORIGIN, Pinhole { distance: DISTANCE, zoom: 1.0 });
    let image = Image { samples: SAMPLES, ..Image::new(SIDE, SIDE) };
    let mut scene = Scene::new("", image, camera);
    scene.lights.push(Light::new("sky", AmbientOccluder::default()));
    scene.materials.push(Material::new("chalk", Matte { ka: 1.0.into(), kd: 0.0.into(), cd: Rgb::WHITE.into() }));
    let mesh = Mesh::of_lists(vertices.to_vec(), triangles.to_vec());
    scene.objects.push(Object::new("mesh", "chalk", mesh));
    World::build(&scene).expect("the scene is valid")
}

/// Our mean of all pixels, and the time in seconds.
fn ours(world: &World) -> (f64, f64) {
    let start = Instant::now();
    let canvas = Canvas::new(world);
    canvas.render(world);
    let time = start.elapsed().as_secs_f64();
    let film = canvas.film();
    let sum: f64 = film.pixels().iter().map(|pixel| pixel.g).sum();
    (sum / film.pixels().len() as f64, time)
}

/// The same for the loop that a user of Embree would write: a jittered grid in the pixel, random numbers
/// for directions, a constant epsilon.
fn loop_over(scene: &embree::Scene) -> (f64, f64) {
    const EPSILON: f64 = 1e-4;
    let start = Instant::now();
    let frame = Frame::looking(EYE.to_vector(), Vector::Y).expect("a view");
    let root = SAMPLES.isqrt();
    let row = |y: u32| {
        let mut random = Pcg32::new(u64::from(y), 1);
        let mut sum = 0.0;
        for x in 0..SIDE {
            let mut open = 0;
            for i in 0..SAMPLES {
                let jitter = [i % root, i / root]
                    .map(|cell| (f64::from(cell) + random.uniform()) / f64::from(root));
                let film = [x, y].map(|at| f64::from(at) - 0.5 * f64::from(SIDE));
                let local = Vector::new(film[0] + jitter[0], film[1] + jitter[1], -DISTANCE);
                let direction = frame.to_world(local).unit().expect("not zero");
                let Some(hit) = scene.hit(&Ray::new(EYE, direction)) else { continue };
                let outward = Vector::from(hit.normal.map(f64::from));
                let outward = if outward.dot(direction) > 0.0 { -outward } else { outward };
                let normal = Normal::new(outward).expect("not zero");
                let u = [random.uniform(), random.uniform()];
                let wi = Frame::around(normal).to_world(maps::hemisphere(u, 1.0));
                let origin = EYE + hit.t * direction + EPSILON * Vector::from(normal);
                open += u32::from(!scene.is_occluded(&Ray::new(origin, wi)));
            }
            sum += f64::from(open) / f64::from(SAMPLES);
        }
        sum
    };
    let sum: f64 = (0..SIDE).into_par_iter().map(row).sum();
    (sum / f64::from(SIDE * SIDE), start.elapsed().as_secs_f64())
}

fn main() {
    let (vertices, triangles) = bumpy::bumpy_sphere(bumpy::STEPS);
    let world = world(&vertices, &triangles);
    let peer = embree::Scene::new(&vertices, &triangles, false);
    println!("{} triangles, {SIDE}×{SIDE}, {SAMPLES} samples", triangles.len());
    let mut ratios = Vec::new();
    for _ in 0..ROUNDS {
        let (mean, time) = ours(&world);
        print!("  groundtruth {time:.2} s (mean {mean:.5})");
        if let Some(peer) = &peer {
            let (peer_mean, peer_time) = loop_over(peer);
            print!(
                ", Embree loop {peer_time:.2} s (mean {peer_mean:.5}), ratio {:.2}",
                time / peer_time
            );
            ratios.push(time / peer_time);
        }
        println!();
    }
    ratios.sort_by(f64::total_cmp);
    if let Some(median) = ratios.get(ROUNDS / 2) {
        println!("median ratio {median:.2}");
    }
}
