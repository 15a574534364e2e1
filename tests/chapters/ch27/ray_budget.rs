//! The ray budget: the number of rays of a picture is estimated before it is rendered.
use groundtruth::render::{MAX_COUNTED, RaysPerSample, Renderer};
use groundtruth::trace::{Outcome, RayBudget};

use super::glass;
use crate::prelude::*;
use crate::support::stage::counted;
use crate::support::statistics::moments;

fn ball(radius: f64) -> Sphere {
    sphere(Point::ORIGIN, radius)
}

fn clear(eta: f64) -> Dielectric {
    Dielectric { inside: Medium::clear(eta), ..Dielectric::default() }
}

/// A scene in which every pixel shows what is put at the origin.
fn picture(max_depth: u32) -> Scene {
    let mut scene = deep_stage(Rgb::WHITE, max_depth);
    (scene.image.width, scene.image.height) = (24, 16);
    scene.image.pixel_size = 0.01;
    scene
}

/// Law: at each side of a slab of glass one ray continues inside and one leaves: at depth 100 a picture takes
/// 203 rays a sample, of which two are too deep, and not 2¹⁰¹. Oracle: counting both.
#[test]
fn a_slab_at_depth_100_counts_as_a_line() {
    let mut scene = picture(100);
    let (min, max) = (Point::new(-50.0, -50.0, -1.0), Point::new(50.0, 50.0, 0.0));
    put(&mut scene, boxed(min, max), clear(1.5));
    let estimate = RaysPerSample::measured(&built(&scene), MAX_COUNTED);
    // the camera's, and two at each of the hits at depths 0 to 100
    assert_eq!((estimate.mean, estimate.is_cut), (1.0 + 2.0 * 101.0, false));
    assert_eq!(estimate.note(24.0 * 16.0), None);
}

/// Law: measuring also ends, and reports that it was cut, where a single sample would take 2¹⁰⁰ rays: here in
/// nested glass balls at depth 100. Oracle: the test ends, and the count stays near its limit.
#[test]
fn a_tree_without_end_is_cut() {
    let mut scene = picture(100);
    for radius in [1.0, 0.9, 0.8] {
        put(&mut scene, ball(radius), clear(1.0 + radius));
    }
    let estimate = RaysPerSample::measured(&built(&scene), MAX_COUNTED);
    // rays that are open at the cut still count: each of them sends one more
    let few = estimate.mean < MAX_COUNTED as f64 + 300.0;
    assert!(estimate.is_cut && estimate.mean >= 1e6 && few, "{estimate:?}");
    // also before a single sample is rendered
    let note = estimate.note(1.0).expect("its user waits for ever");
    assert!(note.starts_with("this will take at least "), "{note}");
    let estimate = RaysPerSample::measured(&built(&scene), 1000);
    assert!(estimate.is_cut && estimate.mean < 1300.0, "{estimate:?}");
}

/// Law: the estimate is the mean over the whole picture, up to the error of a mean of 256 samples; here some
/// samples see two nested glass balls and some see nothing. Oracle: a count of all rays of the picture,
/// within four standard errors of the mean of 256.
#[test]
fn the_estimate_is_that_of_the_picture() {
    let mut scene = picture(8);
    scene.image.pixel_size = 0.12;
    for radius in [1.0, 0.7] {
        put(&mut scene, ball(radius), clear(1.0 + radius));
    }
    let world = built(&scene);
    let counts = |pixel| {
        let mut counts = RayCounts::default();
        render::sample(&world, pixel, 0, &mut counts);
        (counts.camera + counts.reflected + counts.transmitted + counts.shadow) as f64
    };
    let all: Vec<f64> = (0..16).flat_map(|y| (0..24).map(move |x| [x, y])).map(counts).collect();
    let (mean, variance) = moments(&all);
    let error = (variance / 256.0).sqrt();
    above!(error, 0.5);
    near!(RaysPerSample::measured(&world, MAX_COUNTED).mean, mean, 4.0 * error);
}

/// Law: where every ray hits glass that sends out two further rays, `2ᴺ⁺¹ − 1` rays are cast at depth N, and
/// the two of each of the `2ᴺ` last ones are too deep: `too_deep` counts those, and `reflected` and
/// `transmitted` count them too. Oracle: the full binary tree. The rays start at the centre of N + 1 nested
/// balls, none of which bends a ray, so that none gets out within N edges.
/// Book: the material Transparent and its tree of rays.
#[test]
fn the_last_rays_of_a_full_binary_tree_are_too_deep() {
    for depth in [0, 1, 2, 6, 10] {
        let mut scene = deep_stage(Rgb::WHITE, depth);
        for radius in 1..=depth + 1 {
            put(&mut scene, ball(f64::from(radius)), glass(0.5, 0.5, 1.0));
        }
        let found = counted(&built(&scene), Point::ORIGIN, Vector::new(0.3, 0.4, -0.5));
        let cast = (1 << (depth + 1)) - 1;
        let expected = RayCounts {
            camera: 1,
            // each ray that is cast sends one of each
            reflected: cast,
            transmitted: cast,
            too_deep: cast + 1,
            ..RayCounts::default()
        };
        assert_eq!(found, expected, "depth {depth}");
    }
}

/// The counts of the rays in a tree: too deep are those with more than `max_depth` edges before them.
fn counts_of(tree: &RayTree, max_depth: u32) -> RayCounts {
    let mut counts = RayCounts::default();
    for node in tree.rays() {
        match node.kind {
            RayKind::Camera => counts.camera += 1,
            RayKind::Reflected => counts.reflected += 1,
            RayKind::Transmitted => counts.transmitted += 1,
            RayKind::Shadow { .. } => counts.shadow += 1,
        }
        let is_shadow = matches!(node.kind, RayKind::Shadow { .. });
        counts.too_deep += u64::from(!is_shadow && node.depth > max_depth);
    }
    counts
}

/// Law: the counts equal the numbers of recorded rays, for ray trees and for paths, with shadow rays and
/// lamps. Oracle: the recorded rays, counted one by one.
#[test]
fn counts_are_those_of_the_recorded_rays() {
    for name in ["ch24/hall-of-mirrors", "ch26/cornell-box", "ch28/glass-sphere"] {
        let mut scene = (gallery::find(name).expect("it is in the gallery").build)();
        scene.image.resize(12, 8);
        scene.image.samples = 1;
        for max_depth in [1, 3] {
            for tracer in [
                Tracer::Whitted(Whitted { max_depth }),
                Tracer::PathTrace(Depth { max_depth }),
                Tracer::GlobalTrace(Depth { max_depth }),
                Tracer::Path(Depth { max_depth }),
            ] {
                scene.tracer = tracer;
                let world = built(&scene);
                let mut too_deep = 0;
                for pixel in (0..96).map(|i| [i % 12, i / 12]) {
                    let (mut counts, mut tree) = (RayCounts::default(), RayTree::of(&world));
                    render::sample(&world, pixel, 0, &mut counts);
                    render::sample(&world, pixel, 0, &mut tree);
                    let expected = RayCounts { draws: counts.draws, ..counts_of(&tree, max_depth) };
                    assert_eq!(counts, expected, "{name}, {tracer:?}, pixel {pixel:?}");
                    too_deep += counts.too_deep;
                }
                let cuts = name != "ch26/cornell-box" || scene.tracer.name() != "whitted";
                assert!(!cuts || too_deep > 0, "{name}, {tracer:?}: no ray is too deep");
            }
        }
    }
}

/// Law: a budget of as many rays as a sample takes changes nothing. With one less the last ray is over the budget
/// and black, and the check says for what there were too many. Oracle: the count of the sample's rays without a
/// limit: that of the camera and that of a mirror, which sees the background.
#[test]
fn a_budget_is_exceeded_by_one_ray_too_many() {
    let mut scene = picture(9);
    let mirror = Reflective { phong: Phong::default(), kr: 0.5.into(), cr: Rgb::WHITE.into() };
    let tilted = Vector::new(0.0, 0.5, 1.0);
    put(&mut scene, Plane { point: Point::ORIGIN, normal: tilted }, mirror);
    let world = built(&scene);
    let traced = |most: u64| {
        let (mut tree, mut budget) = (RayTree::of(&world), RayBudget::up_to(most));
        let radiance = world.sample([12, 8], 0, &mut tree, &mut budget);
        (radiance, tree, budget)
    };
    let mut counts = RayCounts::default();
    let whole = render::sample(&world, [12, 8], 0, &mut counts);
    let rays = counts.camera + counts.reflected;
    assert!(rays == 2 && !whole.is_black(), "{counts:?}, {whole:?}");

    let (radiance, _, budget) = traced(rays);
    assert_eq!((radiance, budget.spent(), budget.check(String::new)), (whole, rays, Ok(())));
    let (radiance, tree, budget) = traced(rays - 1);
    let last = tree.rays().pop().expect("the camera's ray");
    assert_eq!((last.number, last.outcome), (1, Outcome::OverBudget));
    assert!(radiance.is_black() && last.radiance.is_black(), "{radiance:?}");
    let too_many = budget.check(|| "a sample".to_owned()).map_err(|error| error.to_string());
    let text = "a sample: more than 1 rays; lower max_depth or the number of samples";
    assert_eq!(too_many, Err(text.to_owned()));
}
