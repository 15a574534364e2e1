//! The part torus (Suffern, ch. 19): the points of a [`Torus`] with azimuth φ and angle around the
//! tube θ between two angles each, where `ρ = a + b cos θ`, `x = ρ sin φ`, `y = b sin θ` and
//! `z = ρ cos φ`.
//!
//! All hits of the torus are tested in turn. [`Angles`] tests φ and θ by cross products with both
//! ends; the book computes the angles themselves and cannot cross φ = 0.

use super::angles::{Angles, full_turn};
use crate::math::{Length, Point, Vector};
use crate::shapes::border::along;
use crate::shapes::textbook;
use crate::shapes::trimmed::{Trim, Trimmed};
use crate::shapes::{Context, Made, Specification, Torus, made};

/// The points of a [`Torus`] with azimuth φ (`x = ρ sin φ`, `z = ρ cos φ`) and angle around the
/// tube θ (`ρ = a + b cos θ`, `y = b sin θ`) in these ranges, ends included. A range whose first
/// end is the larger goes on through 360°.
#[kind(PartialEq)]
pub struct PartTorus {
    /// The radius of the circle in the middle of the tube, the book's `a`; positive.
    pub swept_radius: Length,
    /// The radius of the tube, the book's `b`: positive, and less than `swept_radius`.
    pub tube_radius: Length,
    /// From the first azimuth up to the second, in degrees from +z towards +x, each from −360 to
    /// 360; through 360 where the first is larger.
    #[default(full_turn())]
    pub phi: [f64; 2],
    /// From the first angle around the tube up to the second, in degrees from its outermost line
    /// upward.
    #[default(full_turn())]
    pub theta: [f64; 2],
    /// Whether the normal points into the tube instead.
    #[optional]
    pub inward: bool,
}

/// The points at these angles around the tube.
#[derive(Clone, Debug)]
struct AroundTube {
    swept_radius: f64,
    theta: Angles,
}

impl Specification for PartTorus {
    fn make(&self, _: &mut Context) -> Made {
        let &Self { swept_radius, tube_radius, inward, .. } = self;
        let torus = Torus { swept_radius, tube_radius, inward };
        torus.check()?;
        let (phi, theta) = (Angles::new("phi", self.phi)?, Angles::new("theta", self.theta)?);
        let [[near, low], [far, high]] = theta
            .extremes()
            .map(|[cos, sin]| [swept_radius + tube_radius * cos, tube_radius * sin]);
        let bounds = phi.bounds(Point::ORIGIN, [near, far], [low, high]);
        let trims = (AroundTube { swept_radius, theta }, phi);
        made(Trimmed::new(torus, trims, swept_radius + tube_radius, bounds))
    }
}

impl AroundTube {
    /// The point in the plane of a section, from the middle of the tube.
    fn in_section(&self, v: Vector) -> [f64; 2] {
        [v.across_y().length() - self.swept_radius, v.y()]
    }
}

impl Trim for AroundTube {
    fn book_has(&self, v: Vector) -> bool {
        let [out, up] = self.in_section(v);
        self.theta.book.contains(textbook::angle(up, out))
    }

    fn distances(&self, v: Vector) -> [f64; 2] {
        self.theta.end_distances(self.in_section(v))
    }

    fn away(&self, v: Vector) -> [Vector; 2] {
        let radial = along(v.across_y());
        self.theta.away_from_ends().map(|[out, up]| out * radial + up * Vector::Y)
    }
}
