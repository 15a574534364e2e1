//! The beveled wedge (Suffern, ch. 21), of the parts of chapter 19. The book has no part for its
//! caps: an annulus between two lines that are not through its centre.

use std::f64::consts::TAU;

use super::compound::{Part, moved, rounded};
use super::{
    Angles, Compound, Instance, K_EPSILON, PartCylinder, PartSphere, Rectangle, Textbook, azimuth,
    plane,
};
use crate::math::{Point, Ray, Vector, atan2, cos, sin, to_degrees, to_radians};

/// A wedge's numbers.
pub(super) struct Wedge {
    /// The heights of bottom and top.
    pub y: [f64; 2],
    /// The radii of the walls.
    pub r: [f64; 2],
    /// The azimuths of the sides, in degrees from +z towards +x.
    pub phi: [f64; 2],
    /// The radius of the edges.
    pub bevel: f64,
}

/// What the bevel leaves of the bottom or the top.
#[derive(Debug)]
struct Cap {
    y: f64,
    r: [f64; 2],
    from: f64,
    width: f64,
    bevel: f64,
}

impl Textbook for Cap {
    fn hit(&self, ray: &Ray) -> Option<f64> {
        let t = plane::distance(ray, Point::new(0.0, self.y, 0.0), Vector::Y);
        if t <= K_EPSILON {
            return None;
        }
        let p = ray.at(t);
        let r = (p.x() * p.x() + p.z() * p.z()).sqrt();
        if !(self.r[0] < r && r < self.r[1]) {
            return None;
        }
        // as far off the sides as the bevel: sin of this angle is bevel/r
        let off_side = atan2(self.bevel, (r * r - self.bevel * self.bevel).sqrt());
        let angle = (azimuth(p) - self.from).rem_euclid(TAU);
        (off_side < angle && angle < self.width - off_side).then_some(t)
    }
}

impl Wedge {
    pub(super) fn compound(&self) -> Compound {
        let (b, [r0, r1]) = (self.bevel, self.r);
        // where the plane sides begin and end, and the angles from there to the sides' own
        let ends = [(r0 * (r0 + 2.0 * b)).sqrt(), (r1 * (r1 - 2.0 * b)).sqrt()];
        let [alpha, beta] = ends.map(|end| to_degrees(atan2(b, end)));
        let [low, high] = [self.y[0] + b, self.y[1] - b];
        let (near, far) = (r0 + b, r1 - b);
        let mut parts: Vec<Part> = Vec::new();
        for y in self.y {
            let (from, width) = (to_radians(self.phi[0]), to_radians(self.width()));
            parts.push(Box::new(Cap { y, r: [near, far], from, width, bevel: b }));
        }
        let arcs = [
            (far, high, beta, [0.0, 90.0]),
            (near, high, alpha, [90.0, 180.0]),
            (near, low, alpha, [180.0, 270.0]),
            (far, low, beta, [270.0, 360.0]),
        ];
        for (swept, y, less, theta) in arcs {
            parts.extend(self.inside(less).map(|phi| rounded(y, swept, b, theta, phi)));
        }
        for (radius, less) in [(r0, alpha), (r1, beta)] {
            let wall = |phi| -> Part { Box::new(PartCylinder { y0: low, y1: high, radius, phi }) };
            parts.extend(self.inside(less).map(wall));
        }
        for (turned, mirrored) in [(self.phi[0], 1.0), (self.phi[1], -1.0)] {
            let (s, c) = (sin(to_radians(turned)), cos(to_radians(turned)));
            let matrix =
                [[mirrored * c, 0.0, s, 0.0], [0.0, 1.0, 0.0, 0.0], [-mirrored * s, 0.0, c, 0.0]];
            let turned = |part| -> Part { Box::new(Instance::new(matrix, part)) };
            parts.extend(side(ends, [low, high], b, [alpha, beta]).into_iter().map(turned));
        }
        let [min, max] = self.corners();
        Compound { min, max, parts }
    }

    /// From side to side, in degrees.
    fn width(&self) -> f64 {
        (self.phi[1] - self.phi[0]).rem_euclid(360.0)
    }

    /// The azimuths farther than this from both sides, if there are any.
    fn inside(&self, less: f64) -> Option<Angles> {
        let phi = [self.phi[0] + less, self.phi[1] - less];
        (2.0 * less < self.width()).then(|| Angles::degrees(phi.map(|phi| phi.rem_euclid(360.0))))
    }

    /// The corners of the box around it: its extremes are at the sides or at whole quarters of a turn.
    fn corners(&self) -> [Point; 2] {
        let [from, width] = [self.phi[0], self.width()];
        let quarters = (-4..=8).map(|i| 90.0 * f64::from(i));
        let quarters = quarters.filter(|phi| (from..from + width).contains(phi));
        let (mut min, mut max) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for phi in quarters.chain([from, from + width]).map(to_radians) {
            for r in self.r {
                for (i, x) in [r * sin(phi), r * cos(phi)].into_iter().enumerate() {
                    (min[i], max[i]) = (min[i].min(x), max[i].max(x));
                }
            }
        }
        [Point::new(min[0], self.y[0], min[1]), Point::new(max[0], self.y[1], max[1])]
    }
}

/// The plane side at azimuth 0 with its edges and corners, the wedge where x > 0.
fn side(ends: [f64; 2], [low, high]: [f64; 2], bevel: f64, [alpha, beta]: [f64; 2]) -> Vec<Part> {
    let length = ends[1] - ends[0];
    let corner = Point::new(0.0, low, ends[0]);
    let (a, b) = (length * Vector::Z, (high - low) * Vector::Y);
    let mut parts: Vec<Part> = vec![Box::new(Rectangle::new(corner, a, b))];
    for (y, phi) in [(low, [180.0, 270.0]), (high, [90.0, 180.0])] {
        let phi = Angles::degrees(phi); // from +x towards +y
        let rail = PartCylinder { y0: 0.0, y1: length, radius: bevel, phi };
        parts.push(moved([bevel, y, ends[0]], 2, rail));
    }
    for (z, phi) in [(ends[0], [180.0 + alpha, 270.0]), (ends[1], [270.0, beta])] {
        let phi = Angles::degrees(phi);
        let post = PartCylinder { y0: low, y1: high, radius: bevel, phi };
        parts.push(moved([bevel, 0.0, z], 1, post));
        for (y, theta) in [(low, [90.0, 180.0]), (high, [0.0, 90.0])] {
            let (center, theta) = (Point::new(bevel, y, z), Angles::degrees(theta));
            parts.push(Box::new(PartSphere { center, radius: bevel, phi, theta }));
        }
    }
    parts
}
