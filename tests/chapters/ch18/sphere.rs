//! The density of the samples of spheres at all distances, and what it is good for.

use dashu_ratio::RBig;
use groundtruth::lights::{LightContext, Target};
use testkit::properties::*;

use super::*;
use crate::prelude::*;
use crate::support::statistics::moments;

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
        let sphere = sphere(center, radius);
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
        let sphere = sphere(center, radius);
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

/// Law: near a lamp, the variance of samples by solid angle is at most a tenth of that by area: samples by
/// area fall on parts that face away, and vary with `cosθ'/d²`. Both have the same mean (the laws of closed forms).
/// Oracle: the variance over replicas.
#[test]
fn sampling_by_solid_angle_varies_less_near_a_lamp() {
    for shape in [
        shapes::Kind::from(ball(Point::new(0.0, 1.2, 0.0), 1.0)),
        panel(Point::new(0.0, 0.4, 0.0), 4.0 * Vector::X, 4.0 * Vector::Z).into(),
    ] {
        let variance = |sampling| {
            let mut scene = floor(up());
            hang(&mut scene, shape.clone(), Some(sampling));
            let values = seen(&scene, 64, Point::ORIGIN, up());
            moments(&values.iter().map(|v| v.r).collect::<Vec<_>>()).1
        };
        let (area, angle) = (variance(Sampling::Area), variance(Sampling::SolidAngle));
        assert!(10.0 * angle < area, "{shape:?}: {angle:e} by solid angle, {area:e} by area");
        let mut scene = floor(up());
        hang(&mut scene, shape, None);
        let lights::Kind::Area(area) = &scene.lights[0].source else { panic!("an area light") };
        assert_eq!(area.sampling, None);
        // by default, the light samples by solid angle
        let mut by_name = scene.clone();
        by_name.lights[0].source =
            Area { sampling: Some(Sampling::SolidAngle), ..area.clone() }.into();
        assert_eq!(seen(&scene, 16, Point::ORIGIN, up()), seen(&by_name, 16, Point::ORIGIN, up()));
    }
}
