//! The Cornell box, against a reference picture and against its mirror image.

use groundtruth::render::render;
use std::fmt::Write as _;

use crate::prelude::*;
use crate::support::replicas::{LEVEL, REPLICAS, assert_known, mean_and_error};

/// Pixels across and down.
const SIDE: u32 = 16;

/// Means and standard errors written by [`cornell_reference_is_made`]: one line for each of three channels,
/// for each pixel and then for the mean of the picture.
const REFERENCE: &str = include_str!("cornell_reference.txt");

/// The number of independent pictures behind the reference. It is even, as [`as_values`] needs.
const REFERENCE_REPLICAS: u64 = 32;

fn cornell_box(tracer: Tracer, samples: u32) -> Scene {
    let mut scene = (gallery::find("ch26/cornell-box").expect("in the gallery").build)();
    scene.image.resize(SIDE, SIDE);
    scene.tracer = tracer;
    with_samples(scene, samples)
}

/// The values of all replicas, for each channel of each pixel and then of the picture's mean.
fn pictures(scene: &Scene) -> Vec<Vec<f64>> {
    let of_each = replicas(scene, |world| channels(render(world).pixels()));
    transposed(&of_each)
}

fn channels(pixels: &[Rgb]) -> Vec<f64> {
    let mean = (1.0 / pixels.len() as f64) * pixels.iter().copied().sum::<Rgb>();
    pixels.iter().copied().chain([mean]).flat_map(Rgb::to_array).collect()
}

fn transposed(of_each: &[Vec<f64>]) -> Vec<Vec<f64>> {
    (0..of_each[0].len()).map(|i| of_each.iter().map(|values| values[i]).collect()).collect()
}

/// Values with this mean and standard error; a t test depends on nothing else.
fn as_values([mean, error]: [f64; 2]) -> Vec<f64> {
    let apart = error * (REFERENCE_REPLICAS as f64 - 1.0).sqrt();
    (0..REFERENCE_REPLICAS).map(|i| if i % 2 == 0 { mean + apart } else { mean - apart }).collect()
}

fn reference() -> Vec<Vec<f64>> {
    let numbers = REFERENCE.lines().filter(|line| !line.starts_with('#')).map(|line| {
        let mut numbers = line.split(' ').map(|text| text.parse().expect("a number"));
        as_values(std::array::from_fn(|_| numbers.next().expect("mean and error")))
    });
    numbers.collect()
}

/// Fails if two sets of estimates differ significantly in any mean. Pixels that are nearly dark or see only
/// the box's rim are left out: a mean with a standard error above 10 % comes from too few paths for a t test.
fn assert_agree(what: &str, a: &[Vec<f64>], b: &[Vec<f64>], tests: usize) {
    assert_eq!(a.len(), b.len(), "{what}: the pictures differ in size");
    let mut compared = 0;
    for (i, (a, b)) in a.iter().zip(b).enumerate() {
        let p = means::two_samples(a, b);
        let [(a, e), (b, f)] = [a, b].map(|values| mean_and_error(values));
        if e > 0.1 * a || f > 0.1 * b {
            continue;
        }
        compared += 1;
        let place = match i / 3 {
            all if all as u32 == SIDE * SIDE => "the whole picture".to_owned(),
            at => format!("pixel [{}, {}]", at as u32 % SIDE, at as u32 / SIDE),
        };
        assert!(
            p > sidak(LEVEL, tests),
            "{what}, {place}, channel {}: {a} ± {e:e} and {b} ± {f:e}, p = {p:e}",
            i % 3
        );
    }
    assert!(2 * compared > a.len(), "{what}: only {compared} of {} are compared", a.len());
}

/// Law: `path` and `global_trace` render the same Cornell box as `path_trace`, which never samples a light.
/// Oracle: the committed picture, by `path_trace` with 2¹⁴ samples and other seeds, and its variance; Welch's
/// t of each pixel and of the whole, which is known to 0.5 %.
/// Book: the Cornell box.
#[test]
fn the_cornell_box_is_the_reference() {
    let (reference, depth) = (reference(), Depth { max_depth: 10 });
    for (tracer, samples) in [(Tracer::Path(depth), 64), (Tracer::GlobalTrace(depth), 144)] {
        let found = pictures(&cornell_box(tracer, samples));
        assert_agree(tracer.name(), &found, &reference, 2 * reference.len());
        for channel in &found[found.len() - 3..] {
            assert_known(tracer.name(), channel, 0.005);
        }
    }
}

/// Makes the reference anew, into the file beside this one:
/// `cargo test cornell_reference_is_made -- --ignored`.
#[test]
#[ignore = "cost: cargo test cornell_reference_is_made -- --ignored"]
fn cornell_reference_is_made() {
    let mut world = built(&cornell_box(Tracer::PathTrace(Depth { max_depth: 10 }), 1 << 14));
    let of_each: Vec<Vec<f64>> = (0..REFERENCE_REPLICAS)
        .map(|seed| {
            world.reseed(1_000_000 + seed);
            channels(render(&world).pixels())
        })
        .collect();
    let mut text = String::from(
        "# ch26/cornell-box, 16 x 16 pixels from the top left, path_trace of depth 10: mean and its\n\
         # standard error, a line for each of three channels; last the means of the whole picture.\n\
         # Made by: cargo test cornell_reference_is_made -- --ignored\n",
    );
    for values in transposed(&of_each) {
        let (mean, error) = mean_and_error(&values);
        writeln!(text, "{mean:.5e} {error:.2e}").expect("text grows");
    }
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/chapters/ch26/cornell_reference.txt");
    std::fs::write(path, text).expect("the folder can be written to");
}

/// The mirror image of the scene: x is reversed between the walls.
fn mirrored(mut scene: Scene) -> Scene {
    let point = |p: Point| p.with(0, 55.28 - p.x());
    let vector = |v: Vector| Vector::new(-v.x(), v.y(), v.z());
    (scene.camera.eye, scene.camera.look_at) =
        (point(scene.camera.eye), point(scene.camera.look_at));
    for object in &mut scene.objects {
        let Kind::Rectangle(it) = &object.shape else { panic!("{object:?}") };
        // `a` and `b` are swapped so that the lamp still faces down
        let (a, b) = (vector(it.b), vector(it.a));
        object.shape = Rectangle { corner: point(it.corner), a, b }.into();
    }
    scene
}

/// Law: if the Cornell box is mirrored (red and green wall swapped; blocks, lamp and eye mirrored), its
/// picture is mirrored. Oracle: the mirrored picture; Welch's t of each pixel and of the whole.
/// Book: the Cornell box.
#[test]
fn swapped_walls_show_the_mirrored_picture() {
    let scene = cornell_box(Tracer::Path(Depth { max_depth: 10 }), 16);
    let [found, other] = [&mirrored(scene.clone()), &scene].map(pictures);
    let turned: Vec<Vec<f64>> = (0..found.len())
        .map(|i| {
            let (at, channel) = (i as u32 / 3, i % 3);
            let (x, y) = (at % SIDE, at / SIDE);
            let from = if at == SIDE * SIDE { at } else { y * SIDE + (SIDE - 1 - x) };
            found[from as usize * 3 + channel].clone()
        })
        .collect();
    assert_agree("mirrored", &turned, &other, other.len());
    // and the picture differs from its own mirror image
    let unturned = found.iter().zip(&other).filter(|(a, b)| means::two_samples(a, b) < 1e-9);
    assert!(unturned.count() > 20, "the box looks the same from both sides");
    assert_eq!(other[0].len() as u64, REPLICAS);
}
