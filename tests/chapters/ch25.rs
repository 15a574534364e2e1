//! Chapter 25: glossy reflection.
//!
//! | of the book | what is held | by the law |
//! | --- | --- | --- |
//! | the reflected radiance: k_r c_r L | by the book's rule uniform surroundings of radiance L are reflected as `k_r L`, by each sample exactly and at every angle | `uniform_surroundings_are_seen_times_the_reflectance` |
//! |  | by the book's rule, no pixel of a glossy surface whose `k_r` is at most 1 is brighter than the brightest object around it, at any angle | `pictures::gloss_is_not_brighter_than_what_it_reflects` |
//! | sampling around the mirror direction | every sampled direction of gloss is above the surface, also at grazing angles; by the book's rule no sample is lost | `every_direction_is_above_the_surface` |
//! |  | the mean of `r·ω_i`, with the mirror direction r, is `(e + 1)/(e + 2)`; rotation about r does not change it | `the_mean_cosine_to_the_mirror_direction_is_that_of_the_power` |
//! |  | seen from straight above, the blur is the same in all directions around the mirror direction: the mean of x, y and xy is 0, and x² and y² have one mean | `the_blur_is_round` |
//! |  | seen straight on, a lamp of angular radius α in the mirror direction is reflected with `kr (1 − cos^(e+1) α)` of its radiance by the book's rule, and with `kr (1 − cos^(e+2) α)` by the normalised one, in every pixel and with every tracer that follows the glossy ray | `pictures::a_moon_is_blurred_as_the_integral_of_the_lobe_says` |
//! | the exponent of the reflection | with a growing exponent the reflection tends to the mirror's, at the edge of a reflected ball too | `a_large_exponent_is_a_mirror` |
//! |  | highlight and reflection each have their own exponent: neither changes the other | `highlight_and_reflection_have_exponents_of_their_own` |
//! | the material GlossyReflector and the tracers | a glossy hit casts one ray and draws one pair of numbers; ray casting neither | `a_glossy_hit_costs_one_ray_and_one_draw` |
//! |  | where only emitters are seen, Whitted's tracer and the three path tracers have the same mean, by both rules | `all_tracers_see_the_same_reflection` |
//!
//! Beyond the book: 5 in this file.

mod pictures;

use groundtruth::lobes::GlossyReflection;
use groundtruth::math::Frame;

use crate::prelude::*;
use crate::support::stage::{counted, ray, recorded};

/// The probability, over the choice of seeds, that at least one statistical test of this file fails
/// although all its laws hold.
const LEVEL: f64 = 1e-3;
const TESTS: usize = 40;
const REPLICAS: u64 = 24;

fn glossy(kr: f64, exponent: f64, rule: GlossyRule) -> GlossyReflector {
    GlossyReflector {
        phong: Phong::default(),
        kr: kr.into(),
        cr: Rgb::WHITE.into(),
        exponent: exponent.into(),
        rule,
    }
}

fn floor() -> Plane {
    Plane { point: Point::ORIGIN, normal: Vector::Y }
}

/// The mean of `samples` samples of the radiance along a ray, in green, for each of the replicas.
fn replicas(scene: &Scene, samples: u32, origin: Point, direction: Vector) -> Vec<f64> {
    let mut scene = scene.clone();
    scene.image.samples = samples;
    let mut world = built(&scene);
    let mean_of = |world: &World| {
        let sample = |i| radiance(world, &ray(origin, direction), world.draws([0, 0], i), &mut ());
        render::mean((0..world.samples_per_pixel()).map(sample)).g
    };
    let replica = |seed| {
        world.reseed(seed);
        mean_of(&world)
    };
    (0..REPLICAS).map(replica).collect()
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

/// Law: by the book's rule uniform surroundings of radiance L are reflected as `k_r L`, by each sample
/// exactly and at every angle. Oracle: the product.
/// Book: the reflected radiance: k_r c_r L.
#[test]
fn uniform_surroundings_are_seen_times_the_reflectance() {
    for exponent in [0.0, 1.0, 10.0, 1000.0, 1e5, 1e10, 1e15] {
        let mut scene = deep_stage(Rgb::new(0.8, 0.9, 1.0), 1);
        put(&mut scene, floor(), glossy(0.8, exponent, GlossyRule::Book));
        let world = built(&scene);
        for slope in [-100.0, -1.0, -0.2, -0.01] {
            let seen = look(&world, Point::new(0.0, 1.0, 0.0), Vector::new(1.0, slope, 0.3));
            let off = (seen.g - 0.72).abs() / 0.72;
            assert!(off < 1e-14, "e = {exponent}, slope {slope}: {} instead of 0.72", seen.g);
        }
    }
}

/// Law: by the normalised rule the mean is `L` times the albedo, which is less than `kr`: of a narrow lobe
/// about `k_r cosθ_o`, as the rule has no `1/cosθ_i`. Oracle: quadrature of the lobe over the hemisphere.
#[test]
fn the_normalised_rule_is_darker_away_from_the_normal() {
    const STEPS: u32 = 400;
    for (exponent, slope) in [(1.0, -1.0), (10.0, -0.3), (100.0, -0.1), (1e5, -1.0)] {
        let mut scene = deep_stage(Rgb::WHITE, 1);
        put(&mut scene, floor(), glossy(0.9, exponent, GlossyRule::Normalised));
        let direction = Vector::new(1.0, slope, 0.0).unit().expect("not zero");
        // about the mirror direction, in equal steps of cos^(e+1) and φ
        let mirrored = Vector::new(direction.x(), -direction.y(), 0.0);
        let frame = Frame::around(Normal::new(mirrored).expect("unit"));
        let mut sum = 0.0;
        for i in 0..STEPS {
            let c = power((f64::from(i) + 0.5) / f64::from(STEPS), 1.0 / (exponent + 1.0));
            let s = ((1.0 - c) * (1.0 + c)).sqrt();
            for j in 0..STEPS {
                let phi = std::f64::consts::TAU * (f64::from(j) + 0.5) / f64::from(STEPS);
                let wi = frame.to_world(Vector::new(s * cos(phi), s * sin(phi), c));
                sum += wi.y().max(0.0);
            }
        }
        let mean = sum / f64::from(STEPS * STEPS);
        let expected = 0.9 * (exponent + 2.0) / (exponent + 1.0) * mean;
        let found = replicas(&scene, 256, Point::new(0.0, 1.0, 0.0), direction);
        let p = means::one_sample(&found, expected);
        let mean = found.iter().sum::<f64>() / REPLICAS as f64;
        let what = format!("e = {exponent}, slope {slope}");
        assert!(p > sidak(LEVEL, TESTS), "{what}: {mean} instead of {expected}, p = {p:e}");
        assert!(expected < 0.9, "{what}: {expected}");
        let narrow = 0.9 * -direction.y();
        assert!(exponent < 1e4 || (expected - narrow).abs() < 1e-3, "{what}: {expected}, {narrow}");
    }
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
    put(&mut scene, floor(), finish);
    let ball = Sphere { center: Point::new(0.0, 1.5, 0.0), radius: 1.0, inward: false };
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
    let highlight = Phong { ks: 0.5.into(), exponent: 30.0.into(), ..Phong::default() };
    let seen = |finish: GlossyReflector| {
        let mut scene = deep_stage(Rgb::BLACK, 1);
        put(&mut scene, floor(), finish);
        let location = Point::new(1.0, 2.0, 0.0);
        let (ls, color) = (2.0, Rgb::WHITE);
        shine(
            &mut scene,
            groundtruth::lights::PointLight { ls, color, location, attenuation: 0.0 },
        );
        look(&built(&scene), Point::new(-1.0, 2.0, 0.1), Vector::new(1.0, -2.0, 0.0)).g
    };
    let with = |exponent| GlossyReflector {
        phong: highlight.clone(),
        ..glossy(0.5, exponent, GlossyRule::Book)
    };
    // the surroundings are black: what is seen is the highlight
    let alone = seen(GlossyReflector { kr: 0.0.into(), ..with(1.0) });
    assert!(alone > 0.1, "{alone}");
    assert_eq!([seen(with(1.0)), seen(with(1e4))], [alone; 2]);
    let bright = |highlight_exponent| {
        let phong = Phong { exponent: highlight_exponent, ..highlight.clone() };
        let mut scene = deep_stage(Rgb::WHITE, 1);
        put(&mut scene, floor(), GlossyReflector { phong, ..glossy(0.5, 10.0, GlossyRule::Book) });
        look(&built(&scene), Point::new(-1.0, 2.0, 0.1), Vector::new(1.0, -2.0, 0.0)).g
    };
    near!(bright(1.0.into()), 0.5, 1e-14);
    assert_eq!(bright(1.0.into()), bright(1e3.into()));
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

/// Law: where only emitters are seen, Whitted's tracer and the three path tracers have the same mean, by
/// both rules. Oracle: each other (Welch's t).
/// Book: the material GlossyReflector and the tracers.
#[test]
fn all_tracers_see_the_same_reflection() {
    for rule in [GlossyRule::Book, GlossyRule::Normalised] {
        let mut scene = under_a_ball(glossy(0.7, 20.0, rule));
        shine(&mut scene, groundtruth::lights::Area { object: "1".to_owned(), sampling: None });
        let (eye, direction) = (Point::new(0.0, 2.0, 5.0), Vector::new(0.05, -0.45, -1.0));
        let depth = Depth { max_depth: 1 };
        let whitted = replicas(&scene, 64, eye, direction);
        for tracer in [Tracer::PathTrace(depth), Tracer::GlobalTrace(depth), Tracer::Path(depth)] {
            scene.tracer = tracer;
            let found = replicas(&scene, 64, eye, direction);
            let p = means::two_samples(&whitted, &found);
            let [a, b] = [&whitted, &found].map(|v| v.iter().sum::<f64>() / REPLICAS as f64);
            let right = p > sidak(LEVEL, TESTS);
            assert!(right, "{rule:?}, {}: {a} and {b}, p = {p:e}", tracer.name());
        }
    }
}

/// Law: where the interpolated normal of a smooth mirror would send a ray below the true surface, the
/// ray is reflected about the true normal, so that no outline is black. Oracle: the background's colour.
#[test]
fn a_smooth_mirror_has_no_black_outline() {
    let mut scene = deep_stage(Rgb::new(0.2, 0.4, 0.6), 2);
    let vertices = [[-1.0, 0.0, -1.0], [0.0, 0.0, 1.0], [1.0, 0.0, -1.0]].map(Point::from);
    let normals = Some([Vector::new(-0.9, 0.5, 0.0); 3]);
    let mirror = Reflective { phong: Phong::default(), kr: 1.0.into(), cr: Rgb::WHITE.into() };
    put(&mut scene, Triangle { vertices, normals }, mirror);
    let seen = look(&built(&scene), Point::new(2.0, 0.4, 0.0), Vector::new(-2.0, -0.4, -0.1));
    assert_eq!(seen, Rgb::new(0.2, 0.4, 0.6));
}

/// Law: a glossy floor under a matte ball is black in black surroundings without lights. Oracle: black.
#[test]
fn black_surroundings_are_reflected_as_black() {
    let mut scene = stage(Rgb::BLACK);
    scene.tracer = Tracer::Path(Depth { max_depth: 5 });
    put(&mut scene, floor(), glossy(1.0, 5.0, GlossyRule::Normalised));
    let ball = Sphere { center: Point::new(0.0, 1.0, 0.0), radius: 1.0, inward: false };
    put(&mut scene, ball, Matte { ka: 0.0.into(), kd: 1.0.into(), cd: Rgb::WHITE.into() });
    assert!(
        look(&built(&scene), Point::new(0.0, 3.0, 5.0), Vector::new(0.0, -3.0, -5.0)).is_black()
    );
}

/// Law: an exponent so large that directions cannot be told apart is refused, with the alternative; 1e15 is
/// not. Oracle: the message.
#[test]
fn exponents_beyond_the_rounding_of_directions_are_refused() {
    let world = |exponent| {
        let mut scene = deep_stage(Rgb::WHITE, 1);
        put(&mut scene, floor(), glossy(0.8, exponent, GlossyRule::Book));
        World::build(&scene)
    };
    assert!(world(1e15).is_ok());
    let error = world(1e19).expect_err("too large").to_string();
    assert!(error.contains("exponent: found 1e19, but at most 1e15 fits"), "{error}");
    // each material with an exponent
    for exponent in [1e15, 1e15_f64.next_up(), -1e-300, f64::NAN] {
        let phong = Phong { exponent: exponent.into(), ..Phong::default() };
        let (kr, cr, kt) = (0.1.into(), Rgb::WHITE.into(), 0.5.into());
        let reflective = Reflective { phong: phong.clone(), kr, cr };
        let (kr, cr) = (0.1.into(), Rgb::WHITE.into());
        let transparent = Transparent { phong: phong.clone(), kr, cr, kt, eta: 1.5 };
        let blurred =
            GlossyReflector { phong: phong.clone(), ..glossy(0.8, 1.0, GlossyRule::Book) };
        let recipes: [materials::Kind; 4] =
            [phong.into(), reflective.into(), transparent.into(), blurred.into()];
        for recipe in recipes {
            let mut scene = deep_stage(Rgb::WHITE, 1);
            put(&mut scene, floor(), recipe.clone());
            let (found, expected) = (World::build(&scene).is_ok(), exponent == 1e15);
            assert_eq!(found, expected, "whether the exponent {exponent:?} fits in {recipe:?}");
        }
    }
}
