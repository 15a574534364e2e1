//! The functions that formulas of laws may call.

use std::f64::consts::FRAC_PI_2;

use groundtruth::math::Frame;

use crate::prelude::*;
use crate::support::lamps::share;
use crate::support::optics::{
    albedo_about_the_mirror_direction as glossy_albedo, by_angles as fresnel,
};

macro_rules! functions {
    ($($name:ident($($argument:ident),+)),+ $(,)?) => {
        /// The value of the function of this name.
        pub fn call(name: &str, arguments: &[f64]) -> f64 {
            match (name, arguments) {
                $((stringify!($name), &[$($argument),+]) => $name($($argument),+),)+
                _ => panic!("there is no function `{name}` of {arguments:?}"),
            }
        }
    };
}

functions! {
    sqrt(x), exp(x), sin(x), cos(x), tan(x), acos(x), degrees(angle), atan2(y, x),
    disk_form_factor(radius, height, aside),
    sphere_share(distance, angle),
    rectangle_form_factor(a, b),
    fresnel(sine, eta),
    glossy_albedo(exponent, cosine),
}

fn sqrt(x: f64) -> f64 {
    x.sqrt()
}

/// An angle in degrees, in radians.
fn degrees(angle: f64) -> f64 {
    to_radians(angle)
}

/// The share of a point's cosine-weighted sky that is filled by a disk parallel to the surface, at this height and its centre
/// this far to the side (Howell's catalogue, B-13).
fn disk_form_factor(radius: f64, height: f64, aside: f64) -> f64 {
    let t = height * height + aside * aside;
    let (sum, product) = (t + radius * radius, 4.0 * radius * radius * aside * aside);
    0.5 * (1.0 - (t - radius * radius) / (sum * sum - product).sqrt())
}

/// The same of a rectangle parallel to the surface, one corner straight above the point: `a` and `b` are its sides divided by the
/// distance (ch. 18).
fn rectangle_form_factor(a: f64, b: f64) -> f64 {
    let (sa, sb) = ((1.0 + a * a).sqrt(), (1.0 + b * b).sqrt());
    (a / sa * atan2(b, sa) + b / sb * atan2(a, sb)) / TAU
}

/// The same of a sphere whose centre is `distance` radii away at this angle from the normal: `cosθ/H²` above the horizon; cut by
/// the horizon, Howell's catalogue, B-43.
fn sphere_share(distance: f64, angle: f64) -> f64 {
    let (h, half) = (distance, FRAC_PI_2 - acos(1.0 / distance));
    if angle <= FRAC_PI_2 - half {
        return cos(angle) / (h * h);
    }
    if angle >= FRAC_PI_2 + half {
        return 0.0;
    }
    let s = (h * h - 1.0).sqrt();
    let asin = |x: f64| FRAC_PI_2 - acos(x);
    let cut = (1.0 - (h * cos(angle)) * (h * cos(angle))).sqrt();
    let above = cos(angle) * acos(-s * cos(angle) / sin(angle)) - s * cut;
    0.5 - asin(s / (h * sin(angle))) / PI + above / (PI * h * h)
}

/// Law: the closed form for a sphere is right. Oracle: its cone of directions, integrated in rings around the
/// axis, of each ring the arc above the horizon; the midpoint rule with 4000 rings has an error of some
/// `1e-7`.
#[test]
fn the_share_of_a_sphere_is_the_integral_over_its_cap() {
    const RINGS: u32 = 4000;
    for (distance, angle) in
        [(2.0, 0.5), (2.0, 1.3), (2.0, 1.7), (1.2, 1.0), (1.2, 2.0), (5.0, 1.5_f64)]
    {
        let step = (FRAC_PI_2 - acos(1.0 / distance)) / f64::from(RINGS);
        let ring = |i: u32| {
            let theta = step * (f64::from(i) + 0.5);
            let (along, across) = (cos(angle) * cos(theta), sin(angle) * sin(theta));
            // the arc above the horizon is all of the ring, or nothing, or |φ| < acos(−along/across)
            let phi = acos((-along / across).clamp(-1.0, 1.0));
            2.0 * (along * phi + across * sin(phi)) * sin(theta) * step / PI
        };
        let integral = (0..RINGS).map(ring).sum::<f64>();
        near!(sphere_share(distance, angle), integral, 1e-6, "{distance} radii away, {angle}");
    }
}

/// Law: the closed forms of disk and rectangle are right. Oracle: Lambert's formula for a rectangle of any size, and for a polygon
/// of 4000 corners, whose area lacks some 1e-6 of the disk's.
#[test]
fn form_factors_are_those_of_lamberts_formula() {
    let share = |corners: &[Point]| share(Point::ORIGIN, Normal::Y, corners);
    for (a, b, h) in [(1.0, 1.0, 1.0), (3.0, 0.5, 2.0), (1e6, 1e6, 1.0_f64)] {
        let corner = |x: f64, z: f64| Point::new(x * a, h, z * b);
        let corners = [corner(0.0, 0.0), corner(1.0, 0.0), corner(1.0, 1.0), corner(0.0, 1.0)];
        near!(rectangle_form_factor(a / h, b / h), share(&corners), 1e-12, "{a} × {b} at {h}");
    }
    let Frame { u, v, .. } = Frame::around(-Normal::Y);
    for (radius, height, aside) in [(1.0, 1.0, 0.0), (2.0, 0.7, 1.0), (1.5, 1.3, 6.0)] {
        let corner = |i: u32| {
            let phi = TAU * f64::from(i) / 4000.0;
            Point::new(aside, height, 0.0) + radius * (cos(phi) * u + sin(phi) * v)
        };
        let corners: Vec<Point> = (0..4000).map(corner).collect();
        near!(
            disk_form_factor(radius, height, aside),
            share(&corners),
            1e-6,
            "{radius} {height} {aside}"
        );
    }
}
