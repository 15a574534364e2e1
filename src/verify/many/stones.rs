//! Rosettes and archways as their stones: beveled wedges and boxes that touch.

use oracle::hard::{Family, Kind, cases, rays};
use oracle::{Shape, Solid};

use super::{Case, Of, Piece};
use crate::accel::Method;
use crate::math::{UNIT_ROUNDOFF, Vector, cos_degrees, sin_degrees};
use crate::shapes::{self, Archway, Materials, Rosette};
use crate::verify::Draw;

const WEDGES: [u32; 6] = [10, 12, 15, 18, 24, 36];

/// Sizes that are hard for a beveled wedge: heights, radii, bevel.
struct Sizes {
    y: [f64; 2],
    r: [f64; 2],
    bevel: f64,
}

impl Sizes {
    fn draw(family: Family, seed: u64, index: usize) -> Self {
        let case = cases(Kind::BeveledWedge, family, seed + index as u64, 1).remove(0);
        let Shape::Solid(Solid::BeveledWedge { y0, y1, inner, outer, bevel, .. }) = case.0 else {
            unreachable!("a wedge is a wedge")
        };
        Self { y: [y0, y1], r: [inner, outer], bevel }
    }
}

/// The largest bevel of a wedge: sin(width/2) = b/(inner + b).
fn widest(inner: f64, width: f64) -> f64 {
    let sine = sin_degrees(0.5 * width.min(180.0));
    if sine < 1.0 { inner * sine / (1.0 - sine) } else { f64::INFINITY }
}

/// A wedge about the y axis, at most 180° wide.
fn wedge(y: [f64; 2], [inner, outer]: [f64; 2], phi: [f64; 2], bevel: f64) -> Piece {
    let out = |phi: f64| Vector::new(sin_degrees(phi), 0.0, cos_degrees(phi));
    let middle = out(0.5 * (phi[0] + phi[1]));
    let within = vec![
        (-Vector::Y, -y[0]),
        (Vector::Y, y[1]),
        (out(phi[0] - 90.0), 0.0),
        (out(phi[1] + 90.0), 0.0),
        (middle, outer),
    ];
    let exact = Shape::Solid(Solid::BeveledWedge { y0: y[0], y1: y[1], inner, outer, phi, bevel });
    Piece { exact, within, reach: outer + y[0].abs().max(y[1].abs()) }
}

/// A solid of stones, and a ray that is hard for one of them.
fn case(
    (family, seed, index): (Family, u64, usize),
    mut draw: Draw,
    (ours, pieces, bevel): (shapes::Kind, Vec<Piece>, f64),
) -> Case {
    let aim = &pieces[draw.below(pieces.len())].exact;
    let ray = rays(aim, family, seed + index as u64, 1).remove(0);
    Case { ours, pieces, ray, condition: 1.0, bevel: Some(bevel) }
}

/// Of a hard wedge's sizes.
pub fn rosette(family: Family, seed: u64, index: usize, accel: Option<Method>) -> Case {
    let mut draw = Draw::case(seed + family as u64, index);
    let sizes = Sizes::draw(family, seed, index);
    let Sizes { y, r: [hole_radius, outer], bevel } = sizes;
    let (rings, ring_width) = (draw.pick(&[1, 1, 2, 3, 6]), outer - hole_radius);
    let radius = |ring: u32| hole_radius + f64::from(ring) * ring_width;
    let width = |ring: u32| 360.0 / f64::from(WEDGES[ring as usize]);
    let fits = (0..rings).map(|ring| widest(radius(ring), width(ring))).fold(bevel, f64::min);
    let bevel = if fits < bevel { draw.between(0.1, 0.99) * fits } else { bevel };
    let ring = |ring: u32| {
        let azimuth = move |i: u32| f64::from(i) * width(ring);
        let stone = move |i| {
            wedge(y, [radius(ring), radius(ring + 1)], [azimuth(i), azimuth(i + 1)], bevel)
        };
        (0..WEDGES[ring as usize]).map(stone)
    };
    let (y0, y1, materials) = (y[0], y[1], Materials::new());
    let ours = Rosette { rings, hole_radius, ring_width, bevel, y0, y1, accel, materials };
    let pieces = (0..rings).flat_map(ring).collect();
    case((family, seed, index), draw, (ours.into(), pieces, bevel))
}

/// Of a hard wedge's sizes.
pub fn archway(family: Family, seed: u64, index: usize, accel: Option<Method>) -> Case {
    let mut draw = Draw::case(seed + family as u64, index);
    let sizes = Sizes::draw(family, seed, index);
    let Sizes { y: [y0, y1], r: [_, outer], .. } = sizes;
    let (depth, width) = (y1 - y0, 2.0 * outer);
    let column_width = outer - sizes.r[0];
    let (blocks, wedges) = (1 + draw.below(5) as u32, 1 + draw.below(12) as u32);
    let height = outer + draw.between(0.2, 3.0) * outer;
    // as the library rounds them
    let (spring, inner) = (height - 0.5 * width, 0.5 * width - column_width);
    let step = 180.0 / f64::from(wedges);
    let most = 0.5 * depth.min(column_width).min(spring / f64::from(blocks));
    let fits = most.min(0.99 * widest(inner, step));
    let bevel = if fits < sizes.bevel { draw.between(0.1, 1.0) * fits } else { sizes.bevel };
    let z = [-0.5 * depth, 0.5 * depth];

    let mut pieces = Vec::new();
    for i in 0..wedges {
        let phi = [90.0 + step * f64::from(i), 90.0 + step * f64::from(i + 1)];
        let Piece { exact, within, reach } = wedge(z, [inner, outer], phi, bevel);
        // y → z, z → −y, and up
        let matrix = [[1.0, 0.0, 0.0, 0.0], [0.0, 0.0, -1.0, spring], [0.0, 1.0, 0.0, 0.0]];
        let moved = |(n, d): (Vector, f64)| {
            let n = Vector::new(n.x(), -n.z(), n.y());
            (n, d + spring * n.y())
        };
        pieces.push(Piece {
            exact: Shape::Instance { matrix, of: Box::new(exact) },
            within: within.into_iter().map(moved).collect(),
            reach: reach + spring,
        });
    }
    for x in [[-outer, -inner], [inner, outer]] {
        for block in 0..blocks {
            let y = |block: u32| spring * (f64::from(block) / f64::from(blocks));
            let (min, max) = ([x[0], y(block), z[0]], [x[1], y(block + 1), z[1]]);
            pieces.push(Piece::boxed(
                Shape::Solid(Solid::BeveledBox { min, max, bevel }),
                [min, max],
            ));
        }
    }
    let materials = Materials::new();
    let ours =
        Archway { width, height, depth, column_width, blocks, wedges, bevel, accel, materials };
    case((family, seed, index), draw, (ours.into(), pieces, bevel))
}

/// What is left of the roots where faces of two stones that touch are none of the solid: two roots
/// in one place, of opposite normals. (Edges of two stones touch like that, too, but only in lines;
/// they are as round as the bevel.) Distances and normals are right to the last bit here; faces that
/// do not touch have other normals by far more than 1e-9.
pub fn without_touching(roots: Vec<Of>, bevel: f64) -> Vec<Of> {
    let mut left: Vec<Of> = Vec::new();
    for (stone, root) in roots {
        let touches = |(other, before): &Of| {
            let opposite = Vector::from(before.normal) + Vector::from(root.normal);
            *other != stone
                && root.t - before.t <= 4.0 * UNIT_ROUNDOFF * root.t
                && opposite.length() < 1e-9
                && before.size.min(root.size) > 1.5 * bevel
        };
        match left.iter().rposition(touches) {
            Some(partner) => {
                left.remove(partner);
            }
            None => left.push((stone, root)),
        }
    }
    left
}
