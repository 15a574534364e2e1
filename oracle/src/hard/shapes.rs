//! The shapes of the hard cases.

use super::{
    Family, Kind,
    rng::SplitMix64,
    solids,
    vector::{V, add, along, cross, perpendicular, scale, unit},
};
use crate::Shape;

/// What a family requires of a shape.
pub(super) struct Want {
    /// The overall size.
    pub(super) size: f64,
    /// The short extent over the long one.
    pub(super) aspect: f64,
    pub(super) center: V,
    pub(super) family: Family,
}

impl Want {
    /// Whether coordinates need to have few bits, so that points of edges are exact.
    pub(super) fn exact(&self) -> bool {
        matches!(self.family, Family::EdgesAndCorners | Family::Degenerate)
    }
}

pub(super) fn shape(kind: Kind, family: Family, rng: &mut SplitMix64) -> Shape {
    let size = match family {
        Family::TinyShape => rng.decades(-6, -3),
        Family::HugeShape => rng.decades(3, 6),
        Family::Scaled => rng.decades(-6, 6),
        _ => rng.between(0.5, 2.0),
    };
    let aspect = if family == Family::Thin { rng.decades(-6, -3) } else { rng.between(0.3, 1.0) };
    let spread = if family == Family::TinyShape { 1.0 } else { size };
    let center = if rng.below(4) == 0 { [0.0; 3] } else { rng.point_in_cube(3.0 * spread) };
    let mut want = Want { size, aspect, center, family };
    if want.exact() {
        (want.size, want.center) = (snapped(want.size), want.center.map(snapped));
    }
    match kind {
        Kind::Plane => Shape::Plane { point: want.center, normal: normal(&want, rng) },
        Kind::Sphere => sphere(&want),
        Kind::Cuboid => cuboid(&want, rng),
        Kind::Triangle => triangle(&want, rng),
        Kind::Rectangle => rectangle(&want, rng),
        Kind::Disk => {
            Shape::Disk { center: want.center, normal: normal(&want, rng), radius: want.size }
        }
        Kind::OpenCylinder => cylinder(&want, rng),
        Kind::Torus => torus(&want, rng),
        Kind::PartTorus => part_torus(&want, rng),
        Kind::Algebraic => algebraic(&want, rng),
        Kind::Instance => instance(&want, rng),
        Kind::Annulus => {
            let [inner, outer] = radii(&want, rng);
            Shape::Annulus { center: want.center, normal: normal(&want, rng), inner, outer }
        }
        Kind::PartAnnulus => {
            let [inner, outer] = radii(&want, rng);
            Shape::PartAnnulus { center: want.center, inner, outer, phi: azimuths(&want, rng) }
        }
        Kind::Cone => {
            let [height, radius] = tall_or_flat(&want, rng);
            Shape::Cone { height, radius }
        }
        Kind::Paraboloid => {
            let [height, radius] = tall_or_flat(&want, rng);
            Shape::Paraboloid { height, radius }
        }
        Kind::PartSphere => Shape::PartSphere {
            center: want.center,
            radius: want.size,
            phi: azimuths(&want, rng),
            theta: polar_angles(&want, rng),
        },
        Kind::PartCylinder => {
            let Shape::OpenCylinder { y0, y1, radius } = cylinder(&want, rng) else {
                unreachable!("a cylinder is a cylinder")
            };
            Shape::PartCylinder { y0, y1, radius, phi: azimuths(&want, rng) }
        }
        Kind::CutFace => solids::cut_face(&want, rng),
        solid => Shape::Solid(solids::solid(solid, &want, rng)),
    }
}

/// Rounded to the nearest multiple of 1/64, but not to 0.
pub(super) fn snapped(x: f64) -> f64 {
    let whole = (x * 64.0).round();
    if whole == 0.0 { 1.0 / 64.0 } else { whole / 64.0 }
}

/// Unit, or of a length from 10⁻³ to 10³; for [`Family::Degenerate`] along an axis half the time.
fn normal(want: &Want, rng: &mut SplitMix64) -> V {
    if want.family == Family::Degenerate && rng.coin() {
        return rng.axis();
    }
    let length = if rng.coin() { 1.0 } else { rng.decades(-3, 3) };
    scale(length, rng.direction())
}

/// A sphere cannot be thin; the thin case is a small sphere at a distance.
fn sphere(want: &Want) -> Shape {
    let thin = want.family == Family::Thin;
    Shape::Sphere {
        center: want.center,
        radius: if thin { want.size * want.aspect } else { want.size },
    }
}

pub(super) fn cuboid(want: &Want, rng: &mut SplitMix64) -> Shape {
    let mut half = [(); 3].map(|()| want.size * rng.between(0.3, 1.0));
    if want.family == Family::Thin {
        half[rng.below(3)] *= want.aspect; // a plate; with two short axes, a rod
        half[rng.below(3)] *= want.aspect;
    }
    if want.exact() {
        half = half.map(snapped);
    }
    Shape::Cuboid {
        min: std::array::from_fn(|i| want.center[i] - half[i]),
        max: std::array::from_fn(|i| want.center[i] + half[i]),
    }
}

/// When thin, half are needles (one short side), half are caps (a corner near the opposite side).
fn triangle(want: &Want, rng: &mut SplitMix64) -> Shape {
    let u = rng.direction();
    let v = unit(perpendicular(rng.direction(), u));
    let (long, short) = (scale(want.size, u), scale(want.size * want.aspect, v));
    let at = if want.family == Family::Thin && rng.coin() { 0.0 } else { rng.between(0.2, 0.8) };
    let mut vertices =
        [want.center, add(want.center, long), add(along(want.center, at, long), short)];
    if want.exact() {
        let flat = want.family == Family::Degenerate && rng.coin();
        let axis = rng.below(3);
        vertices = vertices.map(|vertex| vertex.map(snapped));
        for vertex in &mut vertices {
            if flat {
                vertex[axis] = want.center[axis];
            }
        }
    }
    vertices.rotate_left(rng.below(3));
    Shape::Triangle { vertices }
}

/// Sides by Gram–Schmidt, or exactly perpendicular: `(p, q, 0)` and `(−q, p, 0)` with axes permuted.
fn rectangle(want: &Want, rng: &mut SplitMix64) -> Shape {
    let (mut a, mut b);
    if want.exact() || rng.below(3) == 0 {
        let (p, q) = (snapped(rng.between(-1.0, 1.0)), snapped(rng.between(-1.0, 1.0)));
        let power = if want.exact() { 1.0 } else { want.size };
        (a, b) = (scale(power, [p, q, 0.0]), scale(power, [-q, p, 0.0]));
        let turn = rng.below(3);
        a.rotate_left(turn);
        b.rotate_left(turn);
    } else {
        let u = rng.direction();
        a = scale(want.size, u);
        b = scale(want.size * rng.between(0.3, 1.0), unit(perpendicular(rng.direction(), u)));
    }
    if want.family == Family::Thin {
        b = scale(want.aspect, b);
    }
    if rng.coin() {
        (a, b) = (b, a);
    }
    Shape::Rectangle { corner: want.center, a, b }
}

/// When thin, a ring or a rod.
pub(super) fn cylinder(want: &Want, rng: &mut SplitMix64) -> Shape {
    let (mut height, mut radius) = (want.size * rng.between(0.5, 2.0), want.size);
    if want.family == Family::Thin {
        let short = if rng.coin() { &mut height } else { &mut radius };
        *short *= want.aspect;
    }
    if want.exact() {
        (height, radius) = (snapped(height), snapped(radius));
    }
    let y0 = want.center[1] - 0.5 * height;
    Shape::OpenCylinder { y0, y1: y0 + height, radius }
}

/// When thin, a narrow ring; one in eight has no hole.
fn radii(want: &Want, rng: &mut SplitMix64) -> [f64; 2] {
    let width = if want.family == Family::Thin { want.aspect } else { rng.between(0.2, 0.9) };
    let inner = if rng.below(8) == 0 { 0.0 } else { want.size * (1.0 - width) };
    [if want.exact() { (inner * 64.0).floor() / 64.0 } else { inner }, want.size]
}

/// Height and radius; when thin, a needle or almost a disk.
pub(super) fn tall_or_flat(want: &Want, rng: &mut SplitMix64) -> [f64; 2] {
    let mut sizes = [want.size * rng.between(0.5, 2.0), want.size];
    if want.family == Family::Thin {
        sizes[rng.below(2)] *= want.aspect;
    }
    if want.exact() { sizes.map(snapped) } else { sizes }
}

/// From 20 to 340 degrees wide, also through 0; whole quarters where numbers are exact; when thin, half
/// are slivers.
fn azimuths(want: &Want, rng: &mut SplitMix64) -> [f64; 2] {
    let (start, width) = if want.exact() {
        (90.0 * rng.below(4) as f64, 90.0 * (1 + rng.below(4)) as f64)
    } else if want.family == Family::Thin && rng.coin() {
        (rng.between(0.0, 359.0), 100.0 * want.aspect)
    } else {
        (rng.between(0.0, 360.0), rng.between(20.0, 340.0))
    };
    let end = start + width;
    match end {
        _ if width == 360.0 => [0.0, 360.0],
        end if end > 360.0 => [start, end - 360.0],
        end => [start, end],
    }
}

/// From 20 to 180 degrees wide, one in four from or to a pole; when thin, half are slivers.
fn polar_angles(want: &Want, rng: &mut SplitMix64) -> [f64; 2] {
    if want.exact() {
        return rng.pick(&[[0.0, 90.0], [90.0, 180.0], [0.0, 180.0], [45.0, 135.0], [60.0, 90.0]]);
    }
    let width = if want.family == Family::Thin && rng.coin() {
        100.0 * want.aspect
    } else {
        rng.between(20.0, 170.0)
    };
    match rng.below(8) {
        0 => [0.0, width],
        1 => [180.0 - width, 180.0],
        2 => [rng.decades(-4, 0), 170.0], // all but small caps
        _ => {
            let start = rng.between(0.0, 180.0 - width);
            [start, start + width]
        }
    }
}

/// When thin, a thread or a ring with a tiny hole.
fn torus(want: &Want, rng: &mut SplitMix64) -> Shape {
    let ratio = match want.family {
        Family::Thin if rng.coin() => want.aspect,
        Family::Thin => 1.0 - want.aspect,
        _ => rng.between(0.1, 0.9),
    };
    let (swept_radius, tube_radius) = (want.size, ratio * want.size);
    if want.exact() {
        return Shape::Torus {
            swept_radius: 4.0 * swept_radius,
            tube_radius: snapped(tube_radius),
        };
    }
    Shape::Torus { swept_radius, tube_radius }
}

/// Ends at whole multiples of 15° or anywhere; some thin ones are slivers of a hundredth of a degree.
fn part_torus(want: &Want, rng: &mut SplitMix64) -> Shape {
    let Shape::Torus { swept_radius, tube_radius } = torus(want, rng) else {
        unreachable!("it has just been made")
    };
    let thin = want.family == Family::Thin;
    let mut range = || {
        let first = if rng.coin() { 15.0 * rng.below(24) as f64 } else { rng.between(0.0, 360.0) };
        let turn = match rng.below(8) {
            0 if thin => rng.decades(-2, 0),
            1 => 180.0,
            2 => return [0.0, 360.0],
            _ => rng.between(60.0, 350.0),
        };
        let last = first + turn;
        [first, if last > 360.0 { last - 360.0 } else { last }]
    };
    Shape::PartTorus { swept_radius, tube_radius, phi: range(), theta: range() }
}

/// A known surface, or one with random coefficients; when thin, compressed along an axis.
fn algebraic(want: &Want, rng: &mut SplitMix64) -> Shape {
    let mut terms: Vec<(f64, [u32; 3])> = Vec::new();
    let axis = |i: usize, power: u32| {
        let mut powers = [0; 3];
        powers[i] += power;
        powers
    };
    let every = |power: u32| (0..3).map(move |i| axis(i, power));
    let mut half = 1.25;
    match rng.below(5) {
        0 => {
            half = 2.75; // Goursat's tangle
            terms.extend(every(4).map(|powers| (1.0, powers)));
            terms.extend(every(2).map(|powers| (-5.0, powers)));
            terms.push((rng.between(11.0, 12.0), [0; 3]));
        }
        1 => {
            let power = rng.pick(&[6, 8]);
            terms.extend(every(power).map(|powers| (1.0, powers)));
            terms.push((-1.0, [0; 3]));
        }
        2 => {
            // a torus: (p·p + k)² − 4 a² (x² + z²)
            let (a, b) = (rng.between(0.6, 0.9), rng.between(0.1, 0.5));
            let k = a * a - b * b;
            terms.extend(every(4).map(|powers| (1.0, powers)));
            terms.extend([(2.0, [2, 2, 0]), (2.0, [0, 2, 2]), (2.0, [2, 0, 2])]);
            let flat = 2.0 * k - 4.0 * a * a;
            terms.extend([(flat, [2, 0, 0]), (2.0 * k, [0, 2, 0]), (flat, [0, 0, 2])]);
            terms.push((k * k, [0; 3]));
        }
        degree => {
            let all = (0..=degree as u32).flat_map(|i| {
                let rest = degree as u32 - i;
                (0..=rest).flat_map(move |j| (0..=rest - j).map(move |k| [i, j, k]))
            });
            terms.extend(all.map(|powers| (rng.between(-1.0, 1.0), powers)));
        }
    }
    let mut sizes = [want.size; 3];
    if want.family == Family::Thin {
        sizes[rng.below(3)] *= want.aspect;
    }
    let power = |x: f64, n: u32| (0..n).fold(1.0, |product, _| product * x);
    for (c, powers) in &mut terms {
        *c = (0..3).fold(*c, |c, i| c / power(sizes[i], powers[i]));
    }
    let corner = |side: f64, rng: &mut SplitMix64| {
        sizes.map(|size| side * size * if rng.coin() { half } else { rng.between(0.4, 1.0) * half })
    };
    Shape::Algebraic { terms, min: corner(-1.0, rng), max: corner(1.0, rng) }
}

fn instance(want: &Want, rng: &mut SplitMix64) -> Shape {
    let kind = rng.pick(&[Kind::Sphere, Kind::Cuboid, Kind::Disk]);
    let family = if want.family == Family::Thin { Family::Thin } else { Family::Ordinary };
    let inner = shape(kind, family, rng);
    let wild = match want.family {
        Family::Ordinary => false,
        Family::Thin | Family::Scaled | Family::Grazing => true,
        _ => rng.below(4) == 0,
    };
    let outer = affine(want, wild, rng);
    let inner = if rng.below(3) == 0 {
        let plain = Want { size: 1.0, aspect: 1.0, center: rng.point_in_cube(1.0), family };
        Shape::Instance { matrix: affine(&plain, false, rng), of: Box::new(inner) }
    } else {
        inner
    };
    Shape::Instance { matrix: outer, of: Box::new(inner) }
}

/// A rotation, shear (half the time), scales (10⁻⁴ to 10⁴ each when wild) and mirror, then a shift.
fn affine(want: &Want, wild: bool, rng: &mut SplitMix64) -> [[f64; 4]; 3] {
    let x = rng.direction();
    let y = unit(perpendicular(rng.direction(), x));
    let frame = [x, y, cross(x, y)];
    let mut columns = frame.map(|axis| {
        let stretch = if wild { rng.decades(-4, 4) } else { rng.between(0.5, 2.0) };
        scale(want.size * stretch * rng.sign(), axis)
    });
    if rng.coin() {
        columns[1] = along(columns[1], rng.between(-1.0, 1.0), columns[0]);
        columns[2] = along(columns[2], rng.between(-1.0, 1.0), columns[1]);
    }
    std::array::from_fn(|i| [columns[0][i], columns[1][i], columns[2][i], want.center[i]])
}
