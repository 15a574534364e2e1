//! The rays of the hard cases, through or beside a feature of the shape.

use super::{
    Family,
    features::{Feature, border, center_and_size, generator, surface},
    rng::SplitMix64,
    vector::{V, add, along, length, minus, perpendicular, scale, unit},
};
use crate::{Ray, Shape};

pub(super) fn ray(shape: &Shape, family: Family, rng: &mut SplitMix64) -> Ray {
    let (center, size) = center_and_size(shape);
    let from = |distance: f64, rng: &mut SplitMix64| along(center, distance, rng.direction());
    match family {
        Family::Ordinary => aimed(shape, from(size * rng.between(2.0, 10.0), rng), rng),
        Family::FarOrigin => aimed(shape, from(size * rng.decades(3, 8), rng), rng),
        Family::TinyShape => aimed(shape, from(rng.between(0.5, 10.0), rng), rng),
        Family::HugeShape => huge(shape, size, rng),
        Family::Thin => aimed(shape, from(rng.between(2.0, 10.0), rng), rng),
        Family::Grazing => grazing(shape, size, rng),
        Family::Tangent => tangent(shape, size, rng),
        Family::OnSurface => on_surface(shape, rng),
        Family::AxisParallel => along_axis(shape, size, rng),
        Family::EdgesAndCorners => through_border(shape, size, rng),
        Family::Degenerate => degenerate(shape, size, rng),
        Family::Scaled => {
            let Ray { origin, direction } =
                aimed(shape, from(size * rng.between(2.0, 10.0), rng), rng);
            Ray { origin, direction: scale(rng.decades(-6, 6) / length(direction), direction) }
        }
    }
}

/// Aimed at a point of the surface or, equally often, beside it by about the shape's size. One ray in
/// 16 (at planes more than half) points away: a plane cannot be missed otherwise. Half of the
/// directions are unit.
fn aimed(shape: &Shape, origin: V, rng: &mut SplitMix64) -> Ray {
    let target = beside(shape, surface(shape, rng).point, rng);
    let unbounded = matches!(shape, Shape::Plane { .. }) && rng.coin();
    let away = if unbounded || rng.below(16) == 0 { -1.0 } else { 1.0 };
    let direction = scale(away, minus(target, origin));
    Ray { origin, direction: if rng.coin() { unit(direction) } else { direction } }
}

/// The point itself or, equally often, one at a distance of half to twice the shape's size.
fn beside(shape: &Shape, point: V, rng: &mut SplitMix64) -> V {
    let distance = center_and_size(shape).1 * rng.between(0.5, 2.0);
    if rng.coin() { point } else { along(point, distance, rng.direction()) }
}

/// From a point near the surface of a huge shape or far from it, outside or (one in eight) inside. Two
/// in three directions are random: a shape that fills half the sky is hit by half of such rays.
fn huge(shape: &Shape, size: f64, rng: &mut SplitMix64) -> Ray {
    let Feature { point, out, .. } = surface(shape, rng);
    let distance = if rng.coin() { rng.decades(-3, 1) } else { size * rng.unit() };
    let side = if rng.below(8) == 0 { -1.0 } else { 1.0 };
    let origin = along(point, distance * side, out);
    if rng.below(3) == 0 {
        aimed(shape, origin, rng)
    } else {
        Ray { origin, direction: rng.direction() }
    }
}

/// Almost along the surface at a point of it.
fn grazing(shape: &Shape, size: f64, rng: &mut SplitMix64) -> Ray {
    let Feature { point, out, .. } = surface(shape, rng);
    let target = beside(shape, point, rng);
    let flat = unit(perpendicular(rng.direction(), out));
    let direction = along(flat, rng.sign() * rng.decades(-9, -3), out);
    Ray { origin: along(target, -size * rng.between(0.1, 5.0), direction), direction }
}

/// Past a silhouette or border, slightly inside or outside.
fn tangent(shape: &Shape, size: f64, rng: &mut SplitMix64) -> Ray {
    let smooth = round(shape) && rng.coin();
    let Feature { point, out, silhouette } =
        if smooth { surface(shape, rng) } else { border(shape, rng) };
    let target = along(point, rng.sign() * size * rng.decades(-14, -5), out);
    let free = rng.direction();
    let direction = if silhouette { unit(perpendicular(free, out)) } else { free };
    Ray { origin: along(target, -size * rng.between(1.0, 10.0), direction), direction }
}

/// Whether rays can be tangent to the shape away from its border.
fn round(shape: &Shape) -> bool {
    match shape {
        Shape::Sphere { .. }
        | Shape::OpenCylinder { .. }
        | Shape::Cone { .. }
        | Shape::Paraboloid { .. }
        | Shape::PartSphere { .. }
        | Shape::PartCylinder { .. }
        | Shape::Torus { .. }
        | Shape::PartTorus { .. }
        | Shape::Solid(_)
        | Shape::Algebraic { .. } => true,
        Shape::Instance { of, .. } => round(of),
        _ => false,
    }
}

/// From a point of the surface, in a random direction or towards another point of it.
fn on_surface(shape: &Shape, rng: &mut SplitMix64) -> Ray {
    let origin = surface(shape, rng).point;
    let across = minus(surface(shape, rng).point, origin);
    let other = rng.coin() && length(across) > 0.0;
    Ray { origin, direction: if other { across } else { rng.direction() } }
}

/// Along a coordinate axis, with zeros of either sign; one in four starts beyond the target.
fn along_axis(shape: &Shape, size: f64, rng: &mut SplitMix64) -> Ray {
    let axis = rng.axis();
    let target = beside(shape, surface(shape, rng).point, rng);
    let back = if rng.below(4) == 0 { -1.0 } else { 1.0 };
    let origin = along(target, -back * size * rng.between(0.0, 5.0), axis);
    Ray { origin, direction: signed_zeros(axis, rng) }
}

fn signed_zeros(v: V, rng: &mut SplitMix64) -> V {
    v.map(|x| {
        if x == 0.0 && rng.coin() {
            -0.0
        } else if x == 0.0 {
            0.0
        } else {
            x
        }
    })
}

/// Through a point of an edge or corner, exactly where point and origin have few bits. At silhouettes
/// half of the rays are tangent; one ray in eight points away.
fn through_border(shape: &Shape, size: f64, rng: &mut SplitMix64) -> Ray {
    let Feature { point, out, silhouette } = border(shape, rng);
    let free = rng.point_in_cube(4.0);
    let across = if silhouette && rng.coin() { perpendicular(free, out) } else { free };
    let mut direction = across.map(|x| (size * x * 16.0).round() / 16.0);
    if rng.below(4) == 0 {
        direction[rng.below(3)] = 0.0; // within a plane through the point
    }
    if direction == [0.0; 3] {
        direction = rng.axis();
    }
    let origin = minus(point, direction);
    if add(origin, direction) != point {
        direction = minus(point, origin); // the nearest direction to it
    }
    Ray { origin, direction: if rng.below(8) == 0 { scale(-1.0, direction) } else { direction } }
}

/// Along planes, generators and axes; from the plane of a face; with zeros of either sign.
fn degenerate(shape: &Shape, size: f64, rng: &mut SplitMix64) -> Ray {
    let (center, _) = center_and_size(shape);
    let feature = if rng.coin() { border(shape, rng) } else { surface(shape, rng) };
    let target = match rng.below(3) {
        0 => center,
        1 => beside(shape, feature.point, rng),
        _ => feature.point,
    };
    let run = match rng.below(3) {
        0 => generator(shape, rng),
        1 => rng.axis(),
        _ => {
            let mut v = rng.point_in_cube(1.0);
            v[rng.below(3)] = 0.0;
            v
        }
    };
    let back = rng.pick(&[0.0, 1.0, 4.0]) * size;
    Ray { origin: along(target, -back, run), direction: signed_zeros(run, rng) }
}
