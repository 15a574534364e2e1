//! Pictures out of focus: their total light, their lens samples, and what is sharp in them.

use groundtruth::cameras::{Eye, ThinLens};
use groundtruth::trace;

use super::rays::rim;
use crate::prelude::*;

/// A lens looking at nothing, with four samples in each of 150 × 100 pixels.
fn nothing_through_a_lens(lens_radius: f64) -> Scene {
    let lens = ThinLens { distance: 40.0, focal_distance: 74.0, lens_radius, zoom: 1.0 };
    let camera = Viewpoint::new(Point::new(0.0, 0.0, 50.0), Point::ORIGIN, lens);
    Scene::new("", Image { samples: 4, ..Image::new(150, 100) }, camera)
}

/// Law: samples are uniform over the lens: `E[r²] = R²/2`, `E[r⁴] = R⁴/3`, and the means of lx and ly
/// are 0; over a lens of radius 0 there are none. Oracle: the integrals; random samples are independent, so that z
/// tests apply. Book: samples on the lens.
#[test]
fn lens_samples_are_uniform() {
    let pinhole = built(&nothing_through_a_lens(0.0));
    assert_eq!(render::camera_sample(&pinhole, [3, 4], 1).expect("no gap").lens, None);
    let mut scene = nothing_through_a_lens(1.0);
    scene.image.samples = 64;
    scene.image.sampler = Some(Random {}.into());
    let mut world = built(&scene);
    let mut samples = Vec::new();
    // one pixel for each seed: the pixels of one picture share 83 sets
    for seed in 0..300 {
        world.reseed(seed);
        for index in 0..64 {
            let sample = render::camera_sample(&world, [5, 7], index).expect("no gap");
            let (ray, lens) = (sample.ray.expect("it sees"), sample.lens.expect("it has a lens"));
            // the ray starts there
            assert_eq!(ray.origin, Point::new(lens[0], lens[1], 50.0));
            samples.push(lens);
        }
    }
    type Moment = fn([f64; 2]) -> f64;
    let moments: [(Moment, f64); 5] = [
        (|[x, _]| x, 0.0),
        (|[_, y]| y, 0.0),
        (|[x, y]| x * y, 0.0),
        (|[x, y]| x * x + y * y, 0.5),
        (|[x, y]| (x * x + y * y) * (x * x + y * y), 1.0 / 3.0),
    ];
    for (moment, expected) in moments {
        let values: Vec<f64> = samples.iter().map(|&lens| moment(lens)).collect();
        assert!(sigmas(&values, expected).abs() < most_sigmas(5), "{expected}");
    }
}

/// Law: the samples of pixel and lens are independent; otherwise bands would appear: over all pixels, the
/// position in the pixel does not correlate with the position on the lens, for patterns that are shuffled.
/// Oracle: products of centred coordinates have the mean 0.
/// Book: samples on the lens.
#[test]
fn pixel_and_lens_samples_are_paired_by_chance() {
    let mut scene = nothing_through_a_lens(1.0);
    for sampler in [None, Some(Jittered {}.into())] {
        scene.image.sampler = sampler;
        let world = built(&scene);
        let pairs: Vec<([f64; 2], [f64; 2])> = pixels(150, 100)
            .map(|at| {
                let sample = render::camera_sample(&world, at, 2).expect("no gap");
                let corner = render::film_point(&world.image, at, [0.5, 0.5]);
                let offset = [sample.film[0] - corner[0], sample.film[1] - corner[1]];
                (offset, sample.lens.expect("it has a lens"))
            })
            .collect();
        for (i, j) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
            let products: Vec<f64> = pairs.iter().map(|(p, l)| p[i] * l[j]).collect();
            assert!(sigmas(&products, 0.0).abs() < most_sigmas(8), "{i} {j}");
        }
    }
}

/// Law: blur moves light and keeps its sum: an emitting disk gives the same total light, `π ρ² (d/z)²` film
/// units, with any lens and focus. Oracle: the closed form; standard error over 16 seeds.
/// Book: the circle of confusion.
#[test]
fn blur_keeps_the_light() {
    let (rho, z) = (3.0, 80.0);
    for (focal_distance, lens_radius) in [(80.0, 2.0), (40.0, 1.0), (200.0, 3.0), (40.0, 0.0)] {
        let lens = ThinLens { distance: 100.0, focal_distance, lens_radius, zoom: 1.0 };
        let camera = Viewpoint::new(Point::new(0.0, 0.0, z), Point::ORIGIN, lens);
        let mut scene = Scene::new("", Image { samples: 4, ..Image::new(22, 22) }, camera);
        let disk = Disk { center: Point::new(0.3, -0.2, 0.0), normal: Vector::Z, radius: rho };
        add_flat(&mut scene, "disk", disk, Rgb::WHITE);
        let mut world = built(&scene);
        let light: Vec<f64> = (1..=16)
            .map(|seed| {
                world.reseed(seed);
                render::render(&world).pixels().iter().map(|pixel| pixel.g).sum()
            })
            .collect();
        let area = 0.5 * TAU * rho * rho * (100.0 / z) * (100.0 / z);
        let off = sigmas(&light, area).abs();
        // 16 values: Student's t reaches 5.2 where the normal's quantile is 3.8
        assert!(off < 1.5 * most_sigmas(4), "f {focal_distance}, R {lens_radius}: {off} sigmas");
    }
}

/// The radiance from each of 40 points of the lens, for one film point.
fn through_the_lens(scene: &Scene, film: [f64; 2]) -> Vec<f64> {
    let world = built(scene);
    let ray = |i: i32| -> Ray {
        let r = f64::from(i % 4 + 1) / 4.0;
        let eye: &Eye = &world.view.eyes()[0];
        eye.ray(film, rim(f64::from(i) / 40.0).map(|l| r * l)).expect("it sees")
    };
    (0..40).map(|i| trace::radiance(&world, &ray(i), world.draws([0, 0], 0), &mut ()).g).collect()
}

/// Law: a mirrored object is sharp where the whole path along −w, to the mirror and on, is the focal
/// distance, not where the mirror is. Oracle: the edge of an emitting half plane, whose image divides the
/// film: right beside it the radiance is the same from all points of the lens if and only if it is sharp.
/// Book: fig. 10.12, reflections in focus.
#[test]
fn a_mirrored_edge_is_sharp_at_the_length_of_the_whole_way() {
    // the mirror 30 ahead; the half plane x > 1 is 20 behind the lens
    let scene = |focal_distance: f64| {
        let lens = ThinLens { distance: 10.0, focal_distance, lens_radius: 0.5, zoom: 1.0 };
        let camera = Viewpoint::new(Point::ORIGIN, Point::new(0.0, 0.0, -1.0), lens);
        let mut scene = Scene::new("", Image::new(8, 8), camera);
        scene.tracer = Tracer::Whitted(Whitted { max_depth: 2 });
        let mirror =
            Reflective { phong: Default::default(), kr: 1.0.into(), cr: Rgb::WHITE.into() };
        scene.materials.push(Material::new("mirror", mirror));
        let square = |corner: Point, side: f64| Rectangle {
            corner,
            a: Vector::new(side, 0.0, 0.0),
            b: Vector::new(0.0, side, 0.0),
        };
        let mirror = square(Point::new(-50.0, -50.0, -30.0), 100.0);
        scene.objects.push(Object::new("mirror", "mirror", mirror));
        add_flat(&mut scene, "wall", square(Point::new(1.0, -50.0, 20.0), 100.0), Rgb::WHITE);
        scene
    };
    // seen at x = d · 1/80 of the mirrored plane
    let edge = 10.0 / 80.0;
    let agree = |focal_distance: f64, x: f64| {
        let light = through_the_lens(&scene(focal_distance), [x, 0.1]);
        light.iter().all(|&l| l == light[0]).then_some(light[0])
    };
    assert_eq!(agree(80.0, edge + 1e-6), Some(1.0));
    assert_eq!(agree(80.0, edge - 1e-6), Some(0.0));
    for out_of_focus in [30.0, 50.0, 79.0, 81.0] {
        assert_eq!(agree(out_of_focus, edge + 1e-6), None, "{out_of_focus}");
    }
}
