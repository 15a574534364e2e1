//! Compounds (Suffern, ch. 19 and 21): a bounding box, and the nearest hit of all parts. The parts
//! are those that can be seen; the book leaves whole spheres and tori half inside.

use std::f64::consts::PI;

use oracle::Solid;

use super::wedge::Wedge;
use super::{
    Angles, Annulus, Disk, Instance, OpenCone, OpenCylinder, PartCylinder, PartSphere, PartTorus,
    Rectangle, SMALL_K_EPSILON, Textbook, cuboid,
};
use crate::math::{Aabb, Point, Ray, Vector, atan2, cos, sin, to_radians};

pub(super) type Part = Box<dyn Textbook>;

/// Several parts in a box.
#[derive(Debug)]
pub struct Compound {
    pub(super) min: Point,
    pub(super) max: Point,
    pub(super) parts: Vec<Part>,
}

impl Compound {
    /// Any parts, in their boxes.
    pub fn new(parts: Vec<(Aabb, Box<dyn Textbook>)>) -> Self {
        let (boxes, parts): (Vec<Aabb>, _) = parts.into_iter().unzip();
        let [min, max] = around(&boxes);
        Self { min, max, parts }
    }
}

/// The corners of the box around these, larger by epsilon on each side.
pub(super) fn around(boxes: &[Aabb]) -> [Point; 2] {
    let all = boxes.iter().fold(Aabb::EMPTY, |all, &one| all.union(one));
    let more = SMALL_K_EPSILON * Vector::new(1.0, 1.0, 1.0);
    [all.min - more, all.max + more]
}

impl Textbook for Compound {
    fn hit(&self, ray: &Ray) -> Option<f64> {
        let (t0, t1) = cuboid::slabs(ray, self.min, self.max);
        if !(t0 < t1 && t1 > SMALL_K_EPSILON) {
            return None;
        }
        let hits = self.parts.iter().filter_map(|part| part.hit(ray));
        let nearest = hits.fold(f64::INFINITY, |nearest, t| if t < nearest { t } else { nearest });
        (nearest < f64::INFINITY).then_some(nearest)
    }
}

/// The compound of a solid.
pub fn of(solid: &Solid) -> Compound {
    match *solid {
        Solid::Cylinder { y0, y1, radius } => about_y(
            [y0, y1],
            radius,
            vec![disk(y0, radius), disk(y1, radius), Box::new(OpenCylinder { y0, y1, radius })],
        ),
        Solid::Cone { height, radius } => about_y(
            [0.0, height],
            radius,
            vec![disk(0.0, radius), Box::new(OpenCone { height, radius })],
        ),
        Solid::ThickRing { y0, y1, inner, outer } => about_y(
            [y0, y1],
            outer,
            vec![
                annulus(y0, inner, outer),
                annulus(y1, inner, outer),
                Box::new(OpenCylinder { y0, y1, radius: inner }),
                Box::new(OpenCylinder { y0, y1, radius: outer }),
            ],
        ),
        Solid::FlatRimmedBowl { inner, outer, opening } => flat_rimmed_bowl(inner, outer, opening),
        Solid::RoundRimmedBowl { inner, outer, opening } => {
            round_rimmed_bowl(inner, outer, opening)
        }
        Solid::ConcaveLens { radius, thickness, min_distance } => {
            concave_lens(radius, thickness, min_distance)
        }
        Solid::BeveledBox { min, max, bevel } => beveled_box([min, max], bevel),
        Solid::BeveledCylinder { y0, y1, radius, bevel } => {
            let (low, high, flat) = (y0 + bevel, y1 - bevel, radius - bevel);
            about_y(
                [y0, y1],
                radius,
                vec![
                    disk(y0, flat),
                    disk(y1, flat),
                    Box::new(OpenCylinder { y0: low, y1: high, radius }),
                    rounded(low, flat, bevel, [270.0, 360.0], AROUND),
                    rounded(high, flat, bevel, [0.0, 90.0], AROUND),
                ],
            )
        }
        Solid::BeveledRing { y0, y1, inner, outer, bevel } => {
            let (low, high) = (y0 + bevel, y1 - bevel);
            let (near, far) = (inner + bevel, outer - bevel);
            about_y(
                [y0, y1],
                outer,
                vec![
                    annulus(y0, near, far),
                    annulus(y1, near, far),
                    Box::new(OpenCylinder { y0: low, y1: high, radius: inner }),
                    Box::new(OpenCylinder { y0: low, y1: high, radius: outer }),
                    rounded(low, far, bevel, [270.0, 360.0], AROUND),
                    rounded(high, far, bevel, [0.0, 90.0], AROUND),
                    rounded(low, near, bevel, [180.0, 270.0], AROUND),
                    rounded(high, near, bevel, [90.0, 180.0], AROUND),
                ],
            )
        }
        Solid::BeveledWedge { y0, y1, inner, outer, phi, bevel } => {
            Wedge { y: [y0, y1], r: [inner, outer], phi, bevel }.compound()
        }
    }
}

fn about_y([y0, y1]: [f64; 2], radius: f64, parts: Vec<Part>) -> Compound {
    let (min, max) = (Point::new(-radius, y0, -radius), Point::new(radius, y1, radius));
    Compound { min, max, parts }
}

fn disk(y: f64, radius: f64) -> Part {
    Box::new(Disk { center: Point::new(0.0, y, 0.0), normal: Vector::Y, radius })
}

fn annulus(y: f64, inner: f64, outer: f64) -> Part {
    Box::new(Annulus { center: Point::new(0.0, y, 0.0), normal: Vector::Y, inner, outer })
}

/// The part of a sphere about `(0, y, 0)` between two polar angles, in radians.
fn zone(y: f64, radius: f64, [min, max]: [f64; 2]) -> Part {
    let center = Point::new(0.0, y, 0.0);
    Box::new(PartSphere { center, radius, phi: AROUND, theta: Angles { min, max } })
}

/// All azimuths.
const AROUND: Angles = Angles { min: 0.0, max: 2.0 * PI };

/// The part of a torus at a height, at these angles around its tube in degrees; perhaps through 0.
pub(super) fn rounded(y: f64, swept: f64, tube: f64, theta: [f64; 2], phi: Angles) -> Part {
    let theta = Angles::degrees(theta);
    moved([0.0, y, 0.0], 1, PartTorus { a: swept, b: tube, phi, theta })
}

/// The part, its y axis along this axis of the world, z and x along the next ones.
pub(super) fn moved(origin: [f64; 3], axis: usize, part: impl Textbook + 'static) -> Part {
    let mut matrix = origin.map(|x| [0.0, 0.0, 0.0, x]);
    for (own, along) in [(1, axis), (2, (axis + 1) % 3), (0, (axis + 2) % 3)] {
        matrix[along][own] = 1.0;
    }
    Box::new(Instance::new(matrix, Box::new(part)))
}

fn flat_rimmed_bowl(inner: f64, outer: f64, opening: f64) -> Compound {
    let theta = to_radians(0.5 * opening);
    let height = inner * cos(theta);
    let rim = (outer * outer - height * height).sqrt();
    // the sphere reaches out to its equator, or to the rim below it
    let reach = if height > 0.0 { outer } else { rim };
    about_y(
        [-outer, height],
        reach,
        vec![
            zone(0.0, inner, [theta, PI]),
            zone(0.0, outer, [atan2(rim, height), PI]),
            annulus(height, inner * sin(theta), rim),
        ],
    )
}

fn round_rimmed_bowl(inner: f64, outer: f64, opening: f64) -> Compound {
    let theta = 0.5 * opening;
    let (middle, thin) = (0.5 * (inner + outer), 0.5 * (outer - inner));
    let radians = to_radians(theta);
    let (height, swept) = (middle * cos(radians), middle * sin(radians));
    // from the direction of the outer sphere over the top to that of the inner one
    let from = (90.0 - theta).rem_euclid(360.0);
    let rim = rounded(height, swept, thin, [from, 270.0 - theta], AROUND);
    about_y(
        [-outer, height + thin],
        outer,
        vec![zone(0.0, inner, [radians, PI]), zone(0.0, outer, [radians, PI]), rim],
    )
}

fn concave_lens(radius: f64, thickness: f64, min_distance: f64) -> Compound {
    let (depth, far) = (0.5 * (thickness - min_distance), 0.5 * thickness);
    let rho = (depth * depth + radius * radius) / (2.0 * depth);
    let center = rho + 0.5 * min_distance;
    let omega = atan2(radius, rho - depth);
    about_y(
        [-far, far],
        radius,
        vec![
            zone(center, rho, [PI - omega, PI]),
            zone(-center, rho, [0.0, omega]),
            Box::new(OpenCylinder { y0: -far, y1: far, radius }),
        ],
    )
}

/// 6 rectangles, 12 quarters of cylinders and 8 eighths of spheres.
fn beveled_box([min, max]: [[f64; 3]; 2], bevel: f64) -> Compound {
    const SIDES: [f64; 2] = [-1.0, 1.0];
    let end = |i: usize, side: f64| if side < 0.0 { min[i] + bevel } else { max[i] - bevel };
    let mut parts: Vec<Part> = Vec::new();
    for i in 0..3 {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        for side in SIDES {
            let (mut corner, mut a, mut b) = ([0.0; 3], [0.0; 3], [0.0; 3]);
            corner[i] = if side < 0.0 { min[i] } else { max[i] };
            (corner[j], corner[k]) = (end(j, -1.0), end(k, -1.0));
            (a[j], b[k]) = (end(j, 1.0) - corner[j], end(k, 1.0) - corner[k]);
            parts.push(Box::new(Rectangle::new(corner.into(), a.into(), b.into())));
            // an edge along axis i, at this side of z's axis j and that of x's axis k
            for other in SIDES {
                let mut origin = [0.0; 3];
                (origin[j], origin[k]) = (end(j, side), end(k, other));
                let (y0, y1) = (end(i, -1.0), end(i, 1.0));
                let phi = quadrant(other, side);
                parts.push(moved(origin, i, PartCylinder { y0, y1, radius: bevel, phi }));
            }
        }
    }
    for x in SIDES {
        for y in SIDES {
            for z in SIDES {
                let center = Point::new(end(0, x), end(1, y), end(2, z));
                let theta = Angles::degrees(if y > 0.0 { [0.0, 90.0] } else { [90.0, 180.0] });
                let phi = quadrant(x, z);
                parts.push(Box::new(PartSphere { center, radius: bevel, phi, theta }));
            }
        }
    }
    Compound { min: min.into(), max: max.into(), parts }
}

/// The azimuths, from +z towards +x, of points with these signs of x and z.
fn quadrant(x: f64, z: f64) -> Angles {
    Angles::degrees(match (x > 0.0, z > 0.0) {
        (true, true) => [0.0, 90.0],
        (true, false) => [90.0, 180.0],
        (false, false) => [180.0, 270.0],
        (false, true) => [270.0, 360.0],
    })
}
