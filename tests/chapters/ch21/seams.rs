//! Where the parts of a beveled solid or a bowl join without an angle: no ray slips through, and
//! none that starts there is lost.

use groundtruth::math::{Point, Ray, Span, Vector, cos_degrees, sin_degrees};
use groundtruth::shapes::{
    BeveledBox, BeveledCylinder, BeveledRing, BeveledWedge, Candidate, Kind, Materials,
    RoundRimmedBowl,
};
use groundtruth::verify::Draw;

use crate::ch19::compounds::built;

/// A solid, a point inside it, and points on its seams that are seen from there.
struct Case {
    kind: Kind,
    middle: Point,
    seams: Vec<Point>,
}

/// Half-way up the radius ρ at this azimuth, in degrees.
fn around(rho: f64, y: f64, phi: f64) -> Point {
    Point::new(rho * sin_degrees(phi), y, rho * cos_degrees(phi))
}

/// Seams between faces and edges, and between edges and corners.
fn beveled_box(draw: &mut Draw) -> Case {
    let min = draw.point(1.0);
    let sides = [0; 3].map(|_| draw.between(0.2, 2.0));
    let max = min + Vector::from(sides);
    let bevel = draw.between(0.05, 0.45) * sides.into_iter().fold(f64::INFINITY, f64::min);
    let mut point = || {
        let axis = draw.below(3);
        let (second, third) = ((axis + 1) % 3, (axis + 2) % 3);
        let within = |i: usize, share: f64| {
            let (low, high) = (min.along(i) + bevel, max.along(i) - bevel);
            low + share * (high - low)
        };
        let mut p = [0.0; 3];
        if draw.coin() {
            p[axis] = if draw.coin() { min.along(axis) } else { max.along(axis) };
            p[second] = within(second, draw.pick(&[0.0, 1.0]));
            p[third] = within(third, draw.between(0.0, 1.0));
        } else {
            // the quarter circle at the end of an edge along the axis
            p[axis] = within(axis, draw.pick(&[0.0, 1.0]));
            let angle = draw.between(0.0, 90.0);
            let turned = [(second, cos_degrees(angle)), (third, sin_degrees(angle))];
            for (i, part) in turned {
                let share = draw.pick(&[0.0, 1.0]);
                p[i] = within(i, share) + (2.0 * share - 1.0) * bevel * part;
            }
        }
        Point::from(p)
    };
    let seams = (0..100).map(|_| point()).collect();
    let kind = BeveledBox { min, max, bevel, materials: Materials::new() }.into();
    Case { kind, middle: min + 0.5 * (max - min), seams }
}

/// Seams between the flat ends, the edges and the wall.
fn beveled_cylinder(draw: &mut Draw) -> Case {
    let (y0, radius) = (draw.between(-1.0, 1.0), draw.between(0.2, 2.0));
    let y1 = y0 + draw.between(0.2, 2.0);
    let bevel = draw.between(0.05, 0.95) * radius.min(0.5 * (y1 - y0));
    let ends =
        [(radius, y1 - bevel), (radius - bevel, y1), (radius, y0 + bevel), (radius - bevel, y0)];
    let mut point = || {
        let (rho, y) = draw.pick(&ends);
        around(rho, y, draw.between(0.0, 360.0))
    };
    let seams = (0..100).map(|_| point()).collect();
    let kind = BeveledCylinder { y0, y1, radius, bevel, materials: Materials::new() }.into();
    Case { kind, middle: Point::new(0.0, 0.5 * (y0 + y1), 0.0), seams }
}

/// Seams in the half-plane of a point in the middle of the ring.
fn beveled_ring(draw: &mut Draw) -> Case {
    let (y0, inner_radius) = (draw.between(-1.0, 1.0), draw.between(0.2, 2.0));
    let y1 = y0 + draw.between(0.2, 2.0);
    let outer_radius = inner_radius + draw.between(0.2, 1.0);
    let bevel = draw.between(0.05, 0.45) * (y1 - y0).min(outer_radius - inner_radius);
    let phi = draw.between(0.0, 360.0);
    let mut seams = Vec::new();
    for y in [y0, y1] {
        seams.extend([inner_radius + bevel, outer_radius - bevel].map(|rho| around(rho, y, phi)));
    }
    for y in [y0 + bevel, y1 - bevel] {
        seams.extend([inner_radius, outer_radius].map(|rho| around(rho, y, phi)));
    }
    let middle = around(0.5 * (inner_radius + outer_radius), 0.5 * (y0 + y1), phi);
    let materials = Materials::new();
    let kind = BeveledRing { y0, y1, inner_radius, outer_radius, bevel, materials }.into();
    Case { kind, middle, seams }
}

/// Seams around the start of a wedge, seen from its middle: of its side, its cap, its outer wall.
fn beveled_wedge(draw: &mut Draw) -> Case {
    let (y0, inner_radius) = (draw.between(-1.0, 1.0), draw.between(0.5, 2.0));
    let y1 = y0 + draw.between(0.2, 2.0);
    let outer_radius = inner_radius + draw.between(0.4, 1.0);
    let bevel = draw.between(0.05, 0.15) * (y1 - y0).min(0.4);
    let (from, width) = (draw.between(-180.0, 180.0), 40.0);
    let far = outer_radius - bevel;
    // along the side and off it; β is the angle of the outer corner's middle
    let ends = [inner_radius + bevel, far].map(|r| ((r - bevel) * (r + bevel)).sqrt());
    let beta = groundtruth::math::to_degrees(groundtruth::math::atan2(bevel, ends[1]));
    let beside = |along: f64, off: f64, y: f64| {
        let side = around(along, y, from);
        side + (around(off, 0.0, from + 90.0) - Point::ORIGIN)
    };
    let mut point = || {
        let along = ends[0] + draw.between(0.3, 1.0) * (ends[1] - ends[0]);
        let height = y0 + bevel + draw.between(0.0, 1.0) * (y1 - y0 - 2.0 * bevel);
        let phi = from + draw.between(beta, 0.5 * width);
        match draw.below(5) {
            0 => beside(along, 0.0, draw.pick(&[y0 + bevel, y1 - bevel])),
            1 => beside(along, bevel, draw.pick(&[y0, y1])),
            2 => beside(ends[1], 0.0, height),
            3 => around(outer_radius, draw.pick(&[y0 + bevel, y1 - bevel]), phi),
            _ => around(far, draw.pick(&[y0, y1]), phi),
        }
    };
    let seams = (0..100).map(|_| point()).collect();
    let middle = around(0.5 * (ends[0] + ends[1]), 0.5 * (y0 + y1), from + 0.5 * width);
    let phi = [from, if from + width > 360.0 { from + width - 360.0 } else { from + width }];
    let materials = Materials::new();
    let kind = BeveledWedge { y0, y1, inner_radius, outer_radius, phi, bevel, materials }.into();
    Case { kind, middle, seams }
}

/// Seams between the spheres and the rim, from a point of the middle of the rim.
fn round_rimmed_bowl(draw: &mut Draw) -> Case {
    let outer_radius = draw.between(0.5, 2.0);
    let inner_radius = draw.between(0.7, 0.95) * outer_radius;
    let opening = draw.between(90.0, 270.0);
    let phi = draw.between(0.0, 360.0);
    let (s, c) = (sin_degrees(0.5 * opening), cos_degrees(0.5 * opening));
    let at = |r: f64| around(r * s, r * c, phi);
    let lower = at(0.5 * (inner_radius + outer_radius));
    let middle = lower + 0.1 * (inner_radius - outer_radius) * Vector::Y;
    let materials = Materials::new();
    let kind = RoundRimmedBowl { inner_radius, outer_radius, opening, materials }.into();
    Case { kind, middle, seams: vec![at(inner_radius), at(outer_radius)] }
}

const KINDS: [fn(&mut Draw) -> Case; 5] =
    [beveled_box, beveled_cylinder, beveled_ring, beveled_wedge, round_rimmed_bowl];

/// Law: a ray from inside at a point of a seam hits the solid there, and one that starts at the hit
/// and goes on inward hits again: none slips through between the parts. Oracle: the seams' points,
/// from the solids' definitions.
#[test]
fn no_ray_slips_through_a_seam() {
    /// Of the distance: some tens of roundings of coordinates up to 4, seen at a slant of 0.02.
    const CLOSE: f64 = 1e-12;
    let mut draw = Draw::new(2150);
    for make in KINDS {
        let mut rays = 0;
        while rays < 30_000 {
            let Case { kind, middle, seams } = make(&mut draw);
            let shape = built(&kind);
            for target in seams {
                let ray = Ray::new(middle, target - middle);
                let hit = shape.hit(&ray, Span::AHEAD);
                let near = hit.filter(|at| (at.t - 1.0).abs() < CLOSE / ray.direction.length());
                let at = near.unwrap_or_else(|| panic!("{kind:?}: {hit:?} at {target:?}"));
                let surface = shape.surface(&ray, &at);
                // where the parts reach over the seam it is met once
                let again = shape.roots(&ray, Span { min: 0.9, max: 1.1 });
                let outward =
                    |at: &&Candidate| shape.surface(&ray, at).normal.dot(ray.direction) > 0.0;
                let ways_out = again.iter().filter(outward).count();
                let inward = again.len() - ways_out;
                assert_eq!(ways_out, inward + 1, "{kind:?}: {again:?} at {target:?}");
                let leaves = surface.normal.dot(ray.direction) > 0.0;
                assert!(leaves, "{kind:?}: {surface:?} faces inward");
                for _ in 0..3 {
                    let inward = draw.leaving(-surface.normal);
                    let back = Ray::new(surface.leave(inward), inward);
                    let next = shape.hit(&back, Span::AHEAD);
                    let out = next.filter(|at| shape.surface(&back, at).normal.dot(inward) > 0.0);
                    assert!(out.is_some(), "{kind:?}: {next:?} from {surface:?} by {inward:?}");
                }
                rays += 1;
            }
        }
    }
}
