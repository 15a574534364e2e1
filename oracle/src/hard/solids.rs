//! The cut face and the solids of several parts: their dimensions, and target points.

use super::{
    Family, Kind,
    features::{self, Feature, around_y},
    rng::SplitMix64,
    shapes::{Want, cuboid, cylinder, snapped, tall_or_flat},
    vector::{V, along, length, minus, scale, unit},
};
use crate::{
    Shape, Solid,
    real::{V as Exact, nearest, real},
    solid::{Form, Part, parts},
    solve::{face::Cap, solid::outside},
};

/// A square with a hole inside it, or with one that cuts the sides and leaves only corners; when thin, a
/// tiny hole, or one that leaves almost nothing.
pub(super) fn cut_face(want: &Want, rng: &mut SplitMix64) -> Shape {
    let share = match want.family {
        Family::Thin if rng.coin() => want.aspect,
        Family::Thin => (1.0 - want.aspect) / 2.0_f64.sqrt(),
        _ => rng.between(0.1, 0.65),
    };
    let radius = share * want.size;
    Shape::CutFace { size: want.size, radius: if want.exact() { snapped(radius) } else { radius } }
}

fn number(want: &Want, x: f64) -> f64 {
    if want.exact() { snapped(x) } else { x }
}

/// A share of the possible size; when thin, half of them are slivers.
fn share(want: &Want, [low, high]: [f64; 2], rng: &mut SplitMix64) -> f64 {
    if want.family == Family::Thin && rng.coin() { want.aspect } else { rng.between(low, high) }
}

/// Bevels of the largest possible size (one in four) or smaller.
fn bevel(want: &Want, most: f64, rng: &mut SplitMix64) -> f64 {
    match rng.below(4) {
        0 => most,
        _ if want.exact() => most / [2.0, 4.0, 8.0][rng.below(3)],
        _ => most * share(want, [0.1, 0.95], rng),
    }
}

/// Two ascending heights and a radius.
fn heights(want: &Want, rng: &mut SplitMix64) -> [f64; 3] {
    match cylinder(want, rng) {
        Shape::OpenCylinder { y0, y1, radius } => [y0, y1, radius],
        _ => unreachable!("a cylinder is a cylinder"),
    }
}

/// The inner radius of a ring or a bowl.
fn inner(want: &Want, outer: f64, width: [f64; 2], rng: &mut SplitMix64) -> f64 {
    number(want, outer * (1.0 - share(want, width, rng))).min(outer * (1.0 - 1e-7))
}

pub(super) fn solid(kind: Kind, want: &Want, rng: &mut SplitMix64) -> Solid {
    let size = want.size;
    match kind {
        Kind::SolidCylinder => {
            let [y0, y1, radius] = heights(want, rng);
            Solid::Cylinder { y0, y1, radius }
        }
        Kind::SolidCone => {
            let [height, radius] = tall_or_flat(want, rng);
            Solid::Cone { height, radius }
        }
        Kind::ThickRing => {
            let [y0, y1, outer] = heights(want, rng);
            Solid::ThickRing { y0, y1, inner: inner(want, outer, [0.2, 0.9], rng), outer }
        }
        Kind::FlatRimmedBowl => {
            let inner = inner(want, size, [0.05, 0.4], rng);
            Solid::FlatRimmedBowl { inner, outer: size, opening: opening(want, rng) }
        }
        Kind::RoundRimmedBowl => {
            let inner = inner(want, size, [0.05, 0.3], rng);
            Solid::RoundRimmedBowl { inner, outer: size, opening: opening(want, rng) }
        }
        Kind::ConcaveLens => {
            let min_distance = number(want, size * share(want, [0.05, 1.0], rng));
            let deep = if rng.below(4) == 0 {
                rng.decades(-8, -1)
            } else {
                share(want, [0.05, 0.95], rng)
            };
            let depth = number(want, size * deep);
            Solid::ConcaveLens { radius: size, thickness: min_distance + 2.0 * depth, min_distance }
        }
        Kind::BeveledBox => {
            let Shape::Cuboid { min, max } = cuboid(want, rng) else {
                unreachable!("a box is a box")
            };
            let shortest = (0..3).map(|i| max[i] - min[i]).fold(f64::INFINITY, f64::min);
            Solid::BeveledBox { min, max, bevel: bevel(want, 0.5 * shortest, rng) }
        }
        Kind::BeveledCylinder => {
            let [y0, y1, radius] = heights(want, rng);
            let bevel = bevel(want, radius.min(0.5 * (y1 - y0)), rng);
            Solid::BeveledCylinder { y0, y1, radius, bevel }
        }
        Kind::BeveledRing => {
            let [y0, y1, outer] = heights(want, rng);
            let inner = inner(want, outer, [0.2, 0.9], rng);
            let bevel = bevel(want, 0.5 * (outer - inner).min(y1 - y0), rng);
            Solid::BeveledRing { y0, y1, inner, outer, bevel }
        }
        _ => {
            let [y0, y1, outer] = heights(want, rng);
            let inner = inner(want, outer, [0.2, 0.7], rng);
            let from = rng.between(-180.0, 90.0);
            let (from, width) = if want.exact() {
                (90.0 * rng.below(3) as f64, 90.0 * (1 + rng.below(3)) as f64)
            } else {
                (from, rng.between(30.0, 345.0))
            };
            let to = from + width;
            let phi = [from, if to > 360.0 { to - 360.0 } else { to }];
            // so that the inner corners fit the narrowest wedge: b/(inner + b) ≤ 1/4 < sin(30°/2)
            let fits = if width < 180.0 { inner / 3.0 } else { outer };
            let bevel = bevel(want, (0.5 * (outer - inner).min(y1 - y0)).min(fits), rng);
            Solid::BeveledWedge { y0, y1, inner, outer, phi, bevel }
        }
    }
}

/// A hemisphere half the time.
fn opening(want: &Want, rng: &mut SplitMix64) -> f64 {
    if want.exact() || rng.coin() { 180.0 } else { rng.between(60.0, 300.0) }
}

/// The approximate centre and size of the solid.
pub(super) fn center_and_size(solid: &Solid) -> (V, f64) {
    let round = |y0: f64, y1: f64, radius: f64| ([0.0, 0.5 * (y0 + y1), 0.0], radius.max(y1 - y0));
    match *solid {
        Solid::Cylinder { y0, y1, radius } | Solid::BeveledCylinder { y0, y1, radius, .. } => {
            round(y0, y1, radius)
        }
        Solid::Cone { height, radius } => round(0.0, height, radius),
        Solid::ThickRing { y0, y1, outer, .. }
        | Solid::BeveledRing { y0, y1, outer, .. }
        | Solid::BeveledWedge { y0, y1, outer, .. } => round(y0, y1, outer),
        Solid::FlatRimmedBowl { outer, .. } | Solid::RoundRimmedBowl { outer, .. } => {
            ([0.0; 3], outer)
        }
        Solid::ConcaveLens { radius, thickness, .. } => {
            round(-0.5 * thickness, 0.5 * thickness, radius)
        }
        Solid::BeveledBox { min, max, .. } => {
            (scale(0.5, super::vector::add(min, max)), length(minus(max, min)))
        }
    }
}

/// A random part, all equally likely.
fn any_part(solid: &Solid, rng: &mut SplitMix64) -> Part {
    let mut parts = parts(&solid.exact());
    let which = rng.below(parts.len());
    parts.swap_remove(which)
}

/// A feature of a part, in world space.
fn carried(part: &Part, feature: Feature) -> Feature {
    let exact = |v: V| Exact(v.map(real));
    let world = |v: &Exact| outside(part, v).0.each_ref().map(nearest);
    let point = world(&exact(feature.point));
    let side = if part.hollow { -1.0 } else { 1.0 };
    let turned = &outside(part, &exact(feature.out)) - &part.origin;
    Feature { point, out: scale(side, turned.0.each_ref().map(nearest)), ..feature }
}

pub(super) fn surface(solid: &Solid, rng: &mut SplitMix64) -> Feature {
    let part = any_part(solid, rng);
    let feature = match &part.form {
        Form::Shape(shape) => features::surface(&shape.map(&nearest), rng),
        Form::Cap(cap) => on_cap(cap, false, rng),
        Form::Dish { radius, depth } => on_dish([radius, depth].map(nearest), rng.unit(), rng),
    };
    carried(&part, feature)
}

/// The border of a part: an edge of the solid, or a seam.
pub(super) fn border(solid: &Solid, rng: &mut SplitMix64) -> Feature {
    let part = any_part(solid, rng);
    let feature = match &part.form {
        Form::Shape(shape) => features::border(&shape.map(&nearest), rng),
        Form::Cap(cap) => on_cap(cap, true, rng),
        Form::Dish { radius, depth } => on_dish([radius, depth].map(nearest), 1.0, rng),
    };
    Feature { silhouette: true, ..carried(&part, Feature { silhouette: true, ..feature }) }
}

/// Beside the first side of a wedge: on the line where the bevel begins, or a little farther inside.
fn on_cap(cap: &Cap, at_border: bool, rng: &mut SplitMix64) -> Feature {
    let (s, c) = crate::angle::sin_cos(&cap.phi[0]);
    let [s, c, bevel] = [&s, &c, &cap.bevel].map(nearest);
    let [from, to] = cap.along.each_ref().map(nearest);
    let (out, beside) = ([s, 0.0, c], [c, 0.0, -s]);
    let step = if at_border { 0.0 } else { rng.between(0.0, 0.3) * (to - from) };
    let point = along(scale(rng.between(from, to), out), bevel + step, beside);
    let away = if at_border { scale(-1.0, beside) } else { [0.0, 1.0, 0.0] };
    Feature { point, out: away, silhouette: true }
}

/// A point at this share of the rim's radius; `out` points away from the sphere's centre.
fn on_dish([radius, depth]: [f64; 2], share: f64, rng: &mut SplitMix64) -> Feature {
    let (u, rho) = (around_y(rng), share * radius);
    // the lower solution of y = κ (ρ² + y²)/2
    let bend = 2.0 * depth / (depth * depth + radius * radius);
    let y = bend * rho * rho / (1.0 + (1.0 - (bend * rho) * (bend * rho)).max(0.0).sqrt());
    let point = along([0.0, y, 0.0], rho, u);
    Feature { point, out: minus(scale(bend, point), [0.0, 1.0, 0.0]), silhouette: true }
}

/// A point of the square outside the hole, and the normal.
pub(super) fn on_cut_face(size: f64, radius: f64, rng: &mut SplitMix64) -> (V, V) {
    let half = 0.5 * size;
    let up = [0.0, 1.0, 0.0];
    for _ in 0..32 {
        let [x, z] = [(); 2].map(|()| rng.between(-half, half));
        if x * x + z * z >= radius * radius {
            return ([x, 0.0, z], up);
        }
    }
    // the hole leaves almost only the corners: a point near one
    let inset = 0.5 * (half - radius * 0.5_f64.sqrt()) * rng.unit();
    let corner = half - inset;
    ([rng.sign() * corner, 0.0, rng.sign() * corner], up)
}

/// A point of a side or of the hole's edge, and the direction away from the surface.
pub(super) fn border_of_cut_face(size: f64, radius: f64, rng: &mut SplitMix64) -> (V, V) {
    let half = 0.5 * size;
    for _ in 0..32 {
        let u = around_y(rng);
        let rim = scale(radius, u);
        if rng.coin() && rim[0].abs() <= half && rim[2].abs() <= half {
            return (rim, scale(-1.0, u));
        }
        let out = unit([rng.sign(), 0.0, 0.0]);
        let (mut point, mut out) = ([out[0] * half, 0.0, rng.between(-half, half)], out);
        if rng.coin() {
            (point, out) = ([point[2], 0.0, point[0]], [out[2], 0.0, out[0]]);
        }
        if length(point) >= radius {
            return (point, out);
        }
    }
    let corner = [rng.sign() * half, 0.0, rng.sign() * half];
    (corner, unit(corner))
}
