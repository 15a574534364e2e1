//! The environment light.

use testkit::properties::*;

use super::*;
use crate::prelude::*;

const SKY: Rgb = Rgb::new(0.9, 0.6, 1.8);

/// A plane in the light of the sky.
fn under_the_sky(normal: Normal, matte: Matte) -> Scene {
    let mut scene = stage(SKY);
    put(&mut scene, Plane { point: Point::ORIGIN, normal: normal.into() }, matte);
    shine(&mut scene, Environment {});
    scene
}

proptest! {
    #![proptest_config(laws())]

    /// Law: under a free sky a matte surface has the radiance `k_d c_d L`, in each single sample: directions
    /// drawn in proportion to the cosine leave no variance. Oracle: the product (ch. 18), to some 20 u except
    /// for grazing directions.
    /// Book: environment lights.
    #[test]
    fn each_sample_of_a_free_sky_is_the_whole_of_it(
        n in unit(),
        (kd, cd) in (0.0..1.0_f64, color()),
        (cosine, phi) in (1e-3..1.0_f64, 0.0..TAU),
        pixel in [0..64_u32, 0..64_u32],
    ) {
        let scene = with_samples(
            under_the_sky(n, Matte { ka: 0.0.into(), kd: kd.into(), cd: cd.into() }),
            16,
        );
        let world = built(&scene);
        let to_eye = at_angle(n, cosine, phi);
        let ray = ray(Point::ORIGIN + 2.0 * to_eye, -to_eye);
        for i in 0..16 {
            let mut tree = RayTree::of(&world);
            let seen = radiance(&world, &ray, world.draws(pixel, i), &mut tree);
            let expected = kd * (cd * SKY);
            // the cosine of a grazing direction has an absolute error of some u
            let cosine = tree.rays().get(1).map_or(1.0, |shadow| n.dot(shadow.ray.direction));
            let tolerance = 16.0 * U + 4.0 * U / cosine;
            prop_assert!(
                close(seen, expected, tolerance),
                "sample {i}: {seen:?}, expected {expected:?}"
            );
        }
    }
}

/// Law: the part of the sky that a wall hides gives no light: beside a wall that rises to the angle a, `½ (1
/// + cos a)` of it is left. Oracle: the closed form of chapter 17; the wall is black here.
#[test]
fn a_wall_hides_its_share_of_the_sky() {
    for tall in [0.5, 2.0_f64] {
        let mut scene = under_the_sky(up(), white());
        let long = 1e5;
        let wall = Rectangle {
            corner: Point::new(1.0, 0.0, -long),
            a: 2.0 * long * Vector::Z,
            b: tall * Vector::Y,
        };
        put(&mut scene, wall, Matte { ka: 0.0.into(), kd: 0.0.into(), cd: Rgb::BLACK.into() });
        let visible = 0.5 * (1.0 + 1.0 / (1.0 + tall * tall).sqrt());
        let values = seen(&scene, 1024, Point::ORIGIN, up());
        assert_color(&format!("wall of height {tall}"), &values, visible * SKY, 2, 2e-3);
    }
}

/// Law: the sky's highlight on a glossy surface, seen from straight above, is `2π k_s/(e + 2)` of the sky's
/// radiance, in addition to the diffuse share. Oracle: the closed form of chapter 15.
#[test]
fn the_highlight_of_the_sky_is_its_albedo() {
    for exponent in [0.0, 3.0, 10.0] {
        let mut scene = under_the_sky(up(), white());
        let ks = 0.2;
        let phong = Phong {
            ka: 0.0.into(),
            kd: 0.5.into(),
            cd: Rgb::WHITE.into(),
            ks: ks.into(),
            cs: Rgb::new(1.0, 0.5, 0.0).into(),
            exponent: exponent.into(),
        };
        scene.materials[0].recipe = phong.into();
        let scene = with_samples(scene, 1024);
        let down =
            |world: &groundtruth::world::World| view(world, Point::new(0.0, 1.0, 0.0), -Vector::Y);
        let values = replicas(&scene, down);
        let share = ks * TAU / (exponent + 2.0);
        let expected = Rgb::new(0.5 + share, 0.5 + 0.5 * share, 0.5) * SKY;
        let red: Vec<f64> = values.iter().map(|v| v.r).collect();
        assert_mean(&format!("exponent {exponent}"), &red, expected.r, 9, 5e-3);
        assert_color(&format!("exponent {exponent}"), &values, expected, 3, 5e-3);
    }
}

/// Law: the variance of the sky's light falls with the number of samples: as 1/N for random ones, faster for
/// multi-jittered ones. Oracle: the variance over reseeded pixels, against that with a fourth of the samples;
/// a slanted wall hides part of the sky.
/// Book: environment lights.
#[test]
fn multi_jittered_noise_falls_faster_than_random_noise() {
    use groundtruth::samplers::{Kind, MultiJittered, Random};
    const PIXELS: u64 = 2048;
    // five standard deviations of a ratio of two variances of 2048 values, √(2·2/2048)
    const RATIO: f64 = 5.0 * 0.0442;
    let mut scene = under_the_sky(up(), white());
    let leaning = Plane { point: Point::new(1.0, 0.0, 0.0), normal: Vector::new(-1.0, 0.7, 0.3) };
    put(&mut scene, leaning, Matte { ka: 0.0.into(), kd: 0.0.into(), cd: Rgb::BLACK.into() });
    let variance = |sampler: Kind, samples: u32| {
        let mut scene = scene.clone();
        (scene.image.samples, scene.image.sampler) = (samples, Some(sampler));
        let mut world = built(&scene);
        let mut one = |seed| {
            world.reseed(seed);
            view(&world, Point::new(0.0, 1e-3, 0.0), -Vector::Y).r
        };
        let values: Vec<f64> = (0..PIXELS).map(&mut one).collect();
        let mean = values.iter().sum::<f64>() / PIXELS as f64;
        values.iter().map(|x| (x - mean) * (x - mean)).sum::<f64>() / (PIXELS - 1) as f64
    };
    let random = variance(Random {}.into(), 4) / variance(Random {}.into(), 16);
    assert!(
        (random / 4.0 - 1.0).abs() < RATIO,
        "random: 4 times the samples, 1/{random} of the variance"
    );
    let spread = variance(MultiJittered {}.into(), 4) / variance(MultiJittered {}.into(), 16);
    // an edge through strata: N^(−3/2), a factor of 8
    assert!(spread > 4.0 * (1.0 + RATIO), "multi-jittered: 1/{spread} of the variance");
}
