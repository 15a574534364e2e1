//! The rays of the hard cases, through or beside a feature of the shape.

use super::{
    Family,
    features::{Feature, border, generator, place, surface},
    rng::SplitMix64,
    vector::{V, add, along, length, minus, perpendicular, scale, unit},
};
use crate::{Ray, Shape};

pub(super) fn ray(shape: &Shape, family: Family, rng: &mut SplitMix64) -> Ray {
    let (center, size) = place(shape);
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

/// At a point of the surface, or (as often) beside it by up to its size; unit direction or not.
fn aimed(shape: &Shape, origin: V, rng: &mut SplitMix64) -> Ray {
    let target = beside(shape, surface(shape, rng).point, rng);
    let direction = minus(target, origin);
    Ray { origin, direction: if rng.coin() { unit(direction) } else { direction } }
}

/// The point itself, or (as often) one beside it by up to the shape's size.
fn beside(shape: &Shape, point: V, rng: &mut SplitMix64) -> V {
    let distance = place(shape).1 * rng.between(0.5, 2.0);
    if rng.coin() { point } else { along(point, distance, rng.direction()) }
}

/// From a place near the surface of a huge shape, or far from it, outside or inside.
fn huge(shape: &Shape, size: f64, rng: &mut SplitMix64) -> Ray {
    let Feature { point, out, .. } = surface(shape, rng);
    let distance = if rng.coin() { rng.decades(-3, 1) } else { size * rng.unit() };
    aimed(shape, along(point, distance * rng.sign(), out), rng)
}

/// Almost along the surface at a point of it.
fn grazing(shape: &Shape, size: f64, rng: &mut SplitMix64) -> Ray {
    let Feature { point, out, .. } = surface(shape, rng);
    let target = beside(shape, point, rng);
    let flat = unit(perpendicular(rng.direction(), out));
    let direction = along(flat, rng.sign() * rng.decades(-9, -3), out);
    Ray { origin: along(target, -size * rng.between(0.1, 5.0), direction), direction }
}

/// Past a silhouette or border, by a hair inside or outside.
fn tangent(shape: &Shape, size: f64, rng: &mut SplitMix64) -> Ray {
    let Feature { point, out, silhouette } =
        if rng.coin() { border(shape, rng) } else { surface(shape, rng) };
    let target = along(point, rng.sign() * size * rng.decades(-14, -5), out);
    let free = rng.direction();
    let direction = if silhouette { unit(perpendicular(free, out)) } else { free };
    Ray { origin: along(target, -size * rng.between(1.0, 10.0), direction), direction }
}

/// From the surface, anywhere.
fn on_surface(shape: &Shape, rng: &mut SplitMix64) -> Ray {
    let origin = surface(shape, rng).point;
    let across = minus(surface(shape, rng).point, origin);
    let other = rng.coin() && length(across) > 0.0;
    Ray { origin, direction: if other { across } else { rng.direction() } }
}

/// Along a coordinate axis, zeros of either sign.
fn along_axis(shape: &Shape, size: f64, rng: &mut SplitMix64) -> Ray {
    let axis = rng.axis();
    let target = beside(shape, surface(shape, rng).point, rng);
    let origin = along(target, -size * rng.between(0.0, 5.0), axis);
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

/// Through a point of an edge or corner: exactly, where point and origin have few bits.
fn through_border(shape: &Shape, size: f64, rng: &mut SplitMix64) -> Ray {
    let target = border(shape, rng).point;
    let offset = scale(size.max(1.0 / 64.0), rng.place(4.0)).map(|x| (x * 16.0).round() / 16.0);
    let mut direction = if offset == [0.0; 3] { [1.0, 0.0, 0.0] } else { offset };
    if rng.below(4) == 0 {
        direction[rng.below(2)] = 0.0; // within a plane through the point
        direction[2] = if direction[2] == 0.0 { 1.0 } else { direction[2] };
    }
    let ray = Ray { origin: minus(target, direction), direction };
    let exact = add(ray.origin, ray.direction) == target;
    if exact { ray } else { Ray { direction: minus(target, ray.origin), ..ray } }
}

/// Along planes and generators; from the plane of a face; with zeros of either sign.
fn degenerate(shape: &Shape, size: f64, rng: &mut SplitMix64) -> Ray {
    let (center, _) = place(shape);
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
            let mut v = rng.place(1.0);
            v[rng.below(3)] = 0.0;
            v
        }
    };
    let back = rng.pick(&[0.0, 1.0, 4.0]) * size;
    Ray { origin: along(target, -back, run), direction: signed_zeros(run, rng) }
}
