//! Fake spherical lights and jittered directional ones: cubes of points and directions.

use groundtruth::lights::{FakeSpherical, JitteredDirectional, Kind};
use testkit::properties::*;

use super::*;
use crate::prelude::*;

const SAMPLES: u32 = 1024;

/// The mean of `f` over the cube `[−1, 1]³`, at the midpoints of 48³ cells. The error is the square of a
/// cell's side, `1/24`, times second derivatives over 24: a few 1e-4 of the value for the lights below.
fn cube_mean(f: impl Fn(Vector) -> f64) -> f64 {
    const CELLS: u32 = 48;
    let along = |i: u32| (f64::from(2 * i + 1) / f64::from(CELLS)) - 1.0;
    let mut sum = 0.0;
    for i in 0..CELLS {
        for j in 0..CELLS {
            for k in 0..CELLS {
                sum += f(Vector::new(along(i), along(j), along(k)));
            }
        }
    }
    sum / f64::from(CELLS * CELLS * CELLS)
}

/// Law: a fake spherical light is the mean of point lights all over a cube of side 2r. Oracle: the mean of
/// 48³ of them, by `k_d l_s cosθ/(π d^k)`; near enough that the corners of the cube matter, and partly below
/// the horizon.
/// Book: fig. 18.12, fake spherical lights.
#[test]
fn a_fake_spherical_light_is_the_mean_of_a_cube_of_points() {
    for (location, jitter, attenuation) in [
        (Point::new(0.3, 1.5, -0.2), 1.0, 2.0),
        (Point::new(1.0, 2.0, 0.5), 0.7, 0.0),
        (Point::new(2.0, 0.3, 1.0), 0.8, 1.0),
        (Point::new(0.5, 4.0, 0.0), 2.0, 2.5),
    ] {
        let mut scene = floor(up());
        shine(&mut scene, FakeSpherical { ls: LS, color: CE, location, jitter, attenuation });
        let expected = cube_mean(|offset| {
            let to_light = location + jitter * offset - Point::ORIGIN;
            let d = to_light.length();
            (to_light.y() / d).max(0.0) / power(d, attenuation)
        });
        let values = seen(&scene, SAMPLES, Point::ORIGIN, up());
        let what = format!("{location:?}, jitter {jitter}, attenuation {attenuation}");
        assert_color(&what, &values, (FRAC_1_PI * LS * expected) * CE, 4, 4e-3);
    }
}

/// Law: a jittered directional light is the mean of directional ones: unit directions moved by up to r along
/// each axis and normalised again. Oracle: the mean of 48³ of them.
/// Book: jittered directional lights.
#[test]
fn a_jittered_directional_light_is_the_mean_of_a_cube_of_directions() {
    for (direction, jitter) in [
        (Vector::new(0.0, 5.0, 0.0), 0.5),
        (Vector::new(1.0, 1.0, -0.3), 0.2),
        (Vector::new(3.0, 0.3, 1.0), 0.4),
        (Vector::new(0.2, 0.1, 0.0), 0.9),
    ] {
        let mut scene = floor(up());
        shine(&mut scene, JitteredDirectional { ls: LS, color: CE, direction, jitter });
        let unit = direction.unit().expect("not zero");
        let expected = cube_mean(|offset| {
            let moved = unit + jitter * offset;
            (moved.y() / moved.length()).max(0.0)
        });
        let values = seen(&scene, SAMPLES, Point::ORIGIN, up());
        assert_color(
            &format!("{direction:?}, {jitter}"),
            &values,
            (FRAC_1_PI * LS * expected) * CE,
            4,
            4e-3,
        );
    }
}

/// Law: the points of a fake spherical light fill the whole cube and nothing else, each axis evenly: mean 0,
/// mean square 1/3, mean products 0. Oracle: these moments of the end points of the shadow rays; no point is
/// farther than r along an axis.
/// Book: fig. 18.12, fake spherical lights.
#[test]
fn the_points_of_a_fake_spherical_light_fill_a_cube() {
    let (location, jitter) = (Point::new(3.0, 5.0, -2.0), 0.25);
    let mut scene = floor(up());
    shine(&mut scene, FakeSpherical { ls: LS, color: CE, location, jitter, attenuation: 0.0 });
    let moments = replicas(&with_samples(scene, SAMPLES), |world| {
        let ray = ray(Point::new(0.0, 1.0, 0.0), -Vector::Y);
        let mut sums = [0.0; 9];
        for i in 0..SAMPLES {
            let mut tree = RayTree::of(world);
            radiance(world, &ray, world.draws([0, 0], i), &mut tree);
            let shadow = &tree.rays()[1].ray;
            let [x, y, z] = ((1.0 / jitter) * (shadow.at(1.0) - location)).to_array();
            assert!([x, y, z].iter().all(|c| c.abs() <= 1.0 + 1e-12), "{x} {y} {z} is outside");
            let of = [
                x,
                y,
                z,
                x * x - 1.0 / 3.0,
                y * y - 1.0 / 3.0,
                z * z - 1.0 / 3.0,
                x * y,
                y * z,
                z * x,
            ];
            sums.iter_mut().zip(of).for_each(|(sum, value)| *sum += value / f64::from(SAMPLES));
        }
        sums
    });
    for which in 0..9 {
        // 1 is added, as errors are compared with the size of the value
        let values: Vec<f64> = moments.iter().map(|sums| 1.0 + sums[which]).collect();
        assert_mean(&format!("moment {which}"), &values, 1.0, 9, 0.01);
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: laws().cases / 4, ..laws() })]

    /// Law: without jitter the fake spherical light is the point light, and the jittered directional one the
    /// directional light. Oracle: those, with shadows; bit for bit, but for normalising a unit vector again.
    /// Book: fig. 18.12, fake spherical lights.
    #[test]
    fn without_jitter_there_is_one_point_and_one_direction(
        location in point(3.0),
        direction in unit(),
        attenuation in prop_oneof![Just(0.0), Just(2.0), 0.0..3.0_f64],
        target in point(1.0),
        jitter in prop_oneof![Just(0.0), Just(-0.0)],
    ) {
        let with = |source: Kind| {
            let mut scene = floor(up());
            put(&mut scene, ball(Point::new(0.0, 0.7, 0.0), 0.5), white());
            shine(&mut scene, source);
            let eye = Point::new(0.5, 3.0, 4.0);
            view(&built(&with_samples(scene, 4)), eye, target - eye)
        };
        let (ls, color, direction) = (LS, CE, 3.0 * direction);
        prop_assert_eq!(
            with(FakeSpherical { ls, color, location, jitter, attenuation }.into()),
            with(PointLight { ls, color, location, attenuation }.into())
        );
        let jittered = with(JitteredDirectional { ls, color, direction, jitter }.into());
        let plain = with(Directional { ls, color, direction }.into());
        // the cosine of a grazing light has an error of some u
        let rounding = (jittered + -1.0 * plain).to_array().map(f64::abs);
        prop_assert!(
            rounding.into_iter().all(|c| c <= 8.0 * U),
            "{jittered:?}, expected {plain:?}"
        );
    }
}
