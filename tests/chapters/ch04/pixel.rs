//! What a pixel is: the mean of its samples, and where they are.

use groundtruth::samplers::Kind;
use groundtruth::textures::{self, Texture};
use statistics::means::one_sample;
use testkit::properties::*;

use crate::pictures::studio::{RED, built};
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

/// Law: multi-jittered samples give the exact coverage of an upright or level edge at any border of the N
/// fine columns or rows. Oracle: the covered share; jittered samples are not exact.
#[test]
fn multi_jittered_samples_see_upright_edges_exactly() {
    for column in 1..25 {
        let share = f64::from(column) / 25.0;
        for upright in [true, false] {
            let mut scene = half_plane(share - 0.5, upright);
            scene.image.samples = 25;
            let pixel = render::pixel(&built(&scene), [1, 1]);
            assert!((pixel.r - share).abs() < 1e-15, "{share}: {pixel:?}");
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

/// The chapter's sinusoid, `(1 + sin(x² y²))/2`.
#[derive(Debug)]
struct Sinusoid;

impl Texture for Sinusoid {
    fn color(&self, at: &TexturePoint<'_>) -> Rgb {
        let (x, y) = (at.local.x(), at.local.y());
        Rgb::grey(0.5 * (1.0 + sin(x * x * y * y)))
    }
}

/// The sinusoid over [0, 10.83]² in `width` × `width` pixels.
fn sinusoid(width: u32) -> Scene {
    let mut scene = from_front(width, width, 10.83 / f64::from(width));
    scene.camera.eye = Point::new(10.83 / 2.0, 10.83 / 2.0, 10.0);
    scene.camera.look_at = scene.camera.eye - Vector::Z;
    let paint = Paint::from(textures::Kind::Custom(Custom(Arc::new(Sinusoid))));
    scene.materials.push(Material::new("sinusoid", Emissive::new(1.0, paint)));
    scene.objects.push(Object::new(
        "wall",
        "sinusoid",
        Plane { point: Point::ORIGIN, normal: Vector::Z },
    ));
    scene
}

/// Law: one sample shows the function at the pixel's centre, aliased or not. Oracle: the function at `s (c +
/// ½)`, `s (r + ½)`; the phase x² y², up to 13 755, has a rounding error of as many u.
#[test]
fn the_sinusoid_is_shown_at_the_centres() {
    let film = render::render(&built(&sinusoid(128)));
    for at in pixels(128, 128) {
        let s = 10.83 / 128.0;
        let (x, y) = (s * (f64::from(at[0]) + 0.5), s * (127.5 - f64::from(at[1])));
        let expected = 0.5 * (1.0 + sin(x * x * y * y));
        assert!((film.get(at).g - expected).abs() < 1e-10, "{at:?}");
    }
}

/// Law: many samples show the mean over the pixel, one sample any value of the function. The error of n × n
/// jittered samples is no larger than that of as many independent ones, and its mean over seeds is zero.
/// Oracle: mean and variance by the midpoint rule on 400 × 400 cells; t tests of 16 replicas of each pixel;
/// the standard error `σ/n` of independent samples, which stratified ones cannot exceed.
/// Book: antialiasing fine detail.
#[test]
fn more_samples_show_the_mean_over_the_pixel() {
    const REPLICAS: u64 = 16;
    const PIXELS: usize = 32;
    let mut one = sinusoid(32);
    let mut many = one.clone();
    one.image.sampler = Some(Regular {}.into());
    many.image.samples = 1024;
    many.image.sampler = Some(Jittered {}.into());
    let [one, mut many] = [one, many].map(|scene| built(&scene));
    let at = |i: u32| [i, 31 - i];
    let mut values = vec![Vec::new(); PIXELS];
    for seed in 0..REPLICAS {
        many.reseed(seed);
        for (i, values) in (0..).zip(&mut values) {
            values.push(render::pixel(&many, at(i)).g);
        }
    }
    let mut surprising = 0;
    for (i, values) in (0..).zip(&values) {
        let s = 10.83 / 32.0;
        let (left, bottom) = (s * f64::from(at(i)[0]), s * f64::from(31 - at(i)[1]));
        let fine = |i: u32| s * (f64::from(i) + 0.5) / 400.0;
        let (mut mean, mut square) = (0.0, 0.0);
        for [i, j] in pixels(400, 400) {
            let (x, y) = (left + fine(i), bottom + fine(j));
            let value = 0.5 * (1.0 + sin(x * x * y * y));
            (mean, square) = (mean + value / 160_000.0, square + value * value / 160_000.0);
        }
        let sigma = (square - mean * mean).max(0.0).sqrt();
        let p = one_sample(values, mean);
        let found = values.iter().sum::<f64>() / REPLICAS as f64;
        // in a corner of the picture the function is flat: there the midpoint rule and the samples agree to
        // rounding
        let same = (found - mean).abs() < 1e-9;
        assert!(
            same || p > sidak(1e-3, PIXELS),
            "{:?}: the mean of the replicas is {found}, expected {mean}, p = {p:e}",
            at(i)
        );
        for value in values {
            // six standard errors: if the values were normal and independent, one of the 512 would exceed
            // this once in a million runs
            let most = 6.0 * sigma / 32.0 + 1e-9;
            assert!(
                (value - mean).abs() <= most,
                "{:?}: {value}, expected {mean} ± {most:e}",
                at(i)
            );
        }
        // the error of one sample is about the standard deviation of the function
        surprising += u32::from((render::pixel(&one, at(i)).g - mean).abs() > 6.0 * sigma / 32.0);
    }
    assert!(surprising > 16, "one sample shows the mean of {} of 32 pixels", 32 - surprising);
}

/// Law: the mean of a million samples is right to 1e-12, whatever their order and signs. Oracle: whole
/// multiples of 2⁻³⁰, added in 128-bit whole numbers.
#[test]
fn the_mean_of_a_million_samples_is_right() {
    let mut random = groundtruth::math::Pcg32::new(1, 1);
    let unit = groundtruth::math::power_of_two(-30);
    for largest in [1 << 30, 1 << 45] {
        let mut total = 0_i128;
        let samples: Vec<Rgb> = (0..1_000_000)
            .map(|i| {
                // a few huge ones among many small
                let huge = if i % 1000 == 0 { largest } else { 1 << 20 };
                let value = i64::from(random.next_u32()) * (huge >> 20);
                total += i128::from(value);
                Rgb::new(value as f64 * unit, 0.1, 1.0 / 3.0)
            })
            .collect();
        let mean = render::mean(samples.into_iter());
        let expected = total as f64 * unit / 1e6;
        assert!((mean.r - expected).abs() <= 1e-15 * expected, "{} {expected}", mean.r);
        near!(mean.g, 0.1, 1e-16);
        near!(mean.b, 1.0 / 3.0, 1e-16);
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
