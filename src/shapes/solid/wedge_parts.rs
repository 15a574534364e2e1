//! The parts of a beveled wedge (Suffern, ch. 21).
//!
//! A sphere of radius `r_b` in each corner touches a wall, a side, and the bottom or the top. The
//! centres are at the radii `r0 + r_b` and `r1 − r_b` from the axis and at the angles α and β from
//! the side:
//!
//! - `sin α = r_b/(r0 + r_b)` and `cos α = s0/(r0 + r_b)` with `s0 = √(r0² + 2 r0 r_b)`,
//! - `sin β = r_b/(r1 − r_b)` and `cos β = s1/(r1 − r_b)` with `s1 = √(r1² − 2 r1 r_b)`.
//!
//! So the inner wall goes from `φ0 + α` to `φ1 − α` and the outer one from `φ0 + β` to `φ1 − β`,
//! each with a part torus above and below it; a side is a rectangle from `s0` to `s1`, with a part
//! cylinder along each of its edges. The book makes top and bottom of a part annulus and patches;
//! here each is one annulus, [`Clear`] of the sides.

use std::sync::Arc;

use super::edges::{Named, corner, inset, left_of, moved, tube, wall};
use crate::kinds::Custom;
use crate::math::{Axis, Normal, Point, Step, Vector, atan2, cos_degrees, sin_degrees, to_degrees};
use crate::shapes::part::angles::Angles;
use crate::shapes::plain::annulus::Radii;
use crate::shapes::plain::plane::PlaneThrough;
use crate::shapes::trimmed::{Trim, Trimmed};
use crate::shapes::{Instance, Kind, PartCylinder, Rectangle};

/// A wedge whose numbers are fit for use.
#[derive(Clone, Debug)]
pub struct Wedge {
    /// The heights of bottom and top.
    pub y: [f64; 2],
    /// The radii of the inner and the outer wall.
    pub r: [f64; 2],
    /// The azimuths of the sides in degrees, ascending; the first from −360 to 360.
    pub phi: [f64; 2],
    /// The same azimuths as a range.
    pub range: Angles,
    /// The radius of the edges.
    pub bevel: f64,
}

impl Wedge {
    /// `s0` and `s1`.
    fn side(&self) -> [f64; 2] {
        let ([r0, r1], b) = (self.r, self.bevel);
        [(r0 * (r0 + 2.0 * b)).sqrt(), (r1 * (r1 - 2.0 * b)).sqrt()]
    }

    /// α and β in degrees.
    pub fn alpha_beta(&self) -> [f64; 2] {
        self.side().map(|s| to_degrees(atan2(self.bevel, s)))
    }

    /// The azimuths farther than this from both sides, from −360 to 360.
    fn azimuths(&self, less: f64) -> Option<[f64; 2]> {
        let range = left_of(self.phi, less)?;
        Some(range.map(|phi| if phi > 360.0 { phi - 360.0 } else { phi }))
    }

    /// All parts by their names.
    pub fn parts(&self) -> Vec<Named> {
        let mut parts = [self.caps(), self.walls(), self.arcs()].concat();
        // the end is the start, mirrored
        let sides = [
            ("start", vec![Step::RotateY(self.phi[0])]),
            ("end", vec![Step::Reflect(Axis::X), Step::RotateY(self.phi[1])]),
        ];
        for (name, steps) in sides {
            for (name, part) in [self.face(name), self.posts(), self.rails()].concat() {
                parts.push((name, Instance::new(part, steps.clone()).into()));
            }
        }
        parts
    }

    fn caps(&self) -> Vec<Named> {
        let Some(r) = left_of(self.r, self.bevel) else { return Vec::new() };
        let sides = self.phi.map(|phi| [sin_degrees(phi), cos_degrees(phi)]);
        let cap = |y, normal| {
            let anchor = Point::new(0.0, y, 0.0);
            let (radii, clear) =
                (Radii::between(r), Clear { phi: self.range, sides, bevel: self.bevel });
            let (size, bounds) = (radii.size(anchor), self.range.bounds(anchor, r, [0.0; 2]));
            let cap = Trimmed::new(PlaneThrough::new(anchor, normal), (radii, clear), size, bounds);
            Kind::Custom(Custom(Arc::new(cap)))
        };
        let [bottom, top] = self.y;
        vec![("bottom", cap(bottom, -Normal::Y)), ("top", cap(top, Normal::Y))]
    }

    fn walls(&self) -> Vec<Named> {
        let Some([y0, y1]) = left_of(self.y, self.bevel) else { return Vec::new() };
        let ([alpha, beta], [r0, r1]) = (self.alpha_beta(), self.r);
        let walls = [("inner_wall", alpha, r0, true), ("outer_wall", beta, r1, false)];
        let wall = |(name, less, radius, inward)| {
            let phi = self.azimuths(less)?;
            Some((name, PartCylinder { y0, y1, radius, phi, inward }.into()))
        };
        walls.into_iter().filter_map(wall).collect()
    }

    /// The edges between walls and caps.
    fn arcs(&self) -> Vec<Named> {
        let [alpha, beta] = self.alpha_beta();
        let [near, far] = inset(self.r, self.bevel);
        let [low, high] = inset(self.y, self.bevel);
        let arcs = [
            (far, high, beta, [0.0, 90.0]),
            (near, high, alpha, [90.0, 180.0]),
            (near, low, alpha, [180.0, 270.0]),
            (far, low, beta, [270.0, 360.0]),
        ];
        let arc = |(swept, y, less, theta)| {
            let part = tube(swept, self.bevel, self.azimuths(less)?, theta);
            Some(("edges", moved(part, y * Vector::Y)))
        };
        arcs.into_iter().filter_map(arc).collect()
    }

    // the parts of a side at azimuth 0: it is in the plane x = 0, and the wedge is where x > 0

    /// The rectangle.
    fn face(&self, name: &'static str) -> Vec<Named> {
        let [s0, s1] = self.side();
        let (true, Some([low, high])) = (s0 < s1, left_of(self.y, self.bevel)) else {
            return Vec::new();
        };
        let corner = Point::new(0.0, low, s0);
        let (a, b) = ((s1 - s0) * Vector::Z, (high - low) * Vector::Y);
        vec![(name, Rectangle { corner, a, b }.into())]
    }

    /// The upright edges, and the corners at their ends.
    fn posts(&self) -> Vec<Named> {
        let (b, [s0, s1], [alpha, beta]) = (self.bevel, self.side(), self.alpha_beta());
        let [low, high] = inset(self.y, b);
        let mut posts = Vec::new();
        for (s, phi) in [(s0, [180.0 + alpha, 270.0]), (s1, [-90.0, beta])] {
            if low < high {
                posts.push(("edges", moved(wall([low, high], b, phi), Vector::new(b, 0.0, s))));
            }
            posts.push(("corners", corner(Point::new(b, low, s), b, phi, false)));
            posts.push(("corners", corner(Point::new(b, high, s), b, phi, true)));
        }
        posts
    }

    /// The level edges.
    fn rails(&self) -> Vec<Named> {
        let (b, [s0, s1], [low, high]) = (self.bevel, self.side(), inset(self.y, self.bevel));
        if s0 >= s1 {
            return Vec::new();
        }
        let rail = |y: f64, phi| {
            // y → z, z → −y
            let steps = vec![Step::RotateX(90.0), Step::Translate(Vector::new(b, y, 0.0))];
            ("edges", Kind::from(Instance::new(wall([s0, s1], b, phi), steps)))
        };
        vec![rail(low, [270.0, 360.0]), rail(high, [180.0, 270.0])]
    }
}

/// The points between two sides that are at least `bevel` from both.
#[derive(Clone, Debug)]
struct Clear {
    phi: Angles,
    /// `(sin φ, cos φ)` of both sides.
    sides: [[f64; 2]; 2],
    bevel: f64,
}

impl Clear {
    /// `v` in coordinates along a side, which starts at the axis, and across it.
    fn along_and_across([s, c]: [f64; 2], v: Vector) -> [f64; 2] {
        [v.x() * s + v.z() * c, v.x() * c - v.z() * s]
    }
}

impl Trim for Clear {
    /// A point that is not between the sides is on no edge.
    fn distances(&self, v: Vector) -> [f64; 2] {
        if !self.phi.has(v) {
            return [f64::NEG_INFINITY; 2];
        }
        self.sides.map(|side| {
            let [along, across] = Self::along_and_across(side, v);
            if along > 0.0 { across.abs() - self.bevel } else { f64::INFINITY }
        })
    }

    fn away(&self, v: Vector) -> [Vector; 2] {
        self.sides.map(|side @ [s, c]| {
            let [_, across] = Self::along_and_across(side, v);
            across.signum() * Vector::new(c, 0.0, -s)
        })
    }
}
