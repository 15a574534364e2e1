//! Random beveled solids, each with the distance of a point from its inset: the smaller solid that is
//! left if all that is within the bevel of the surface is removed. The distance is in closed form and
//! does not use the code under test.

use groundtruth::shapes::{BeveledBox, BeveledCylinder, BeveledRing, BeveledWedge, Materials};

use crate::prelude::*;
use crate::support::solids::from_axis;

/// A solid, and the distance of a point from its inset (0 inside the inset).
pub struct Case {
    pub kind: Kind,
    pub bevel: f64,
    pub from_inset: Box<dyn Fn(Point) -> f64>,
}

/// How far `x` is outside of the interval after `bevel` is taken off both ends.
fn beside([low, high]: [f64; 2], bevel: f64, x: f64) -> f64 {
    let (low, high) = (low + bevel, high - bevel);
    (low - x).max(x - high).max(0.0)
}

fn length(x: f64, y: f64) -> f64 {
    (x * x + y * y).sqrt()
}

/// The bevel as a share of the smallest size: exactly the half that fits, very small, or between.
fn share(draw: &mut Draw) -> f64 {
    match draw.below(4) {
        0 => 0.5,
        1 => draw.decades(-3.0, -1.0),
        _ => draw.between(0.05, 0.49),
    }
}

fn beveled_box(draw: &mut Draw) -> Case {
    let min = draw.point(1.0);
    let sides = [0; 3].map(|_| draw.between(0.2, 2.0));
    let max = min + Vector::from(sides);
    let bevel = share(draw) * sides.into_iter().fold(f64::INFINITY, f64::min);
    let from_inset = move |p: Point| {
        let off = [0, 1, 2].map(|i| beside([min.along(i), max.along(i)], bevel, p.along(i)));
        Vector::from(off).length()
    };
    let kind = BeveledBox { min, max, bevel, materials: Materials::new() }.into();
    Case { kind, bevel, from_inset: Box::new(from_inset) }
}

fn beveled_cylinder(draw: &mut Draw) -> Case {
    let (y0, radius) = (draw.between(-1.0, 1.0), draw.between(0.2, 2.0));
    let y1 = y0 + draw.between(0.2, 4.0);
    let bevel = if draw.coin() { share(draw) } else { draw.between(0.5, 1.0) };
    let bevel = (bevel * radius).min(0.5 * (y1 - y0));
    let from_inset = move |p: Point| {
        length((from_axis(p) - (radius - bevel)).max(0.0), beside([y0, y1], bevel, p.y()))
    };
    let kind = BeveledCylinder { y0, y1, radius, bevel, materials: Materials::new() }.into();
    Case { kind, bevel, from_inset: Box::new(from_inset) }
}

fn beveled_ring(draw: &mut Draw) -> Case {
    let (y0, inner_radius) = (draw.between(-1.0, 1.0), draw.between(0.1, 2.0));
    let y1 = y0 + draw.between(0.2, 2.0);
    let outer_radius = inner_radius + draw.between(0.2, 1.0);
    let bevel = share(draw) * (y1 - y0).min(outer_radius - inner_radius);
    let from_inset = move |p: Point| {
        let radii = [inner_radius, outer_radius];
        length(beside(radii, bevel, from_axis(p)), beside([y0, y1], bevel, p.y()))
    };
    let materials = Materials::new();
    let kind = BeveledRing { y0, y1, inner_radius, outer_radius, bevel, materials }.into();
    Case { kind, bevel, from_inset: Box::new(from_inset) }
}

/// A point of the plane y = 0 as the complex number `z + i x`, whose argument is the azimuth.
type Flat = [f64; 2];

fn turned([a, b]: Flat, degrees: f64) -> Flat {
    let (s, c) = (sin_degrees(degrees), cos_degrees(degrees));
    [a * c - b * s, a * s + b * c]
}

fn apart(p: Flat, q: Flat) -> f64 {
    length(p[0] - q[0], p[1] - q[1])
}

fn degrees(p: Flat) -> f64 {
    (180.0 / PI) * atan2(p[1], p[0])
}

fn to_segment(p: Flat, [a, b]: [Flat; 2]) -> f64 {
    let (u, v) = ([b[0] - a[0], b[1] - a[1]], [p[0] - a[0], p[1] - a[1]]);
    let square = u[0] * u[0] + u[1] * u[1];
    let share = if square > 0.0 { (u[0] * v[0] + u[1] * v[1]) / square } else { 0.0 };
    let share = share.clamp(0.0, 1.0);
    apart(v, [share * u[0], share * u[1]])
}

/// The distance of a point of the plane from the inset of a sector between two radii: what is left of it
/// if all that is within `bevel` of its border is removed. The border of the inset consists of two arcs
/// and the two segments between them.
fn from_sector(p: Flat, [r0, r1]: [f64; 2], [from, to]: [f64; 2], bevel: f64) -> f64 {
    let width = to - from;
    // in coordinates of the first side; `mirrored` converts between these and those of the second side
    let [x, y] = turned(p, -from);
    let mirrored = |q: Flat| turned([q[0], -q[1]], width);
    let (near, far) = (r0 + bevel, r1 - bevel);
    let on_arc = |r: f64| [((r - bevel) * (r + bevel)).sqrt(), bevel];
    let start = [on_arc(near), on_arc(far)];
    let end = start.map(mirrored);
    let rho = length(x, y);
    let azimuth = degrees([x, y]).rem_euclid(360.0);
    let off_ray = |q: Flat| if q[0] > 0.0 { q[1].abs() } else { rho };
    let clear = off_ray([x, y]) >= bevel && off_ray(mirrored([x, y])) >= bevel;
    if (near..=far).contains(&rho) && azimuth <= width && clear {
        return 0.0;
    }
    let arc = |r: f64, ends: [Flat; 2]| {
        let within = (degrees(ends[0])..=width - degrees(ends[0])).contains(&azimuth);
        if within { (rho - r).abs() } else { apart([x, y], ends[0]).min(apart([x, y], ends[1])) }
    };
    arc(near, [start[0], end[0]])
        .min(arc(far, [start[1], end[1]]))
        .min(to_segment([x, y], start))
        .min(to_segment([x, y], end))
}

fn beveled_wedge(draw: &mut Draw) -> Case {
    let (y0, inner_radius) = (draw.between(-1.0, 1.0), draw.between(0.5, 2.0));
    let y1 = y0 + draw.between(0.2, 2.0);
    let outer_radius = inner_radius + draw.between(0.2, 1.0);
    let from = draw.between(-180.0, 90.0);
    let width = draw.between(30.0, 345.0);
    let phi = match draw.below(3) {
        0 => [0.0, 90.0],
        _ if from + width > 360.0 => [from, from + width - 360.0],
        _ => [from, from + width],
    };
    let full = if phi[1] < phi[0] { [phi[0], phi[1] + 360.0] } else { phi };
    let half = sin_degrees((0.5 * (full[1] - full[0])).min(89.0));
    let fits = (inner_radius * half / (1.0 - half)).min(0.5 * (y1 - y0));
    let bevel = 2.0 * share(draw) * fits.min(0.5 * (outer_radius - inner_radius));
    let from_inset = move |p: Point| {
        let level = from_sector([p.z(), p.x()], [inner_radius, outer_radius], full, bevel);
        length(level, beside([y0, y1], bevel, p.y()))
    };
    let materials = Materials::new();
    let kind = BeveledWedge { y0, y1, inner_radius, outer_radius, phi, bevel, materials }.into();
    Case { kind, bevel, from_inset: Box::new(from_inset) }
}

/// A box, a cylinder, a ring and a wedge.
pub const KINDS: [fn(&mut Draw) -> Case; 4] =
    [beveled_box, beveled_cylinder, beveled_ring, beveled_wedge];
