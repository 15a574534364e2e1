//! What a pixel is: the mean of its samples, and where they are.

use groundtruth::samplers::Kind;
use testkit::properties::*;

use crate::prelude::*;

/// Law: one regular sample, which is the default, is the centre of its pixel, exactly.
/// Book: remedies: regular samples.
#[test]
fn one_regular_sample_is_the_centre() {
    for sampler in [None, Some(Kind::from(Regular {}))] {
        let mut scene = from_front(7, 4, 2.0);
        scene.image.sampler = sampler;
        let world = built(&scene);
        for at in pixels(7, 4) {
            let (_, film) = camera_ray(&world, at, 0);
            let [x, y] = at.map(f64::from);
            assert_eq!(film, [2.0 * x - 6.0, 3.0 - 2.0 * y], "{at:?}");
        }
    }
}

/// Law: n × n regular samples are the centres of the subcells. Oracle: the book's formula with n = 4,
/// exact in eighths.
/// Book: remedies: regular samples.
#[test]
fn regular_samples_are_the_centres_of_subcells() {
    let mut scene = from_front(3, 3, 1.0);
    scene.image.samples = 16;
    scene.image.sampler = Some(Regular {}.into());
    let world = built(&scene);
    for at in pixels(3, 3) {
        let mut found: Vec<_> = (0..16).map(|i| camera_ray(&world, at, i).1).collect();
        found.sort_by(|a, b| a.partial_cmp(b).expect("finite"));
        let corner = [f64::from(at[0]) - 1.5, 0.5 - f64::from(at[1])];
        let cell = |i: u32| (f64::from(i) + 0.5) / 4.0;
        let expected: Vec<_> =
            (0..16).map(|i| [corner[0] + cell(i / 4), corner[1] + cell(i % 4)]).collect();
        assert_eq!(found, expected, "{at:?}");
    }
}

/// A red half plane to the left of `x`, or below it with `upright` off.
fn half_plane(x: f64, upright: bool) -> Scene {
    let mut scene = from_front(3, 3, 1.0);
    let (min, max) = match upright {
        true => (Point::new(-9.0, -9.0, -1.0), Point::new(x, 9.0, 1.0)),
        false => (Point::new(-9.0, -9.0, -1.0), Point::new(9.0, x, 1.0)),
    };
    add_flat(&mut scene, "half", shapes::Cuboid { min, max }, RED);
    scene
}

/// Law: a pixel half covered along an axis is exactly ½ with an even regular grid; with stratified
/// samples too, whose cells the edge does not cut. Oracle: symmetry.
/// Book: remedies: regular samples.
#[test]
fn a_half_covered_pixel_is_a_half() {
    for upright in [true, false] {
        for (n, sampler) in [
            (4, Kind::from(Regular {})),
            (16, Regular {}.into()),
            (100, Regular {}.into()),
            (4, Jittered {}.into()),
            (64, Jittered {}.into()),
            (16, MultiJittered {}.into()),
        ] {
            let mut scene = half_plane(0.0, upright);
            scene.image.samples = n;
            scene.image.sampler = Some(sampler);
            assert_eq!(render::pixel(&built(&scene), [1, 1]), Rgb::new(0.5, 0.0, 0.0), "{n}");
        }
    }
}

/// Law: a picture takes width · height · samples primary rays. Oracle: counting; counts that are not squares
/// are rounded up for the samplers that need squares, and only for them.
/// Book: remedies: regular samples.
#[test]
fn the_number_of_primary_rays_is_that_of_the_samples() {
    for (sampler, asked, taken) in [
        (Kind::from(Random {}), 7, 7),
        (Regular {}.into(), 9, 9),
        (Jittered {}.into(), 5, 9),
        (MultiJittered {}.into(), 10, 16),
        (MultiJittered {}.into(), 1, 1),
    ] {
        let mut scene = from_front(4, 3, 1.0);
        scene.image.samples = asked;
        scene.image.sampler = Some(sampler);
        let world = built(&scene);
        let mut counts = RayCounts::default();
        for at in pixels(4, 3) {
            (0..world.samples_per_pixel()).for_each(|i| {
                render::sample(&world, at, i, &mut counts);
            });
        }
        assert_eq!(counts, RayCounts { camera: 12 * taken, ..RayCounts::default() });
    }
}

proptest! {
    #![proptest_config(laws())]

    /// Law: a small sum between huge ones that cancel is kept. Oracle: by hand.
    #[test]
    fn means_survive_cancellation(huge in 1e10..1e20_f64, small in 1e-3..1.0_f64) {
        let samples = [huge, small, -huge].map(Rgb::grey);
        prop_assert_eq!(render::mean(samples.into_iter()).g, small / 3.0);
        let samples = [small, huge, -huge].map(Rgb::grey);
        prop_assert_eq!(render::mean(samples.into_iter()).g, small / 3.0);
    }
}
