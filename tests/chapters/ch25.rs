//! Chapter 25: glossy reflection.
//!
//! | of the book | what is held | by the law |
//! | --- | --- | --- |
//! | the reflected radiance: k_r c_r L | by the book's rule uniform surroundings of radiance L are reflected as `k_r L`, by each sample exactly and at every angle | `uniform_surroundings_are_seen_times_the_reflectance` |
//! |  | by the book's rule, no pixel of a glossy surface whose `k_r` is at most 1 is brighter than the brightest object around it, at any angle | `gloss_is_not_brighter_than_what_it_reflects` |
//! | sampling around the mirror direction | every sampled direction of gloss is above the surface, also at grazing angles; by the book's rule no sample is lost | `every_direction_is_above_the_surface` |
//! |  | the mean of `r·ω_i`, with the mirror direction r, is `(e + 1)/(e + 2)`; rotation about r does not change it | `the_mean_cosine_to_the_mirror_direction_is_that_of_the_power` |
//! |  | seen from straight above, the blur is the same in all directions around the mirror direction: the mean of x, y and xy is 0, and x² and y² have one mean | `the_blur_is_round` |
//! |  | seen straight on, a lamp of angular radius α in the mirror direction is reflected with `kr (1 − cos^(e+1) α)` of its radiance by the book's rule, and with `kr (1 − cos^(e+2) α)` by the normalised one, with every tracer that follows the glossy ray | `a_moon_is_blurred_as_the_integral_of_the_lobe_says` |
//! | the exponent of the reflection | with a growing exponent the reflection tends to the mirror's, at the edge of a reflected ball too | `a_large_exponent_is_a_mirror` |
//! |  | highlight and reflection each have their own exponent: neither changes the other | `highlight_and_reflection_have_exponents_of_their_own` |
//! | the material GlossyReflector and the tracers | a glossy hit casts one ray and draws one pair of numbers; ray casting neither | `a_glossy_hit_costs_one_ray_and_one_draw` |
//!
//! Beyond the book: 1 in this file, 1 in `tests/laws/ch25.toml`.

use groundtruth::lobes::GlossyReflection;
use groundtruth::render::pixel;

use crate::prelude::*;
use crate::support::stage::{counted, ray, recorded};

laws_of_light!(
    "ch25":
    uniform_surroundings_are_seen_times_the_reflectance,
    a_moon_is_blurred_as_the_integral_of_the_lobe_says,
    the_normalised_rule_is_darker_away_from_the_normal,
);

/// The probability, over the choice of seeds, that at least one statistical test of this file fails
/// although all its laws hold.
const LEVEL: f64 = 1e-3;
const TESTS: usize = 9;

fn glossy(kr: f64, exponent: f64, rule: GlossyRule) -> GlossyReflector {
    GlossyReflector {
        phong: Phong::default(),
        kr: kr.into(),
        cr: Rgb::WHITE.into(),
        exponent: exponent.into(),
        rule,
    }
}

/// Directions of viewers, from straight above to nearly grazing.
fn viewers() -> impl Iterator<Item = Vector> {
    [1.0, 0.8, 0.3, 0.05, 1e-3].into_iter().map(|c: f64| {
        let sine = ((1.0 - c) * (1.0 + c)).sqrt();
        Vector::new(sine * cos(0.7), sine * sin(0.7), c)
    })
}

fn samples_of(lobe: GlossyReflection, wo: Vector, count: u32) -> Vec<Vector> {
    let mut random = Pcg32::new(25, 0);
    let lobe = Lobe::from(lobe);
    let one = |_| lobe.sample(wo, [random.uniform(), random.uniform()]).map(|sample| sample.wi);
    (0..count).filter_map(one).collect()
}

/// Law: every sampled direction of gloss is above the surface, also at grazing angles; by the book's rule
/// no sample is lost. Oracle: the sign of z.
/// Book: sampling around the mirror direction.
#[test]
fn every_direction_is_above_the_surface() {
    for rule in [GlossyRule::Book, GlossyRule::Normalised] {
        for (wo, exponent) in viewers().zip([0.0, 1.0, 5.0, 50.0, 1e4]) {
            let lobe = GlossyReflection { reflectance: Rgb::WHITE, exponent, rule };
            let all = samples_of(lobe, wo, 2000);
            assert!(all.iter().all(|wi| wi.z() > 0.0), "{rule:?}, {wo:?}");
            let lost = 2000 - all.len();
            assert!(rule == GlossyRule::Normalised || lost == 0, "{wo:?}: {lost} are lost");
        }
    }
}

/// Law: the mean of `r·ω_i`, with the mirror direction r, is `(e + 1)/(e + 2)`; rotation about r does not
/// change it. Oracle: that integral; t test of batches.
/// Book: sampling around the mirror direction.
#[test]
fn the_mean_cosine_to_the_mirror_direction_is_that_of_the_power() {
    for (wo, exponent) in viewers().zip([1.0, 3.0, 10.0, 100.0, 1000.0]) {
        let lobe = GlossyReflection { reflectance: Rgb::WHITE, exponent, rule: GlossyRule::Book };
        let r = Vector::new(-wo.x(), -wo.y(), wo.z());
        let cosines: Vec<f64> = samples_of(lobe, wo, 40_000).iter().map(|wi| r.dot(*wi)).collect();
        let batches: Vec<f64> = cosines.chunks(1000).map(|b| b.iter().sum::<f64>() / 1e3).collect();
        let expected = (exponent + 1.0) / (exponent + 2.0);
        let p = means::one_sample(&batches, expected);
        assert!(p > sidak(LEVEL, TESTS), "e = {exponent}: p = {p:e} for {expected}");
    }
}

/// Law: seen from straight above, the blur is the same in all directions around the mirror direction: the
/// mean of x, y and xy is 0, and x² and y² have one mean. Oracle: symmetry; t tests of batches.
/// Book: sampling around the mirror direction.
#[test]
fn the_blur_is_round() {
    let lobe = GlossyReflection { reflectance: Rgb::WHITE, exponent: 20.0, rule: GlossyRule::Book };
    let all = samples_of(lobe, Vector::Z, 60_000);
    let moments: [fn(&Vector) -> f64; 4] =
        [|w| w.x(), |w| w.y(), |w| w.x() * w.y(), |w| w.x() * w.x() - w.y() * w.y()];
    for (i, moment) in moments.iter().enumerate() {
        let values: Vec<f64> = all.iter().map(moment).collect();
        let batches: Vec<f64> =
            values.chunks(1500).map(|b| b.iter().sum::<f64>() / 1.5e3).collect();
        let p = means::one_sample(&batches, 0.0);
        assert!(p > sidak(LEVEL, TESTS), "moment {i}: p = {p:e}");
    }
}

/// A glossy floor under a bright ball.
fn under_a_ball(finish: impl Into<groundtruth::materials::Kind>) -> Scene {
    let mut scene = deep_stage(Rgb::grey(0.1), 2);
    put(&mut scene, ground(0.0), finish);
    let ball = sphere(Point::new(0.0, 1.5, 0.0), 1.0);
    put(&mut scene, ball, Emissive::new(3.0, Rgb::WHITE));
    scene
}

/// Law: with a growing exponent the reflection tends to the mirror's, at the edge of a reflected ball too.
/// Oracle: the mirror of chapter 24; the distance falls at each step.
/// Book: the exponent of the reflection.
#[test]
fn a_large_exponent_is_a_mirror() {
    let mirror = Reflective { phong: Phong::default(), kr: 0.8.into(), cr: Rgb::WHITE.into() };
    let mirrored = built(&under_a_ball(mirror));
    let rays = (0..60).map(|i| Vector::new(0.02 * f64::from(i) - 0.6, -0.45, -1.0));
    let distance = |exponent| {
        let mut scene = under_a_ball(glossy(0.8, exponent, GlossyRule::Book));
        scene.image.samples = 64;
        let world = built(&scene);
        let eye = Point::new(0.0, 2.0, 5.0);
        let squares = rays.clone().map(|direction| {
            let sample =
                |i| radiance(&world, &ray(eye, direction), world.draws([0, 0], i), &mut ());
            let seen = render::mean((0..64).map(sample)).g - look(&mirrored, eye, direction).g;
            seen * seen
        });
        (squares.sum::<f64>() / 60.0).sqrt()
    };
    let distances = [1.0, 10.0, 100.0, 1e4, 1e6, 1e12].map(distance);
    assert!(distances.windows(2).all(|w| w[1] < w[0] || w[1] == 0.0), "{distances:?}");
    assert!(distances[0] > 0.3 && distances[5] < 1e-4, "{distances:?}");
}

/// Law: highlight and reflection each have their own exponent: neither changes the other. Oracle: the
/// same scene without the other.
/// Book: the exponent of the reflection.
#[test]
fn highlight_and_reflection_have_exponents_of_their_own() {
    let (eye, towards) = (Point::new(-1.0, 2.0, 0.1), Vector::new(1.0, -2.0, 0.0));
    let seen = |background: Rgb, kr: f64, exponent: f64, highlight: f64| {
        let mut scene = deep_stage(background, 1);
        let phong = Phong { ks: 0.5.into(), exponent: highlight.into(), ..Phong::default() };
        let finish = GlossyReflector { phong, ..glossy(kr, exponent, GlossyRule::Book) };
        put(&mut scene, ground(0.0), finish);
        if background.is_black() {
            let (color, location) = (Rgb::WHITE, Point::new(1.0, 2.0, 0.0));
            shine(&mut scene, PointLight { ls: 2.0, color, location, attenuation: 0.0 });
        }
        look(&built(&scene), eye, towards).g
    };
    // in black surroundings the highlight is seen, in bright ones without a light the reflection
    let alone = seen(Rgb::BLACK, 0.0, 1.0, 30.0);
    above!(alone, 0.1);
    assert_eq!([1.0, 1e4].map(|exponent| seen(Rgb::BLACK, 0.5, exponent, 30.0)), [alone; 2]);
    near!(seen(Rgb::WHITE, 0.5, 10.0, 1.0), 0.5, 1e-14);
    assert_eq!(seen(Rgb::WHITE, 0.5, 10.0, 1.0), seen(Rgb::WHITE, 0.5, 10.0, 1e3));
}

/// Law: a glossy hit casts one ray and draws one pair of numbers; ray casting neither. Oracle: counting.
/// Book: the material GlossyReflector and the tracers.
#[test]
fn a_glossy_hit_costs_one_ray_and_one_draw() {
    let scene = under_a_ball(glossy(0.8, 10.0, GlossyRule::Book));
    let down = (Point::new(3.0, 1.0, 0.0), -Vector::Y);
    let counts = counted(&built(&scene), down.0, down.1);
    assert_eq!((counts.camera, counts.reflected, counts.draws), (1, 1, 1));
    let cast = Scene { tracer: Tracer::RayCast, ..scene };
    let counts = counted(&built(&cast), down.0, down.1);
    assert_eq!((counts.camera, counts.reflected, counts.draws), (1, 0, 0));
}

/// Law: a matte lobe of the same material does not change the direction of the glossy ray. Oracle: the
/// rays recorded with and without it.
#[test]
fn other_lobes_do_not_move_the_reflection() {
    let direction = |kd| {
        let phong = Phong { kd, cd: Rgb::WHITE.into(), ..Phong::default() };
        let scene = under_a_ball(GlossyReflector { phong, ..glossy(0.8, 10.0, GlossyRule::Book) });
        let tree = recorded(&built(&scene), Point::new(3.0, 1.0, 0.0), -Vector::Y);
        tree.rays().last().expect("a reflected ray").ray
    };
    assert_eq!(direction(0.0.into()), direction(0.5.into()));
}

/// Law: by the book's rule, no pixel of a glossy surface whose `k_r` is at most 1 is brighter than the
/// brightest object around it, at any angle. Oracle: the lamp's radiance, for each sample by itself; and
/// some samples must see the lamp.
/// Book: the reflected radiance: k_r c_r L.
#[test]
fn gloss_is_not_brighter_than_what_it_reflects() {
    for exponent in [0.0, 1.0, 30.0] {
        let brightest = [0.0, 1.0, 5.0, 30.0].map(|tilt| {
            let mut scene = crate::laws::scene("ch25/moon.toml");
            scene.materials[0].recipe = glossy(1.0, exponent, GlossyRule::Book).into();
            scene.camera.eye = Point::new(tilt, 1.0, 0.3 * tilt);
            scene.image = Image { pixel_size: 0.1, ..Image::new(24, 24) };
            let world = built(&scene);
            (0..24 * 24).map(|i| pixel(&world, [i % 24, i / 24]).g).fold(0.0, f64::max)
        });
        let most = brightest.into_iter().fold(0.0, f64::max);
        at_most!(most, 5.0 * (1.0 + 1e-12), "e = {exponent}: {brightest:?}");
        above!(most, 4.99, "e = {exponent}: {brightest:?}: no sample sees the lamp");
    }
}
