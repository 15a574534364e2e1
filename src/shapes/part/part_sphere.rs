//! The part sphere, convex and concave (Suffern, ch. 19): the points of a [`Sphere`] with azimuth φ
//! and polar angle θ between two angles each, where `x = r sin θ sin φ`, `y = r cos θ` and
//! `z = r sin θ cos φ`.
//!
//! Both roots of the sphere are tested in turn. [`Angles`] tests φ by cross products with both
//! ends; the book computes φ itself and cannot cross φ = 0. The book tests
//! `r cos θ_max ≤ y ≤ r cos θ_min`; here θ is tested by `sin(θ − θ_min) ≥ 0` and
//! `sin(θ_max − θ) ≥ 0`, as near the poles y hardly changes with θ.

use super::angles::{Angles, full_turn};
use crate::invalid::Invalid;
use crate::math::{Length, Point, Vector, cos_degrees, sin_degrees};
use crate::shapes::border::along;
use crate::shapes::trimmed::{Trim, Trimmed};
use crate::shapes::{Context, Made, Specification, Sphere, made};

/// The part of a sphere within a range of azimuths φ and one of polar angles θ.
#[kind(PartialEq)]
pub struct PartSphere {
    /// The centre.
    pub center: Point,
    /// The radius; positive.
    pub radius: Length,
    /// From the first azimuth up to the second, in degrees from +z towards +x, each from −360 to
    /// 360; through 360 where the first is larger.
    #[default(full_turn())]
    pub phi: [f64; 2],
    /// From the first polar angle down to the second, in degrees from +y: `[0, 90]` is the upper
    /// hemisphere.
    #[default([0.0, 180.0])]
    pub theta: [f64; 2],
    /// Whether the normal points to the centre: the book's concave part sphere.
    #[optional]
    pub inward: bool,
}

/// The points of a sphere with a polar angle in this range.
#[derive(Clone, Debug)]
struct PolarRange {
    /// `(sin θ, cos θ)` of `θ_min` and `θ_max`.
    theta: [[f64; 2]; 2],
    /// The book's `r cos θ_max` and `r cos θ_min`.
    heights: [f64; 2],
}

impl Specification for PartSphere {
    fn make(&self, _: &mut Context) -> Made {
        let Self { center, radius, phi, theta, inward } = *self;
        let whole = Sphere { center, radius, inward };
        let phi = Angles::new("phi", phi)?;
        let [from, to] = theta;
        let ordered = 0.0 <= from && from < to && to <= 180.0;
        if !ordered {
            let problem =
                format!("found {theta:?}, but two ascending angles from 0 to 180 are needed");
            return Err(Invalid::field("theta", problem));
        }
        let polar = PolarRange::new(theta, radius);
        let bounds = phi.bounds(center, polar.axis_distances(radius), polar.heights);
        let size = radius + center.to_vector().max_abs();
        made(Trimmed::new(whole, (polar, phi), size, bounds))
    }
}

impl PolarRange {
    fn new(theta: [f64; 2], radius: f64) -> Self {
        let theta = theta.map(|angle| [sin_degrees(angle), cos_degrees(angle)]);
        let [[_, c0], [_, c1]] = theta;
        Self { theta, heights: [radius * c1, radius * c0] }
    }

    /// The least and the greatest distance from the axis.
    fn axis_distances(&self, r: f64) -> [f64; 2] {
        let [[s0, c0], [s1, c1]] = self.theta;
        let across_equator = c0 >= 0.0 && c1 <= 0.0;
        let far = if across_equator { r } else { r * s0.max(s1) };
        [r * s0.min(s1), far]
    }
}

impl Trim for PolarRange {
    fn book_has(&self, v: Vector) -> bool {
        let [lowest, highest] = self.heights;
        (lowest..=highest).contains(&v.y())
    }

    /// `r sin(θ − θ_min)` and `r sin(θ_max − θ)`; a pole is no edge.
    #[inline]
    fn distances(&self, v: Vector) -> [f64; 2] {
        let (y, rho) = (v.y(), v.across_y().length());
        let [[s0, c0], [s1, c1]] = self.theta;
        let unless_pole = |sine: f64, distance| if sine > 0.0 { distance } else { f64::INFINITY };
        [unless_pole(s0, rho * c0 - y * s0), unless_pole(s1, y * s1 - rho * c1)]
    }

    fn away(&self, v: Vector) -> [Vector; 2] {
        let level = v.across_y();
        let down = along(v.y() * along(level) - level.length() * Vector::Y);
        [down, -down]
    }
}
