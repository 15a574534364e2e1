//! Filters on whole pictures: a pixel also uses samples outside its own square.

use groundtruth::filters::{Box, Filter, Gaussian, Kind, Mitchell, Tent};
use groundtruth::math::erf;
use std::f64::consts::SQRT_2;
use testkit::properties::*;

use crate::prelude::*;
use crate::support::replicas::mean_and_error;

/// The polynomials have coefficients up to 60, at |x| up to 2: terms of up to 240/6, each with several
/// rounding errors.
const POLYNOMIAL: f64 = 400.0 * U;

fn filter(kind: impl Into<Kind>) -> std::sync::Arc<dyn Filter> {
    kind.into().build(&mut ()).expect("a valid filter")
}

fn gaussian(sigma: f64, radius: f64) -> Gaussian {
    Gaussian { sigma, radius }
}

/// The specimens of every kind of filter.
fn kinds() -> Vec<Kind> {
    Kind::ENTRIES.iter().flat_map(|entry| (entry.specimens)()).collect()
}

proptest! {
    #![proptest_config(laws())]

    /// Law: the filters of all pixels add up to 1 everywhere, for the box, the tent of radius 1 and
    /// all of Mitchell and Netravali's family (their equation 8 was made so). Oracle: the sum.
    #[test]
    fn filters_of_all_pixels_add_up_to_one(
        b in 0.0..=1.0_f64,
        c in 0.0..=1.0_f64,
        x in 0.0..1.0_f64,
    ) {
        for kind in [Mitchell { b, c }.into(), Tent { radius: 1.0 }.into(), Kind::from(Box {})] {
            let filter = filter(kind);
            prop_assume!(x != 0.5); // two boxes meet there
            let sum: f64 = (-3..=3).map(|i| filter.value(x + f64::from(i))).sum();
            prop_assert!((sum - 1.0).abs() < POLYNOMIAL, "{sum}");
        }
    }

    /// Law: b = 1, c = 0 is the cubic B-spline. Oracle: `Σ (−1)^k (4 choose k) (x + 2 − k)³₊ / 6`.
    #[test]
    fn mitchell_with_b_1_is_the_b_spline(x in -2.5..2.5_f64) {
        let part = |k: i32, times: f64| {
            let p = (x + 2.0 - f64::from(k)).max(0.0);
            times * p * p * p / 6.0
        };
        let spline = part(0, 1.0) + part(1, -4.0) + part(2, 6.0) + part(3, -4.0) + part(4, 1.0);
        let found = filter(Mitchell { b: 1.0, c: 0.0 }).value(x);
        prop_assert!((found - spline).abs() < POLYNOMIAL, "{found} {spline}");
    }

    /// Law: the interpolating filters, b = 0, are 1 at the centre and 0 at all other whole numbers; the
    /// general one is `1 − b/3`, `b/6` and 0 at 0, 1 and 2. Oracle: the paper's polynomials there.
    #[test]
    fn mitchell_has_its_values_at_whole_numbers(b in 0.0..=1.0_f64, c in 0.0..=1.0_f64) {
        let filter = filter(Mitchell { b, c });
        for (x, value) in [(0.0, 1.0 - b / 3.0), (1.0, b / 6.0), (-1.0, b / 6.0), (2.0, 0.0)] {
            prop_assert!((filter.value(x) - value).abs() < POLYNOMIAL, "{x}");
        }
    }

    /// Law: the positions that the Gaussian draws follow the normal distribution, truncated. Oracle: the
    /// distribution function at the drawn position, which is u again.
    #[test]
    fn gaussian_positions_are_normal(
        u in 0.0..1.0_f64,
        sigma in 0.2..3.0_f64,
        radius in 0.3..6.0_f64,
    ) {
        let (position, weight) = filter(gaussian(sigma, radius)).draw(u);
        let share = |x: f64| erf(x / (SQRT_2 * sigma));
        let found = 0.5 * (1.0 + share(position - 0.5) / share(radius));
        prop_assert!((found - u).abs() < 1e-14, "{found} {u}");
        prop_assert_eq!(weight, 1.0);
        let ratio = |x: f64| filter(gaussian(sigma, radius)).value(x * radius)
            / filter(gaussian(sigma, radius)).value(0.0);
        let z = 0.7 * radius / sigma;
        near!(ratio(0.7), exp(-0.5 * z * z), 1e-14);
    }
}

/// A white half plane left of `x`, in a picture of one pixel.
fn edge(x: f64, filter: Kind, samples: u32) -> Scene {
    let mut scene = from_front(1, 1, 1.0);
    scene.image.filter = filter;
    scene.image.samples = samples;
    scene.image.sampler = Some(Random {}.into());
    let half =
        shapes::Cuboid { min: Point::new(-99.0, -99.0, -1.0), max: Point::new(x, 99.0, 1.0) };
    add_flat(&mut scene, "half", half, Rgb::WHITE);
    scene
}

/// Mean and standard error of the only pixel, over seeds. Random samples: replicas are independent.
fn seen(scene: &Scene) -> (f64, f64) {
    mean_and_error(&replicas(scene, |world| render::pixel(world, [0, 0]).r))
}

/// The filter's integral up to `x`, along one axis: quadrature, to 1e-4.
fn integral_to(filter: &dyn Filter, x: f64) -> f64 {
    let r = filter.radius();
    let n = 20_000;
    let h = (x + r).clamp(0.0, 2.0 * r) / f64::from(n);
    (0..n).map(|i| h * filter.value(-r + h * (f64::from(i) + 0.5))).sum()
}

/// Law: the pixel beside an edge is the filter's integral up to the edge, negative lobes too. Oracle:
/// quadrature of the filter; 5 standard errors of 24 replicas, 35 tests.
#[test]
fn an_edge_is_blurred_by_the_filters_integral() {
    for kind in kinds() {
        let value = filter(kind.clone());
        for x in [-1.3, -0.6, 0.0, 0.4, 1.5] {
            let exact = integral_to(&*value, x);
            let (mean, error) = seen(&edge(x, kind.clone(), 256));
            // a pixel wholly on one side has no standard error; the quadrature's error is below 1e-4
            assert!((mean - exact).abs() <= 5.0 * error + 1e-4, "{kind:?} at {x}: {mean} {exact}");
        }
    }
}

/// Law: both axes are filtered alike, negative weights too: an upright and a level edge at the beginning of
/// the negative lobe overshoot equally. Oracle: quadrature; 5 standard errors.
#[test]
fn both_axes_are_filtered() {
    let kind: Kind = Mitchell { b: 0.0, c: 1.0 }.into();
    let exact = integral_to(&*filter(kind.clone()), 1.0);
    // without its sign, the lobe would take the edge below 1
    assert!(exact > 1.05, "{exact}");
    let upright = edge(1.0, kind.clone(), 4096);
    let mut flat = edge(0.0, kind, 4096);
    let half =
        shapes::Cuboid { min: Point::new(-99.0, -99.0, -1.0), max: Point::new(99.0, 1.0, 1.0) };
    flat.objects[0].shape = half.into();
    for scene in [upright, flat] {
        let (mean, error) = seen(&scene);
        assert!(error < 0.01 && (mean - exact).abs() < 5.0 * error, "{mean} ± {error}, {exact}");
    }
}

/// Law: filters without negative lobes leave a constant as it is, to the last bit; the others on the
/// average, with weights that differ in sign only. Oracle: the constant.
#[test]
fn a_constant_stays_what_it_is() {
    for kind in kinds() {
        let mut scene = from_front(2, 2, 1.0);
        scene.background = Rgb::new(0.1, 0.7, 3.0).into();
        scene.image.filter = kind.clone();
        scene.image.samples = 4096;
        scene.image.sampler = Some(Jittered {}.into());
        let found = render::pixel(&built(&scene), [1, 0]);
        if matches!(kind, Kind::Mitchell(_)) {
            // at most 64 + 64 of 4096 jittered cells are cut by a change of sign, each off by ≤ 2 · 1.3²
            assert!((found.g / 0.7 - 1.0).abs() < 0.03, "{kind:?}: {found:?}");
        } else {
            assert_eq!(bits(found), bits(Rgb::new(0.1, 0.7, 3.0)), "{kind:?}");
        }
    }
}

/// Law: leaving the filter out is the box over the pixel, which uses the pixel's samples as they are: bit for
/// bit, and in a scene file nothing is written.
/// Book: filtering: the box over the pixel.
#[test]
fn the_box_is_the_default() {
    let mut scene = edge(0.3, Box {}.into(), 16);
    let with = render::render(&built(&scene));
    let text = scenefile::to_toml(&scene).expect("it can be written");
    assert!(!text.contains("filter"), "{text}");
    scene.image.filter = Kind::default();
    assert_eq!(bits(render::render(&built(&scene)).get([0, 0])), bits(with.get([0, 0])));
}

/// Law: a filter's radius is in units of pixels: at twice the resolution, samples lie half as far from their
/// pixel's centre.
#[test]
fn a_filters_radius_counts_pixels() {
    let mut scene = from_front(4, 4, 1.0);
    scene.image.filter = Tent { radius: 2.0 }.into();
    scene.image.samples = 256;
    let spread = |scene: &Scene| {
        let world = built(scene);
        let far = |at| (0..256).map(move |i| (at, i));
        pixels(scene.image.width, scene.image.height)
            .flat_map(far)
            .map(|(at, i)| {
                let [x, _] = camera_ray(&world, at, i).1;
                let center = render::film_point(&scene.image, at, [0.5, 0.5])[0];
                (x - center).abs()
            })
            .fold(0.0, f64::max)
    };
    let whole = spread(&scene);
    assert!((1.8..=2.0).contains(&whole), "{whole}");
    scene.image.resize(8, 8);
    let half = spread(&scene);
    assert!((0.9..=1.0).contains(&half), "{half}");
}
