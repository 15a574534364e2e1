//! What a beveled wedge is made of (Suffern, ch. 21): the ball of the bevel's radius that rolls
//! inside the wedge touches its sides in what is left of them, and rounds everything else.

use std::sync::Arc;

use super::edges::{
    Named, check_bevel, corner, extended, inset, moved, overlap, tube, wall, widened,
};
use crate::invalid::{Invalid, length, shown};
use crate::kinds::Custom;
use crate::math::{
    Aabb, Axis, Normal, Point, Ray, Span, Step, Vector, atan2, cos_degrees, sin_degrees, to_degrees,
};
use crate::shapes::part::angles::Angles;
use crate::shapes::{Candidate, Instance, Kind, Rectangle, Shape, Surface, plane_distance};

use crate::shapes::plain::annulus::{between, radii};

/// A wedge and its bevel. The centres of the ball in the corners are at the distance `bevel` from
/// the sides: `r0 + bevel` and `r1 − bevel` from the axis, at the angles α and β from the sides.
#[derive(Clone, Debug)]
pub struct Wedge {
    /// The heights of bottom and top.
    pub y: [f64; 2],
    /// The radii of the inner and the outer wall.
    pub r: [f64; 2],
    /// The azimuths of the sides, ascending; the first from −360 to 360.
    pub phi: [f64; 2],
    /// The radius of the edges.
    pub bevel: f64,
}

/// Which sides of a wedge are wanted: those that touch others are not.
#[derive(Clone, Copy, Debug)]
pub struct Sides {
    /// The wall nearer to the axis.
    pub inner_wall: bool,
    /// The other wall.
    pub outer_wall: bool,
    /// The plane sides.
    pub ends: bool,
}

impl Wedge {
    /// Whether the bevel fits; the heights ascend, and so do the azimuths, by less than 360°.
    pub fn check(&self) -> Result<(), Invalid> {
        let [r0, r1] = self.r;
        length("inner_radius", r0)?;
        radii(r0, r1)?;
        let extents = [("height", self.y), ("distance between the radii", self.r)];
        check_bevel(self.bevel, self.largest(), &extents)?;
        let width = self.phi[1] - self.phi[0];
        /// In degrees; more than the rounding of azimuths.
        const SLACK: f64 = 1e-10;
        if 2.0 * self.alpha() > width + SLACK {
            // of the bevel that fits just so: sin(width/2) = b/(r0 + b)
            let sine = sin_degrees(0.5 * width);
            let [found, most] = [self.bevel, r0 * sine / (1.0 - sine)].map(shown);
            let problem =
                format!("found {found}, but at most {most} fits: the inner wall is too narrow");
            return Err(Invalid::field("bevel", problem));
        }
        Ok(())
    }

    /// How far from the axis the plane sides begin and end.
    pub fn ends(&self) -> [f64; 2] {
        let ([r0, r1], b) = (self.r, self.bevel);
        [(r0 * (r0 + 2.0 * b)).sqrt(), (r1 * (r1 - 2.0 * b)).sqrt()]
    }

    fn alpha(&self) -> f64 {
        to_degrees(atan2(self.bevel, self.ends()[0]))
    }

    fn beta(&self) -> f64 {
        to_degrees(atan2(self.bevel, self.ends()[1]))
    }

    /// The azimuths of the inner wall, if the bevel leaves any of it.
    pub fn inner_wall(&self) -> Option<[f64; 2]> {
        let phi = inset(self.phi, self.alpha());
        (phi[0] < phi[1]).then_some(phi)
    }

    /// The azimuths of the outer wall.
    pub fn outer_wall(&self) -> Option<[f64; 2]> {
        let phi = inset(self.phi, self.beta());
        (phi[0] < phi[1]).then_some(phi)
    }

    /// The heights of walls and sides, if the bevel leaves any of them.
    pub fn heights(&self) -> Option<[f64; 2]> {
        let y = inset(self.y, self.bevel);
        (y[0] < y[1]).then_some(y)
    }

    /// How far parts reach over the seams between them.
    pub fn overlap(&self) -> f64 {
        overlap(self.largest(), self.bevel)
    }

    /// The largest coordinate.
    pub fn largest(&self) -> f64 {
        self.y[0].abs().max(self.y[1].abs()).max(self.r[1])
    }

    /// A wall of this radius that touches the edges around it.
    pub fn wall(&self, y: [f64; 2], radius: f64, phi: [f64; 2], inward: bool) -> Kind {
        let over = self.overlap();
        let phi = within_a_turn(widened(phi, over, radius));
        wall(extended(y, over), radius, phi, inward)
    }

    /// The parts: caps, walls and sides that are wanted, edges and corners.
    pub fn parts(&self, wanted: Sides) -> Vec<Named> {
        let mut parts = self.caps();
        let walls = [
            ("inner_wall", wanted.inner_wall, self.inner_wall(), self.r[0], true),
            ("outer_wall", wanted.outer_wall, self.outer_wall(), self.r[1], false),
        ];
        for (name, wanted, phi, radius, inward) in walls {
            if let (true, Some(y), Some(phi)) = (wanted, self.heights(), phi) {
                parts.push((name, self.wall(y, radius, phi, inward)));
            }
        }
        parts.extend(self.arcs());
        // the second end is the first, mirrored
        let ends = [
            ("start", vec![Step::RotateY(self.phi[0])]),
            ("end", vec![Step::Reflect(Axis::X), Step::RotateY(self.phi[1])]),
        ];
        for (name, steps) in ends {
            let face = if wanted.ends { self.face(name) } else { None };
            let all = face.into_iter().chain(self.posts()).chain(self.rails());
            parts.extend(
                all.map(|(name, part)| (name, Kind::from(Instance::new(part, steps.clone())))),
            );
        }
        parts
    }

    fn caps(&self) -> Vec<Named> {
        let [r0, r1] = inset(self.r, self.bevel);
        if r0 >= r1 {
            return Vec::new();
        }
        let [bottom, top] = self.y;
        let caps = [("bottom", bottom, -Normal::Y), ("top", top, Normal::Y)];
        let cap = |(name, y, normal)| {
            // the azimuths are in range: Azimuth takes any that check has passed
            let phi = Angles::new("phi", within_a_turn(self.phi)).ok()?;
            let ends = self.phi.map(|phi| [sin_degrees(phi), cos_degrees(phi)]);
            let over = self.overlap();
            let (r, bevel) = (extended([r0, r1], over), self.bevel - over);
            let cap = Cap { y, normal, r, phi, ends, bevel };
            Some((name, Kind::Custom(Custom(Arc::new(cap)))))
        };
        caps.into_iter().filter_map(cap).collect()
    }

    /// The edges between walls and caps.
    fn arcs(&self) -> Vec<Named> {
        let [near, far] = inset(self.r, self.bevel);
        let [low, high] = inset(self.y, self.bevel);
        let arcs = [
            (far, high, self.outer_wall(), [0.0, 90.0]),
            (near, high, self.inner_wall(), [90.0, 180.0]),
            (near, low, self.inner_wall(), [180.0, 270.0]),
            (far, low, self.outer_wall(), [270.0, 360.0]),
        ];
        let arc = |(swept, y, phi, theta): (f64, f64, Option<[f64; 2]>, _)| {
            let phi = within_a_turn(widened(phi?, self.overlap(), swept));
            let part = tube(swept, self.bevel, phi, theta);
            Some(("edges", moved(part, y * Vector::Y)))
        };
        arcs.into_iter().filter_map(arc).collect()
    }

    // a side at azimuth 0: it is in the plane x = 0, the wedge in front of it, where x > 0

    /// What is left of the side.
    fn face(&self, name: &'static str) -> Option<Named> {
        let [from, to] = self.ends();
        if from >= to {
            return None;
        }
        let over = self.overlap();
        let ([from, to], [low, high]) =
            (extended([from, to], over), extended(self.heights()?, over));
        let corner = Point::new(0.0, low, from);
        let (a, b) = ((to - from) * Vector::Z, (high - low) * Vector::Y);
        Some((name, Rectangle { corner, a, b }.into()))
    }

    /// The upright edges of the side, and the corners at their ends.
    fn posts(&self) -> Vec<Named> {
        let (b, [from, to]) = (self.bevel, self.ends());
        let [low, high] = inset(self.y, b);
        let post = extended([low, high], self.overlap());
        let mut posts = Vec::new();
        for (s, phi) in [(from, [180.0 + self.alpha(), 270.0]), (to, [-90.0, self.beta()])] {
            if low < high {
                posts.push(("edges", moved(wall(post, b, phi, false), Vector::new(b, 0.0, s))));
            }
            posts.push(("corners", corner(Point::new(b, low, s), b, phi, false)));
            posts.push(("corners", corner(Point::new(b, high, s), b, phi, true)));
        }
        posts
    }

    /// The level edges of the side.
    fn rails(&self) -> Vec<Named> {
        let (b, [from, to]) = (self.bevel, self.ends());
        let [low, high] = inset(self.y, b);
        if from >= to {
            return Vec::new();
        }
        let ends = extended([from, to], self.overlap());
        // turned by y → z, z → −y
        let rail = |y: f64, phi| {
            let steps = vec![Step::RotateX(90.0), Step::Translate(Vector::new(b, y, 0.0))];
            ("edges", Kind::from(Instance::new(wall(ends, b, phi, false), steps)))
        };
        vec![rail(low, [270.0, 360.0]), rail(high, [180.0, 270.0])]
    }
}

/// The same azimuths, from −360 to 360.
fn within_a_turn(phi: [f64; 2]) -> [f64; 2] {
    phi.map(|phi| if phi > 360.0 { phi - 360.0 } else { phi })
}

/// What a bevel leaves of the top or bottom of a wedge: the points so far from the axis that are
/// not within `bevel` of a side.
#[derive(Debug)]
struct Cap {
    y: f64,
    normal: Normal,
    r: [f64; 2],
    phi: Angles,
    /// `(sin φ, cos φ)` of both sides.
    ends: [[f64; 2]; 2],
    bevel: f64,
}

impl Cap {
    fn contains(&self, v: Vector) -> bool {
        let clear = |[s, c]: [f64; 2]| {
            let along = v.x() * s + v.z() * c;
            let beside = v.x() * c - v.z() * s;
            along <= 0.0 || beside.abs() >= self.bevel
        };
        between(self.r, v) && self.phi.has_azimuth_of(v) && self.ends.into_iter().all(clear)
    }

    fn anchor(&self) -> Point {
        Point::new(0.0, self.y, 0.0)
    }
}

impl Shape for Cap {
    fn hit(&self, ray: &Ray, span: Span) -> Option<Candidate> {
        let t = plane_distance(ray, self.anchor(), self.normal);
        let hit = span.contains(t) && self.contains((ray.at(t) - self.anchor()).across_y());
        hit.then(|| Candidate::at(t))
    }

    fn surface(&self, ray: &Ray, at: &Candidate) -> Surface {
        Surface::flat(ray.at(at.t), self.anchor(), self.normal)
    }

    fn bounds(&self) -> Aabb {
        let [min, max] = self.phi.bounds(self.r[0], self.r[1]);
        Aabb { min: self.anchor() + min, max: self.anchor() + max }
    }
}
