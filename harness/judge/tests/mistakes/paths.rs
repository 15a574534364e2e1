//! Mistakes of path tracers and of sums of samples, on a plane below a white sky.

use std::f64::consts::PI;

use groundtruth::lights::Environment;
use groundtruth::math::{Point, power};
use groundtruth::rgb::Rgb;
use groundtruth::scene::build::*;
use groundtruth::scene::{Depth, Scene, Tracer};

use super::stage::*;

const KD: f64 = 0.5;
/// Of means over 4096 stratified samples.
const NOISE: f64 = 0.01;

fn under_a_sky(tracer: Tracer, samples: u32) -> Scene {
    let mut scene = plane(matte(0.0, KD, Rgb::WHITE), 30.0);
    scene.background = Rgb::WHITE.into();
    scene.tracer = tracer;
    scene.image.samples = samples;
    scene
}

/// Law: without its last of four samples the sky counts ¾. Oracle: each sample is `k_d`.
#[test]
fn a_missing_last_sample() {
    let mut scene = under_a_sky(Tracer::RayCast, 4);
    light(&mut scene, Environment {});
    expect("last-light-sample-left-out", &scene, 0.75 * KD, ROUNDING);
    expect("last-sample-left-out", &scene, 0.75 * KD, ROUNDING);
}

/// Law: a sky that is sampled, and counts where paths hit it, too, counts twice. Oracle: `2 k_d`.
#[test]
fn a_sky_that_counts_twice() {
    let mut scene = under_a_sky(Tracer::GlobalTrace(Depth { max_depth: 1 }), 4);
    light(&mut scene, Environment {});
    expect("light-counted-twice", &scene, 2.0 * KD, ROUNDING);
    scene.tracer = Tracer::Path(Depth { max_depth: 1 });
    expect("light-counted-twice", &scene, 2.0 * KD, ROUNDING);
}

/// Law: of two ways to find the same light, whose weights add up to 1, both wrong pictures together have twice the light: what one
/// weight takes from a way, the other gives to it. Oracle: the light of a disk above, `k_d R²/(R² + h²)`.
#[test]
fn weights_of_two_ways_to_find_a_lamp() {
    let mut scene = under_a_sky(Tracer::Path(Depth { max_depth: 1 }), 1 << 14);
    scene.background = Rgb::BLACK.into();
    // beside the lamp
    scene.camera.eye = Point::ORIGIN + 10.0 * at_angle(60.0);
    let center = point(0.0, 2.0, 0.0);
    let disk = groundtruth::shapes::Disk { center, normal: vector(0.0, -1.0, 0.0), radius: 3.0 };
    add(&mut scene, "lamp", disk, groundtruth::materials::Emissive::new(1.0, Rgb::WHITE));
    light(&mut scene, groundtruth::lights::Area { object: "lamp".to_owned(), sampling: None });
    let whole = KD * 9.0 / 13.0;
    /// Of means over 2¹⁴ samples; two heuristics change the light by 1.1 %.
    const SMALL: f64 = 0.005;
    for (name, form) in [
        ("mis-two-heuristics", "the other way round"),
        ("mis-other-weight", "or where a path hits them"),
    ] {
        let [one, other] = [value(&with(name, &scene)), value(&with_form(name, form, &scene))];
        assert!((one / whole - 1.0).abs() > 1.6 * SMALL, "{name}: {one} is as bright as {whole}");
        assert!((0.5 * (one + other) / whole - 1.0).abs() < SMALL, "{name}: {one}, {other}");
    }
}

/// Law: a sky of four columns that is sampled a column off lights a slope as the sky with its columns moved. Oracle: that
/// sky.
#[test]
fn a_sky_that_is_sampled_turned() {
    let under = |column: usize| {
        let mut scene = plane(matte(0.0, KD, Rgb::WHITE), 30.0);
        let (point, normal) = (point(0.0, 0.0, 0.0), vector(1.0, 1.0, 0.5));
        scene.objects[0].shape = groundtruth::shapes::Plane { point, normal }.into();
        let mut sky = groundtruth::background::Image::of_file("", Default::default());
        let row = (0..4).map(|i| if i == column { Rgb::WHITE } else { Rgb::BLACK }).collect();
        (sky.file, sky.texels) = (None, Some(vec![row]));
        scene.background = sky.into();
        scene.image.samples = 4096;
        light(&mut scene, Environment {});
        scene
    };
    let expected = value(&ours(&under(1)));
    assert!(expected > 0.1, "{expected}");
    expect("sky-sampled-turned", &under(0), expected, NOISE);
}

/// Law: with a second cosine, or without their density, paths have the means `2/3` and `2/3π` over directions by the
/// cosine. Oracle: these integrals.
#[test]
fn weights_of_diffuse_paths() {
    let scene = under_a_sky(Tracer::PathTrace(Depth { max_depth: 1 }), 4096);
    expect("path-cosine-twice", &scene, KD * 2.0 / 3.0, NOISE);
    expect("path-without-density", &scene, KD * 2.0 / (3.0 * PI), NOISE);
    expect("path-without-reflectance", &scene, 1.0, ROUNDING);
    expect("path-pi-twice", &scene, KD / PI, ROUNDING);
    // 2 cosθ, of which the mean by the cosine is 4/3
    let even = "with the density 1/2π of even directions";
    expect_form("path-cosine-twice", even, &scene, KD * 4.0 / 3.0, NOISE);
    expect("no-background-in-mirrors", &scene, 0.0, 0.0);
}

/// Law: a path that takes each of two lobes with the probability q, and is not divided by it, counts `Σ q ρ`. Oracle:
/// the albedos. The highlight of exponent 0 scatters evenly: its albedo is `π k_s`, its probability is in proportion to
/// `π k_s` as that of the other to `k_d`.
#[test]
fn a_choice_that_is_not_compensated() {
    let mut scene = under_a_sky(Tracer::PathTrace(Depth { max_depth: 1 }), 4096);
    let ks = 0.1;
    let two = phong(0.0, KD, Rgb::WHITE, ks, 0.0);
    scene.materials[0].recipe = two.into();
    // the selection weight of a highlight is k_s · min(1, 2π/(e + 2))
    let (highlight, q) = (PI * ks, ks / (ks + KD));
    let expected = (1.0 - q) * KD + q * highlight;
    expect("choice-not-compensated", &scene, expected, 2.0 * NOISE);
}

/// Law: after five edges a path survives with a probability of at most its throughput, here ρ⁶, ρ⁷ …; not compensated, it
/// loses that factor at each of these hits. Oracle: the sum of a furnace of albedo ρ without its lost part, by hand.
#[test]
fn a_roulette_that_is_not_compensated() {
    // inside a white-hot sphere of albedo ½ that is seen at every depth, L = Σ ρ^k for k = 0 … max_depth
    let (rho, max_depth) = (0.5_f64, 7);
    let mut scene = under_a_sky(Tracer::Path(Depth { max_depth }), 1 << 14);
    scene.objects.clear();
    scene.materials.clear();
    let glow = groundtruth::materials::Emissive {
        matte: Some(matte(0.0, rho, Rgb::WHITE)),
        ..groundtruth::materials::Emissive::new(1.0, Rgb::WHITE)
    };
    let inside =
        groundtruth::shapes::Sphere { center: point(0.0, 0.0, 0.0), radius: 50.0, inward: true };
    add(&mut scene, "furnace", inside, glow);
    // the hits of depth 0 to 4 are compensated in full: weights ρ; those of depth 5 and 6 survive with the probability
    // ρ⁶ and 1 after it (the throughput is 1 then), and not compensated their mean weights are ρ·ρ⁶ and ρ·ρ
    let weights = [rho, rho, rho, rho, rho, rho * power(rho, 6.0), rho * rho];
    let expected = weights.iter().rev().fold(1.0, |sum, weight| 1.0 + weight * sum);
    // our own picture is 1.2 % brighter
    expect("roulette-not-compensated", &scene, expected, 0.002);
}
