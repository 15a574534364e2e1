//! Lamps that are spheres: which side shines, and the density of their samples at all distances.

use dashu_ratio::RBig;
use groundtruth::lights::{LightContext, Target};
use testkit::properties::*;

use super::irradiance::sphere_share;
use super::*;
use crate::prelude::*;

/// The sphere as an instance that is turned, mirrored and enlarged.
fn mirrored_and_moved(center: Point, radius: f64, inward: bool) -> Instance {
    let own = Sphere { center: Point::ORIGIN, radius: 0.5 * radius, inward };
    let steps = vec![
        Step::RotateX(40.0),
        Step::Scale(Vector::new(-2.0, 2.0, 2.0)),
        Step::Translate(center.to_vector()),
    ];
    Instance::new(own, steps)
}

/// Law: from outside, a sphere shines by its near side alone: with the whole closed form if that side is the
/// front or the lamp has two sides, not at all if it is the back; whether or not anything casts shadows, so that
/// the far side, which faces the point, adds nothing through the near one. Oracle: the closed form, and black;
/// both ways of sampling,
/// and an instance of a sphere.
#[test]
fn only_the_near_side_of_a_sphere_shines_outside() {
    const SAMPLES: u32 = 128;
    const POWER: f64 = 0.06;
    let (radius, n) = (1.2, Normal::new(Vector::new(0.4, 1.0, -0.3)).expect("not zero"));
    for (inward, two_sided) in [(false, false), (false, true), (true, false), (true, true)] {
        for (distance, angle, is_instance) in [(2.0, 0.3, false), (1.6, 1.6, true)] {
            let center = Point::ORIGIN + distance * radius * at_angle(n, cos(angle), 2.0);
            let shape = |is_instance| match is_instance {
                false => shapes::Kind::from(Sphere { center, radius, inward }),
                true => mirrored_and_moved(center, radius, inward).into(),
            };
            let shines = two_sided || !inward;
            let expected = if shines { lit(sphere_share(distance, angle)) } else { Rgb::BLACK };
            for (sampling, shadows) in [Sampling::Area, Sampling::SolidAngle]
                .into_iter()
                .flat_map(|sampling| [0, 1, 2].map(|shadows| (sampling, shadows)))
            {
                let mut scene = floor(n);
                let lamp = hang(&mut scene, shape(is_instance), Some(sampling));
                scene.materials[lamp].two_sided = two_sided;
                scene.lights[0].shadows = shadows != 1;
                scene.materials[lamp].casts_shadows = shadows != 2;
                let what = format!(
                    "{distance} radii away, instance {is_instance}, inward {inward}, two-sided {two_sided}, {sampling:?}, \
                     shadows {}",
                    ["all", "none of the light", "none of the lamp"][shadows]
                );
                let values = seen(&scene, SAMPLES, Point::ORIGIN, n);
                assert_color(&what, &values, expected, 4 * 2 * 6, POWER);
            }
        }
    }
}

fn exact(value: f64) -> RBig {
    RBig::try_from(value).expect("finite")
}

/// The square of a vector's length.
fn squared(from: Point, to: Point) -> RBig {
    let [from, to] = [from, to].map(|p| p.to_vector().to_array().map(exact));
    (0..3).map(|i| (&to[i] - &from[i]) * (&to[i] - &from[i])).fold(exact(0.0), |sum, x| sum + x)
}

/// π to 32 digits: as a number, and what is missing of it.
fn pi() -> RBig {
    exact(std::f64::consts::PI) + exact(1.224_646_799_147_353_2e-16)
}

/// The light of a sphere sampled in this way.
fn light(sphere: &Sphere, sampling: Sampling) -> groundtruth::world::World {
    let mut scene = stage(Rgb::BLACK);
    put(&mut scene, sphere.clone(), Emissive::new(LS, CE));
    shine(&mut scene, Area { object: "0".to_owned(), sampling: Some(sampling) });
    built(&scene)
}

proptest! {
    #![proptest_config(laws())]

    /// Law: the density of samples by solid angle is one over the solid angle, `1/(2π (1 − cosθ))` with
    /// `sinθ = r/D`, from the surface to 10¹² radii away, where `1 − cosθ` has no digit in common with
    /// `cosθ`. Oracle: `q = 1 − cosθ` solves `q (2 − q) = r²/D²`, which is decided in rational numbers just
    /// below and above the density's q.
    #[test]
    fn the_density_of_a_sphere_is_one_over_its_solid_angle(
        (center, to_point) in (point(10.0), unit()),
        (radius, height) in (-3.0..1.0_f64, -9.0..12.0_f64),
        u in [0.0..1.0_f64, 0.0..1.0_f64],
    ) {
        let radius = power(10.0, radius);
        let from = center + radius * (1.0 + power(10.0, height)) * to_point;
        let sphere = Sphere { center, radius, inward: false };
        let world = light(&sphere, Sampling::SolidAngle);
        let context = LightContext { point: from, normal: Normal::Y };
        let squared_sine = exact(radius) * exact(radius) / squared(from, center);
        // the point may be on the surface, within its rounding
        let cosine = (exact(1.0) - &squared_sine).to_f64().value().max(0.0).sqrt();
        let on_surface = 256.0 * U * (10.0 / radius + 1.0);
        prop_assume!(cosine * cosine > on_surface);
        let sample = world.lights[0].light.sample(&context, &[u]).expect("it faces the point");
        let pdf = sample.pdf.expect("it has an extent");
        // the sine has a few roundings, which the root divides by the cosine
        let room = 16.0 * U * (1.0 + 1.0 / cosine);
        let opening = exact(1.0) / (exact(2.0) * pi() * exact(pdf));
        let beyond = |factor: f64| {
            let q = exact(factor) * &opening;
            (exact(2.0) - &q) * q > squared_sine
        };
        prop_assert_eq!(
            (beyond(1.0 - room), beyond(1.0 + room) || opening >= exact(1.0 - room)),
            (false, true),
            "{} radii away: density {:e}, 1/(π sin²θ) is {:e}",
            squared(from, center).to_f64().value().sqrt() / radius,
            pdf,
            (exact(1.0) / (pi() * &squared_sine)).to_f64().value()
        );
    }

    /// Law: by area the density at a point of a sphere is `d²/(4πr² cosθ')` as seen from outside, from nearby to
    /// 10¹² radii away. Oracle: its square, `d⁶/(4πr² n·w)²` with w the way to the point, in rational numbers.
    /// Book: fig. 18.5, lights that are disks and spheres.
    #[test]
    fn the_density_by_area_is_that_of_the_point(
        (center, to_point) in (point(10.0), unit()),
        (radius, height) in (-3.0..1.0_f64, -3.0..12.0_f64),
        towards in unit(),
    ) {
        let radius = power(10.0, radius);
        let from = center + radius * (1.0 + power(10.0, height)) * to_point;
        let sphere = Sphere { center, radius, inward: false };
        // of the near half, what is not seen edge-on
        let normal = Normal::new(Vector::from(to_point) + 0.7 * Vector::from(towards));
        let normal = normal.expect("not opposite");
        let point: Point = center + radius * normal;
        let at = Surface::new(point, 0.0, normal);
        let cosine = normal.dot((from - point).unit().expect("apart"));
        prop_assume!(cosine > 1e-3);
        let context = LightContext { point: from, normal: Normal::Y };
        let world = light(&sphere, Sampling::Area);
        let pdf = exact(world.lights[0].light.pdf(&context, &Target::Surface(&at)));
        let (d2, n) = (squared(from, point), Vector::from(normal).to_array().map(exact));
        let [from, to] = [from, point].map(|p| p.to_vector().to_array().map(exact));
        let along = (0..3).map(|i| (&to[i] - &from[i]) * &n[i]).fold(exact(0.0), |sum, x| sum + x);
        let below = exact(4.0) * pi() * exact(radius) * exact(radius) * along;
        let ratio = (&pdf * &pdf * &below * &below / (&d2 * &d2 * &d2)).to_f64().value();
        near!(ratio, 1.0, 32.0 * U * (1.0 + 1.0 / cosine), "density {:e}", pdf.to_f64().value());
    }
}
