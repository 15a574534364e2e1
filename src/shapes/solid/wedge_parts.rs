//! The parts of a beveled wedge (Suffern, ch. 21).
//!
//! A sphere of radius `r_b` in each corner touches a wall, a side, and the bottom or the top. The centres
//! are at the radii `r0 + r_b` and `r1 − r_b` from the axis and at the angles α and β from the side:
//!
//! - `sin α = r_b/(r0 + r_b)` and `cos α = s0/(r0 + r_b)` with `s0 = √(r0² + 2 r0 r_b)`,
//! - `sin β = r_b/(r1 − r_b)` and `cos β = s1/(r1 − r_b)` with `s1 = √(r1² − 2 r1 r_b)`.
//!
//! So the inner wall goes from `φ0 + α` to `φ1 − α` and the outer one from `φ0 + β` to `φ1 − β`, each with
//! a part torus above and below it; a side is a rectangle from `s0` to `s1`, with a part cylinder along
//! each of its edges. The book makes top and bottom of a part annulus and patches; here each is one
//! [`Cap`].

use std::sync::Arc;

use super::edges::{Named, corner, inset, left_of, moved, tube, wall};
use crate::kinds::Custom;
use crate::math::{
    Aabb, Axis, Normal, Point, Ray, Span, Step, Vector, atan2, cos_degrees, sin_degrees, to_degrees,
};
use crate::shapes::border::{Border, is_rounding};
use crate::shapes::part::angles::Angles;
use crate::shapes::plain::annulus::{away_from_rims, between, rim_distances};
use crate::shapes::{
    Candidate, Instance, Kind, PartCylinder, Rectangle, Shape, Surface, plane_distance,
};

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
            let cap = Cap { y, normal, r, phi: self.range, sides, bevel: self.bevel };
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

/// The flat top or bottom of a wedge: the points of the plane `y` between two radii and two sides that
/// are at least `bevel` from both sides.
#[derive(Debug)]
struct Cap {
    y: f64,
    normal: Normal,
    r: [f64; 2],
    phi: Angles,
    /// `(sin φ, cos φ)` of both sides.
    sides: [[f64; 2]; 2],
    bevel: f64,
}

impl Cap {
    fn contains(&self, v: Vector) -> bool {
        let is_clear = |side| {
            let [along, across] = Self::along_and_across(side, v);
            along <= 0.0 || across.abs() >= self.bevel
        };
        between(self.r, v) && self.phi.has_azimuth_of(v) && self.sides.into_iter().all(is_clear)
    }

    /// `v` in coordinates along a side, which starts at the axis, and across it.
    fn along_and_across([s, c]: [f64; 2], v: Vector) -> [f64; 2] {
        [v.x() * s + v.z() * c, v.x() * c - v.z() * s]
    }

    fn anchor(&self) -> Point {
        Point::new(0.0, self.y, 0.0)
    }
}

impl Shape for Cap {
    fn hit(&self, ray: &Ray, span: Span) -> Option<Candidate> {
        let t = plane_distance(ray, self.anchor(), self.normal);
        if !span.contains(t) {
            return None;
        }
        let v = (ray.at(t) - self.anchor()).across_y();
        let within = self.contains(v) || self.phi.has_azimuth_of(v) && is_rounding(self, ray, t);
        within.then(|| Candidate::at(t))
    }

    fn surface(&self, ray: &Ray, at: &Candidate) -> Surface {
        let surface = Surface::flat(ray.at(at.t), self.anchor(), self.normal);
        let v = (surface.point - self.anchor()).across_y();
        let from_side = |side| {
            let [along, across] = Self::along_and_across(side, v);
            if along > 0.0 { across.abs() - self.bevel } else { f64::INFINITY }
        };
        let ([outer, inner], [first, last]) = (rim_distances(self.r, v), self.sides.map(from_side));
        let size = self.r[1] + self.y.abs();
        surface.within(Border::of([outer, inner, first, last], size, || {
            let off_side = |side @ [s, c]: [f64; 2]| {
                let [_, across] = Self::along_and_across(side, v);
                across.signum() * Vector::new(c, 0.0, -s)
            };
            let ([outer, inner], [first, last]) = (away_from_rims(v), self.sides.map(off_side));
            [outer, inner, first, last]
        }))
    }

    fn bounds(&self) -> Aabb {
        let [min, max] = self.phi.bounds(self.r[0], self.r[1]);
        Aabb { min: self.anchor() + min, max: self.anchor() + max }
    }
}
