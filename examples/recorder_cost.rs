//! Renders a small glass sphere on one thread with the recorder that the command line names, for
//! the instruction counts of `docs/performance.md`:
//!
//! ```text
//! cargo build --release --example recorder_cost
//! for r in none silent deaf counted; do
//!     valgrind --tool=callgrind target/release/examples/recorder_cost $r
//! done
//! ```
use groundtruth::lobes::Lobes;
use groundtruth::math::Ray;
use groundtruth::render;
use groundtruth::rgb::Rgb;
use groundtruth::trace::{Outcome, RayCounts, RayKind, Recorder, ShadingPoint, Term};
use groundtruth::world::World;

const SIDE: u32 = 48;

/// A recorder that ignores its arguments but is called: its methods are never inlined, so each call that the
/// tracer makes to a recorder is an instruction that can be counted.
struct Deaf;

impl Recorder for Deaf {
    #[inline(never)]
    fn enter(&mut self, _: RayKind, ray: &Ray, _: u32, _: Rgb) {
        std::hint::black_box(ray);
    }
    #[inline(never)]
    fn hit(&mut self, point: &ShadingPoint<'_>, _: &Lobes) {
        std::hint::black_box(point);
    }
    #[inline(never)]
    fn term(&mut self, term: Term) {
        std::hint::black_box(&term);
    }
    #[inline(never)]
    fn leave(&mut self, outcome: Outcome, _: Rgb, arriving: Rgb) {
        std::hint::black_box((&outcome, &arriving));
    }
}

#[inline(never)]
fn picture<R: Recorder>(world: &World, recorder: &mut R) -> f64 {
    let mut sum = 0.0;
    for y in 0..SIDE {
        for x in 0..SIDE {
            sum += render::sample(world, [x, y], 0, recorder).to_array()[0];
        }
    }
    sum
}

fn main() {
    let mut scene = (gallery::find("ch28/glass-sphere").expect("it is in the gallery").build)();
    scene.image.resize(SIDE, SIDE);
    scene.image.samples = 1;
    let world = World::build(&scene).expect("gallery scenes are valid");
    let recorder = std::env::args().nth(1).unwrap_or_default();
    let sum = match recorder.as_str() {
        "none" => 0.0, // everything except rendering
        "silent" => picture(&world, &mut ()),
        "deaf" => picture(&world, &mut Deaf),
        "counted" => picture(&world, &mut RayCounts::default()),
        _ => {
            eprintln!("usage: recorder_cost none|silent|deaf|counted");
            std::process::exit(2);
        }
    };
    println!("{recorder}: {sum}");
}
