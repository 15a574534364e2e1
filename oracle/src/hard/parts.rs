//! Target points on cones, paraboloids, and parts of round shapes.

use super::{
    features::around_y,
    rng::SplitMix64,
    vector::{V, add, along, cross, scale, unit},
};
use crate::{
    Shape, angle,
    real::{nearest, real},
};

const UP: V = [0.0, 1.0, 0.0];

/// `(sin, cos)` of degrees.
fn sin_cos(degrees: f64) -> [f64; 2] {
    let (s, c) = angle::sin_cos(&real(degrees));
    [nearest(&s), nearest(&c)]
}

/// The horizontal direction of an azimuth, and the direction in which the azimuth grows.
fn outward(phi: f64) -> [V; 2] {
    let [s, c] = sin_cos(phi);
    [[s, 0.0, c], [c, 0.0, -s]]
}

/// A random azimuth of a range.
fn azimuth([from, to]: [f64; 2], rng: &mut SplitMix64) -> f64 {
    from + rng.unit() * if to < from { to + 360.0 - from } else { to - from }
}

/// One end of a range, and the side (±1) of this end that is outside the range.
fn end(range: [f64; 2], rng: &mut SplitMix64) -> (f64, f64) {
    if rng.coin() { (range[0], -1.0) } else { (range[1], 1.0) }
}

/// A point of the surface and the normal.
pub(super) fn surface(shape: &Shape, rng: &mut SplitMix64) -> (V, V) {
    match shape {
        Shape::PartAnnulus { center, inner, outer, phi } => {
            let [u, _] = outward(azimuth(*phi, rng));
            (along(*center, rng.between(*inner, *outer), u), UP)
        }
        Shape::Cone { height, radius } => {
            let (u, up) = (around_y(rng), rng.unit());
            let point = along([0.0, height * up, 0.0], radius * (1.0 - up), u);
            (point, unit(along(scale(*height, u), *radius, UP)))
        }
        Shape::Paraboloid { height, radius } => {
            let (u, out) = (around_y(rng), rng.unit());
            let point = along([0.0, height * out * out, 0.0], radius * out, u);
            (point, unit(along(scale(2.0 * height * out, u), -radius, UP)))
        }
        Shape::PartSphere { center, radius, phi, theta } => {
            let [u, _] = outward(azimuth(*phi, rng));
            let [s, c] = sin_cos(rng.between(theta[0], theta[1]));
            let n = along(scale(s, u), c, UP);
            (along(*center, *radius, n), n)
        }
        Shape::PartCylinder { y0, y1, radius, phi } => {
            let [u, _] = outward(azimuth(*phi, rng));
            (along([0.0, rng.between(*y0, *y1), 0.0], *radius, u), u)
        }
        _ => unreachable!("not one of these parts"),
    }
}

/// A point of the border, the outward direction, and [`super::features::Feature::silhouette`].
pub(super) fn border(shape: &Shape, rng: &mut SplitMix64) -> (V, V, bool) {
    match shape {
        Shape::PartAnnulus { center, inner, outer, phi } => {
            if rng.coin() {
                let [u, _] = outward(azimuth(*phi, rng));
                let (r, side) = if rng.coin() { (*outer, 1.0) } else { (*inner, -1.0) };
                return (along(*center, r, u), scale(side, u), false);
            }
            let (phi, side) = end(*phi, rng);
            let [u, growth] = outward(phi);
            (along(*center, rng.between(*inner, *outer), u), scale(side, growth), false)
        }
        Shape::Cone { height, .. } if rng.below(4) == 0 => ([0.0, *height, 0.0], UP, true),
        Shape::Cone { height, radius } => {
            let u = around_y(rng);
            (scale(*radius, u), unit(along(scale(*radius, u), -height, UP)), false)
        }
        Shape::Paraboloid { .. } if rng.below(4) == 0 => ([0.0; 3], scale(-1.0, UP), true),
        Shape::Paraboloid { height, radius } => {
            let u = around_y(rng);
            let point = along([0.0, *height, 0.0], *radius, u);
            (point, unit(along(scale(*radius, u), 2.0 * height, UP)), false)
        }
        Shape::PartSphere { center, radius, phi, theta } => {
            let whole = *phi == [0.0, 360.0];
            let (azimuth, side) =
                if whole || rng.coin() { (azimuth(*phi, rng), 0.0) } else { end(*phi, rng) };
            let (polar, down) =
                if side == 0.0 { end(*theta, rng) } else { (rng.between(theta[0], theta[1]), 0.0) };
            let ([u, growth], [s, c]) = (outward(azimuth), sin_cos(polar));
            let n = along(scale(s, u), c, UP);
            let out = if side == 0.0 { scale(down, cross(growth, n)) } else { scale(side, growth) };
            (along(*center, *radius, n), out, false)
        }
        Shape::PartCylinder { y0, y1, radius, phi } => {
            if rng.coin() {
                let [u, _] = outward(azimuth(*phi, rng));
                let (y, up) = if rng.coin() { (*y1, 1.0) } else { (*y0, -1.0) };
                return (along([0.0, y, 0.0], *radius, u), [0.0, up, 0.0], false);
            }
            let (phi, side) = end(*phi, rng);
            let [u, growth] = outward(phi);
            let point = add([0.0, rng.between(*y0, *y1), 0.0], scale(*radius, u));
            (point, scale(side, growth), false)
        }
        _ => unreachable!("not one of these parts"),
    }
}
