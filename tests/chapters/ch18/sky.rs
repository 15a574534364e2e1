//! The environment light.

use groundtruth::samplers;
use testkit::properties::*;

use super::*;
use crate::prelude::*;
use crate::support::replicas::{VARIANCE_ERROR, variance};

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
        let scene = with_samples(under_the_sky(n, matte(0.0, kd, cd)), 16);
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
            close!(seen, expected, tolerance, "sample {i}");
        }
    }
}

/// Law: the variance of the sky's light falls with the number of samples: as 1/N for random ones, faster for
/// multi-jittered ones. Oracle: the variance over reseeded pixels, against that with a fourth of the samples;
/// a slanted wall hides part of the sky.
/// Book: environment lights.
#[test]
fn multi_jittered_noise_falls_faster_than_random_noise() {
    // five standard deviations of a ratio of two variances
    const RATIO: f64 = std::f64::consts::SQRT_2 * VARIANCE_ERROR;
    let mut scene = under_the_sky(up(), white());
    let leaning = Plane { point: Point::new(1.0, 0.0, 0.0), normal: Vector::new(-1.0, 0.7, 0.3) };
    put(&mut scene, leaning, matte(0.0, 0.0, Rgb::BLACK));
    let falls = |sampler: samplers::Kind| {
        let [four, sixteen] = [4, 16].map(|samples| {
            let seen = |world: &World| view(world, Point::new(0.0, 1e-3, 0.0), -Vector::Y).r;
            variance(&scene, sampler.clone(), samples, seen)
        });
        four / sixteen
    };
    near!(falls(Random {}.into()) / 4.0, 1.0, RATIO);
    // an edge through strata: N^(−3/2), a factor of 8
    above!(falls(MultiJittered {}.into()), 4.0 * (1.0 + RATIO));
}
