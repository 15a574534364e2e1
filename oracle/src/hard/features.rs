//! Points of a shape at which rays are aimed.

use super::{
    parts,
    rng::SplitMix64,
    solids,
    vector::{V, add, along, cross, dot, length, minus, perpendicular, scale, unit},
};
use crate::{
    Shape,
    real::{nearest, real},
};

/// A point of the surface and a unit vector that points away from the shape there: the normal, or at a
/// border the direction in which the surface ends.
pub(super) struct Feature {
    pub(super) point: V,
    pub(super) out: V,
    /// Whether rays through the point must be perpendicular to `out` to touch the shape; at a border, all do.
    pub(super) silhouette: bool,
}

/// The approximate centre and size of the shape.
pub(super) fn center_and_size(shape: &Shape) -> (V, f64) {
    match shape {
        Shape::Plane { point, .. } => (*point, 1.0),
        Shape::Sphere { center, radius } | Shape::Disk { center, radius, .. } => (*center, *radius),
        Shape::Cuboid { min, max } | Shape::Algebraic { min, max, .. } => {
            (scale(0.5, add(*min, *max)), length(minus(*max, *min)))
        }
        Shape::Triangle { vertices: [a, b, c] } => {
            let size = length(minus(*b, *a)).max(length(minus(*c, *a)));
            (scale(1.0 / 3.0, add(add(*a, *b), *c)), size)
        }
        Shape::Rectangle { corner, a, b } => {
            (along(along(*corner, 0.5, *a), 0.5, *b), length(*a).max(length(*b)))
        }
        Shape::OpenCylinder { y0, y1, radius } => {
            ([0.0, 0.5 * (y0 + y1), 0.0], radius.max(y1 - y0))
        }
        Shape::Annulus { center, outer: size, .. }
        | Shape::PartAnnulus { center, outer: size, .. }
        | Shape::PartSphere { center, radius: size, .. } => (*center, *size),
        Shape::Cone { height, radius } | Shape::Paraboloid { height, radius } => {
            ([0.0, 0.5 * height, 0.0], radius.max(*height))
        }
        Shape::PartCylinder { y0, y1, radius, .. } => {
            ([0.0, 0.5 * (y0 + y1), 0.0], radius.max(y1 - y0))
        }
        Shape::Torus { swept_radius, tube_radius }
        | Shape::PartTorus { swept_radius, tube_radius, .. } => {
            ([0.0; 3], swept_radius + tube_radius)
        }
        Shape::CutFace { size, .. } => ([0.0; 3], 0.5 * size),
        Shape::Solid(solid) => solids::center_and_size(solid),
        Shape::Instance { matrix, of } => {
            let (center, size) = center_and_size(of);
            let stretch = columns(matrix).map(length).into_iter().fold(0.0, f64::max);
            (moved(matrix, center), stretch * size)
        }
    }
}

/// A point of the surface, not on its border.
pub(super) fn surface(shape: &Shape, rng: &mut SplitMix64) -> Feature {
    let (point, out) = match shape {
        Shape::Plane { point, normal } => {
            let n = unit(*normal);
            (add(*point, perpendicular(rng.point_in_cube(2.0), n)), n)
        }
        Shape::Sphere { center, radius } => {
            let n = rng.direction();
            (along(*center, *radius, n), n)
        }
        Shape::Cuboid { min, max } => {
            let n = rng.axis();
            let mut p = std::array::from_fn(|i| min[i] + (max[i] - min[i]) * rng.unit());
            let i = n.iter().position(|x| *x != 0.0).unwrap_or(0);
            p[i] = if n[i] > 0.0 { max[i] } else { min[i] };
            (p, n)
        }
        Shape::Triangle { vertices: [a, b, c] } => {
            let (mut u, mut v) = (rng.unit(), rng.unit());
            if u + v > 1.0 {
                (u, v) = (1.0 - u, 1.0 - v);
            }
            let (ab, ac) = (minus(*b, *a), minus(*c, *a));
            (along(along(*a, u, ab), v, ac), unit(cross(ab, ac)))
        }
        Shape::Rectangle { corner, a, b } => {
            (along(along(*corner, rng.unit(), *a), rng.unit(), *b), unit(cross(*a, *b)))
        }
        Shape::Disk { center, normal, radius } => {
            let n = unit(*normal);
            let u = unit(perpendicular(rng.direction(), n));
            (along(*center, radius * rng.unit(), u), n)
        }
        Shape::OpenCylinder { y0, y1, radius } => {
            let n = around_y(rng);
            (along([0.0, rng.between(*y0, *y1), 0.0], *radius, n), n)
        }
        Shape::Torus { swept_radius, tube_radius } => {
            let angles = [360.0 * rng.unit(), 360.0 * rng.unit()];
            on_tube([*swept_radius, *tube_radius], angles)
        }
        Shape::PartTorus { swept_radius, tube_radius, phi, theta } => {
            let angles = [phi, theta].map(|range| between(range, rng.unit()));
            on_tube([*swept_radius, *tube_radius], angles)
        }
        Shape::Algebraic { terms, min, max } => on_zero(terms, [*min, *max], rng),
        Shape::CutFace { size, radius } => solids::on_cut_face(*size, *radius, rng),
        Shape::Solid(solid) => return solids::surface(solid, rng),
        Shape::Instance { matrix, of } => return carried(matrix, surface(of, rng)),
        Shape::Annulus { center, normal, inner, outer } => {
            let n = unit(*normal);
            let u = unit(perpendicular(rng.direction(), n));
            (along(*center, rng.between(*inner, *outer), u), n)
        }
        _ => parts::surface(shape, rng),
    };
    Feature { point, out, silhouette: true }
}

/// A point of an edge, corner or rim; for shapes without any, a pole or an extreme line.
pub(super) fn border(shape: &Shape, rng: &mut SplitMix64) -> Feature {
    let quarter = |rng: &mut SplitMix64| 0.25 * rng.below(5) as f64;
    let (point, out, silhouette) = match shape {
        Shape::Plane { .. } | Shape::Algebraic { .. } => return surface(shape, rng),
        Shape::Sphere { center, radius } => {
            let n = rng.axis();
            (along(*center, *radius, n), n, true)
        }
        Shape::Cuboid { min, max } => {
            let free = rng.below(3);
            let mut out = [(); 3].map(|()| rng.sign() * rng.between(0.2, 1.0));
            out[free] = 0.0;
            let middle = quarter(rng);
            let p = std::array::from_fn(|i| match i {
                i if i == free => min[i] + middle * (max[i] - min[i]),
                i if out[i] > 0.0 => max[i],
                _ => min[i],
            });
            (p, unit(out), true)
        }
        Shape::Triangle { vertices } => {
            let k = rng.below(3);
            let [a, b, c] = [0, 1, 2].map(|i| vertices[(k + i) % 3]);
            let edge = minus(b, a);
            let inward = perpendicular(minus(c, a), unit(edge));
            (along(a, quarter(rng), edge), unit(scale(-1.0, inward)), false)
        }
        Shape::Rectangle { corner, a, b } => {
            let (side, other) = if rng.coin() { (a, b) } else { (b, a) };
            let start = along(*corner, quarter(rng), *side);
            if rng.coin() {
                (add(start, *other), unit(*other), false)
            } else {
                (start, unit(scale(-1.0, *other)), false)
            }
        }
        Shape::Disk { center, normal, radius } => {
            let u = unit(perpendicular(rng.direction(), unit(*normal)));
            (along(*center, *radius, u), u, false)
        }
        Shape::OpenCylinder { y0, y1, radius } => {
            let u = around_y(rng);
            let (y, up) = if rng.coin() { (*y1, 1.0) } else { (*y0, -1.0) };
            (along([0.0, y, 0.0], *radius, u), [0.0, up, 0.0], false)
        }
        Shape::Torus { swept_radius, tube_radius } => {
            // the highest, lowest, innermost and outermost lines
            let angles = [rng.below(8) as f64 * 45.0, rng.below(4) as f64 * 90.0];
            let (point, out) = on_tube([*swept_radius, *tube_radius], angles);
            (point, out, true)
        }
        Shape::PartTorus { swept_radius, tube_radius, phi, theta } => {
            border_of_part_torus([*swept_radius, *tube_radius], [phi, theta], rng)
        }
        Shape::CutFace { size, radius } => {
            let (point, out) = solids::border_of_cut_face(*size, *radius, rng);
            (point, out, false)
        }
        Shape::Solid(solid) => return solids::border(solid, rng),
        Shape::Instance { matrix, of } => return carried(matrix, border(of, rng)),
        Shape::Annulus { center, normal, inner, outer } => {
            let u = unit(perpendicular(rng.direction(), unit(*normal)));
            let (r, side) = if rng.coin() { (*outer, 1.0) } else { (*inner, -1.0) };
            (along(*center, r, u), scale(side, u), false)
        }
        _ => parts::border(shape, rng),
    };
    Feature { point, out, silhouette }
}

/// A point of an end of the part, and the way out of it.
fn border_of_part_torus(
    radii: [f64; 2],
    [phi, theta]: [&[f64; 2]; 2],
    rng: &mut SplitMix64,
) -> (V, V, bool) {
    let (last, inner) = (rng.coin(), 0.25 * rng.below(5) as f64);
    let (step, angles) = if rng.coin() {
        let end = phi[usize::from(last)];
        ([1.0, 0.0], [end, between(theta, inner)])
    } else {
        let end = theta[usize::from(last)];
        ([0.0, 1.0], [between(phi, inner), end])
    };
    let side = if last { 1.0 } else { -1.0 };
    let beyond = [angles[0] + side * step[0], angles[1] + side * step[1]];
    let (point, _) = on_tube(radii, angles);
    (point, unit(minus(on_tube(radii, beyond).0, point)), false)
}

/// A direction parallel to a plane, a generator or an axis of the shape.
pub(super) fn generator(shape: &Shape, rng: &mut SplitMix64) -> V {
    match shape {
        Shape::Plane { normal, .. }
        | Shape::Disk { normal, .. }
        | Shape::Annulus { normal, .. } => in_plane(*normal, rng),
        Shape::PartAnnulus { .. } | Shape::CutFace { .. } => in_plane([0.0, 1.0, 0.0], rng),
        Shape::Solid(_) => rng.axis(),
        Shape::Sphere { .. } | Shape::Cuboid { .. } | Shape::PartSphere { .. } => rng.axis(),
        Shape::Torus { .. } | Shape::PartTorus { .. } | Shape::Algebraic { .. } => rng.axis(),
        Shape::Cone { height, radius } => {
            along([0.0, rng.sign() * height, 0.0], *radius, around_y(rng))
        }
        Shape::Triangle { vertices: [a, b, c] } => minus(rng.pick(&[*b, *c]), *a),
        Shape::Rectangle { a, b, .. } => rng.pick(&[*a, *b]),
        Shape::OpenCylinder { .. } | Shape::PartCylinder { .. } | Shape::Paraboloid { .. } => {
            [0.0, rng.sign(), 0.0]
        }
        Shape::Instance { matrix, of } => {
            let inner = generator(of, rng);
            columns(matrix).into_iter().zip(inner).fold([0.0; 3], |sum, (c, x)| along(sum, x, c))
        }
    }
}

/// A vector exactly perpendicular to `n`: `(n_y, −n_x, 0)` with the axes cyclically permuted.
fn in_plane(n: V, rng: &mut SplitMix64) -> V {
    let i = rng.below(3);
    let (j, k) = ((i + 1) % 3, (i + 2) % 3);
    let mut v = [0.0; 3];
    (v[i], v[j]) = (n[j], -n[i]);
    if v == [0.0; 3] {
        v[i] = if n[i] == 0.0 { 1.0 } else { 0.0 };
        v[j] = if n[j] == 0.0 { 1.0 } else { 0.0 };
        v[k] = 0.0;
    }
    unit(v)
}

/// The point of a torus (its two radii) at these angles in degrees, and the normal there.
fn on_tube([a, b]: [f64; 2], [phi, theta]: [f64; 2]) -> (V, V) {
    let turn = |degrees: f64| {
        let (sin, cos) = real(degrees).sin_cos_unit(360);
        (nearest(&sin), nearest(&cos))
    };
    let ((sin_phi, cos_phi), (sin, cos)) = (turn(phi), turn(theta));
    let at = |rho: f64, y: f64| [rho * sin_phi, y, rho * cos_phi];
    (at(a + b * cos, b * sin), at(cos, sin))
}

/// A zero of the sum of terms on a segment between two points of the box, and the unit gradient there;
/// if no sign change is found, some point of the box.
fn on_zero(terms: &[(f64, [u32; 3])], [min, max]: [V; 2], rng: &mut SplitMix64) -> (V, V) {
    let value = |powers: &[u32; 3], p: V| {
        let factors = (0..3).flat_map(|i| vec![p[i]; powers[i] as usize]);
        factors.product::<f64>()
    };
    let sum = |p: V| terms.iter().map(|(c, powers)| c * value(powers, p)).sum::<f64>();
    let slope = |p: V, axis: usize| {
        let lower = |powers: &[u32; 3]| {
            let mut lower = *powers;
            lower[axis] = lower[axis].saturating_sub(1);
            lower
        };
        let slope =
            |(c, powers): &(f64, [u32; 3])| c * f64::from(powers[axis]) * value(&lower(powers), p);
        terms.iter().map(slope).sum::<f64>()
    };
    let mut random_point =
        || -> V { std::array::from_fn(|i| min[i] + (max[i] - min[i]) * rng.unit()) };
    let mut ends = [random_point(), random_point()];
    for _ in 0..50 {
        if (sum(ends[0]) < 0.0) != (sum(ends[1]) < 0.0) {
            break;
        }
        ends = [random_point(), random_point()];
    }
    for _ in 0..60 {
        let middle = scale(0.5, add(ends[0], ends[1]));
        let side = usize::from((sum(middle) < 0.0) != (sum(ends[0]) < 0.0));
        ends[side] = middle;
    }
    let gradient: V = std::array::from_fn(|axis| slope(ends[0], axis));
    (ends[0], if length(gradient) > 0.0 { unit(gradient) } else { [0.0, 1.0, 0.0] })
}

/// The angle at the fraction `part` of a range of degrees.
fn between([first, last]: &[f64; 2], part: f64) -> f64 {
    let turn = if last < first { last - first + 360.0 } else { last - first };
    first + part * turn
}

pub(super) fn around_y(rng: &mut SplitMix64) -> V {
    unit(perpendicular(rng.direction(), [0.0, 1.0, 0.0]))
}

fn columns(matrix: &[[f64; 4]; 3]) -> [V; 3] {
    std::array::from_fn(|j| std::array::from_fn(|i| matrix[i][j]))
}

fn moved(matrix: &[[f64; 4]; 3], p: V) -> V {
    std::array::from_fn(|i| dot([matrix[i][0], matrix[i][1], matrix[i][2]], p) + matrix[i][3])
}

/// `out` is transformed like a normal, by the cofactors, whose sign a mirror reverses.
fn carried(matrix: &[[f64; 4]; 3], feature: Feature) -> Feature {
    let [a, b, c] = columns(matrix);
    let cofactors = [cross(b, c), cross(c, a), cross(a, b)];
    let side = if dot(a, cofactors[0]) < 0.0 { -1.0 } else { 1.0 };
    let out = feature.out.iter().zip(cofactors).fold([0.0; 3], |sum, (x, c)| along(sum, *x, c));
    Feature { point: moved(matrix, feature.point), out: unit(scale(side, out)), ..feature }
}
