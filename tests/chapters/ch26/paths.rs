//! Path tracers: their mean, their variance and their cost.

use groundtruth::render::render;
use groundtruth::trace::TermSource;
use statistics::slope::power_law;

use super::{room, tracers};
use crate::prelude::*;
use crate::support::number;
use crate::support::replicas::{assert_agree, assert_known, mean_and_error};
use crate::support::stage::{counted, recorded};

/// The room with a mirror, a glass ball and a glossy one, all of which throw light on the floor.
fn furnished_room() -> Scene {
    let mut scene = room();
    let mirror = Reflective { phong: Phong::default(), kr: 0.8.into(), cr: Rgb::WHITE.into() };
    let wall = Plane { point: Point::new(-2.0, 0.0, 0.0), normal: Vector::X };
    put(&mut scene, wall, mirror);
    let mut ball = |center: [f64; 3], recipe: groundtruth::materials::Kind| {
        let ball = sphere(Point::from(center), 0.6);
        put(&mut scene, ball, recipe);
    };
    let inside = Medium { eta: 1.5, absorption: Rgb::new(0.3, 0.1, 0.5) };
    ball([1.5, 0.6, 1.5], Dielectric { inside, ..Dielectric::default() }.into());
    let phong = Phong { kd: 0.3.into(), cd: Rgb::WHITE.into(), ..Phong::default() };
    let (cr, rule) = (Rgb::WHITE.into(), GlossyRule::Normalised);
    let glossy = GlossyReflector { phong, kr: 0.5.into(), cr, exponent: 8.0.into(), rule };
    ball([2.6, 0.6, 0.2], glossy.into());
    with_samples(scene, 256)
}

/// Law: the three path tracers have one mean where light comes over mirrors, through glass and from glossy
/// surfaces too: a light that only a single direction reaches counts in full, and one that could also have
/// been sampled counts once. Oracle: each other; Welch's t over 24 replicas.
/// Book: listings 26.6 to 26.8, global tracing.
#[test]
fn path_tracers_agree_over_mirrors_glass_and_gloss() {
    let eye = Point::new(0.5, 2.0, 6.0);
    // the floor under the glass, the glass, the glossy ball, the mirror, and the lamp in it
    let targets =
        [[1.2, 0.0, 1.4], [1.4, 0.7, 2.0], [2.5, 0.8, 0.6], [-2.0, 0.8, 0.5], [-5.5, 3.0, 0.5]];
    let found = tracers(5).map(|tracer| {
        let scene = Scene { tracer, ..furnished_room() };
        replicas(&scene, |world| targets.map(|t| view(world, eye, Point::from(t) - eye).g))
    });
    for (i, target) in targets.iter().enumerate() {
        let [path_trace, global_trace, path] =
            [0, 1, 2].map(|t| found[t].iter().map(|seen| seen[i]).collect::<Vec<f64>>());
        for (name, other) in [("path_trace", &path_trace), ("global_trace", &global_trace)] {
            let what = format!("{name} and path towards {target:?}");
            assert_agree(&what, other, &path, 2 * targets.len());
            [other, &path].into_iter().for_each(|values| assert_known(&what, values, 0.05));
        }
    }
}

/// Law: path tracers shadow the light of lamps and of the sky whether or not objects and lights cast
/// shadows: where paths can hit the light, light samples that pass through would count it twice. Oracle: the
/// same picture, bit for bit; with `whitted`, which obeys, it differs.
#[test]
fn paths_shadow_what_they_can_hit() {
    let whitted = Tracer::Whitted(Whitted { max_depth: 5 });
    for tracer in tracers(5).into_iter().chain([whitted]) {
        let mut scene = Scene { tracer, ..furnished_room() };
        shine(&mut scene, Environment {});
        scene.image.samples = 4;
        (scene.image.width, scene.image.height, scene.image.pixel_size) = (16, 16, 0.3);
        scene.camera.eye = Point::new(0.5, 6.0, 8.0);
        let with_shadows = render(&built(&scene));
        scene.materials.iter_mut().for_each(|material| material.casts_shadows = false);
        let without_objects = render(&built(&scene));
        scene.lights.iter_mut().for_each(|light| light.shadows = false);
        let without_lights = render(&built(&scene));
        let same = [without_objects, without_lights].map(|it| it.pixels() == with_shadows.pixels());
        assert_eq!(same, [tracer != whitted; 2], "{}", tracer.name());
    }
}

/// Law: radiance is linear in the emission of the lamps: twice the emission gives the same picture twice as
/// bright, bit for bit, under every tracer; the random choices do not depend on it. Oracle: the picture times
/// two.
/// Book: path tracing.
#[test]
fn twice_the_light_is_twice_the_picture() {
    for tracer in Tracer::ALL {
        let mut scene = Scene { tracer, ..furnished_room() };
        scene.background = Rgb::BLACK.into();
        scene.image.samples = 4;
        (scene.image.width, scene.image.height, scene.image.pixel_size) = (8, 8, 0.6);
        scene.camera.eye = Point::new(0.5, 6.0, 8.0);
        let once = render(&built(&scene));
        for material in &mut scene.materials {
            if let groundtruth::materials::Kind::Emissive(lamp) = &mut material.recipe {
                lamp.ls = (2.0 * number(&lamp.ls)).into();
            }
        }
        let twice = render(&built(&scene));
        assert!(once.pixels().iter().any(|pixel| pixel.g > 0.0), "{} is black", tracer.name());
        for (once, twice) in once.pixels().iter().zip(twice.pixels()) {
            assert_eq!(2.0 * *once, *twice, "{}", tracer.name());
        }
    }
}

/// Law: where `global_trace` meets a lamp whose light was sampled at the hit before, the ray tree has the
/// lamp's emission with the weight 0, so that a reader sees why it is not counted. Oracle: the emission of
/// the lamp, a sphere around the floor, which each reflected ray meets.
/// Book: listings 26.6 to 26.8, global tracing.
#[test]
fn a_lamp_that_was_sampled_is_a_term_of_weight_zero() {
    let mut scene = stage(Rgb::BLACK);
    scene.tracer = Tracer::GlobalTrace(Depth { max_depth: 3 });
    let floor = ground(0.0);
    put(&mut scene, floor, matte(0.0, 0.8, Rgb::WHITE));
    let dome = Sphere { center: Point::ORIGIN, radius: 4.0, inward: true };
    let dome = put(&mut scene, dome, Emissive::new(7.0, Rgb::WHITE));
    shine(&mut scene, Area { object: dome.to_string(), sampling: None });
    let tree = recorded(&built(&scene), Point::new(0.5, 1.0, 0.0), Vector::new(0.2, -1.0, 0.3));
    let reflected: Vec<_> =
        tree.rays().into_iter().filter(|n| n.kind == RayKind::Reflected).collect();
    assert_eq!(reflected.len(), 1);
    let terms: Vec<_> =
        reflected[0].terms.iter().map(|it| (it.source, it.weight, it.arriving, it.value)).collect();
    let (source, arriving) = (TermSource::Emission { mis: Some(0.0) }, Rgb::grey(7.0));
    assert_eq!(terms, [(source, Rgb::BLACK, arriving, Rgb::BLACK)]);
}

/// A floor lit by one small lamp.
fn dim_room(tracer: Tracer) -> Scene {
    let mut scene = stage(Rgb::BLACK);
    scene.tracer = tracer;
    let floor = ground(0.0);
    put(&mut scene, floor, matte(0.0, 0.8, Rgb::WHITE));
    let lamp = sphere(Point::new(0.0, 2.0, 0.0), 0.25);
    let lamp = put(&mut scene, lamp, Emissive::new(50.0, Rgb::WHITE));
    shine(&mut scene, Area { object: lamp.to_string(), sampling: None });
    scene
}

fn floor_seen(world: &groundtruth::world::World) -> f64 {
    view(world, Point::new(1.0, 0.5, 0.0), Vector::new(0.1, -1.0, 0.0)).g
}

/// Law: sampling a small lamp is better than hitting it by chance: with equally many samples the variance
/// of `global_trace` and `path` is far below that of `path_trace`. Oracle: `p (1 − p)/n` of a lamp that
/// one ray in 65 meets; Welch's t for the means.
/// Book: listings 26.6 to 26.8, global tracing.
#[test]
fn sampling_a_small_lamp_lowers_the_variance() {
    let [met, first, path] = tracers(2).map(|tracer| {
        let mut scene = with_samples(dim_room(tracer), 256);
        scene.image.sampler = Some(Random {}.into());
        replicas(&scene, floor_seen)
    });
    for (name, sampled) in [("global_trace", &first), ("path", &path)] {
        assert_agree(&format!("path_trace and {name}"), &met, sampled, 2);
        let [e, f] = [&met, sampled].map(|values| mean_and_error(values).1);
        above!(e, 10.0 * f, "{name}");
    }
}

/// Law: the error of independent paths falls as 1/√N, and its size is that of a lamp that each path hits or
/// misses. Oracle: the slope −½ of standard deviations over replicas, and the binomial deviation at each N.
/// Book: the noise of path tracing.
#[test]
fn the_error_of_paths_falls_as_the_root_of_their_number() {
    const SEEDS: u64 = 128;
    /// Five times the standard error `1/√(2n)` of a standard deviation.
    const SPREAD: f64 = 0.32;
    let deviations: Vec<(f64, f64)> = [64_u32, 144, 256, 576, 1024, 2304]
        .into_iter()
        .map(|n| {
            let mut scene = with_samples(dim_room(Tracer::PathTrace(Depth { max_depth: 1 })), n);
            scene.image.sampler = Some(Random {}.into());
            let mut world = built(&scene);
            let mut one = |seed| {
                world.reseed(26_000 + seed);
                floor_seen(&world)
            };
            let values: Vec<f64> = (0..SEEDS).map(&mut one).collect();
            let (mean, error) = mean_and_error(&values);
            // each path returns ρ L with probability p, and otherwise nothing
            let (p, found) = (mean / 40.0, error * (SEEDS as f64).sqrt());
            let binomial = 40.0 * (p * (1.0 - p) / f64::from(n)).sqrt();
            let off = (found / binomial - 1.0).abs();
            assert!(off < SPREAD, "{n} samples: {found:e}, binomial {binomial:e}");
            (f64::from(n), found)
        })
        .collect();
    let law = power_law(&deviations, 0.999).expect("six points");
    let [low, high] = law.interval;
    assert!(low < -0.5 && -0.5 < high, "{law:?} of {deviations:?}");
    assert!((law.exponent + 0.5).abs() < 0.1, "{law:?} of {deviations:?}");
}

/// Law: a path over a mirror draws no random numbers: two rays are cast, and uniform light is weighted by
/// k_r exactly. Oracle: counting; the product.
/// Book: listing 26.5, paths over mirrors.
#[test]
fn a_path_over_a_mirror_draws_nothing() {
    for tracer in tracers(4) {
        let mut scene = stage(Rgb::grey(2.0));
        scene.tracer = tracer;
        let mirror = Reflective { phong: Phong::default(), kr: 0.75.into(), cr: Rgb::WHITE.into() };
        let ball = sphere(Point::ORIGIN, 1.0);
        put(&mut scene, ball, mirror);
        let (eye, direction) = (Point::new(0.3, 0.1, 4.0), -Vector::Z);
        assert_eq!(look(&built(&scene), eye, direction), Rgb::grey(1.5));
        let counts = counted(&built(&scene), eye, direction);
        assert_eq!((counts.camera, counts.reflected, counts.draws), (1, 1, 0), "{}", tracer.name());
    }
}
