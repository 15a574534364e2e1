//! The part torus (Suffern, ch. 19): the points of a [`Torus`] with azimuth φ and angle around the tube θ
//! between two angles each, where `ρ = a + b cos θ`, `x = ρ sin φ`, `y = b sin θ` and `z = ρ cos φ`.
//!
//! All hits of the torus are tested in turn. [`Angles`] tests φ and θ by cross products with both ends;
//! the book computes the angles themselves and cannot cross φ = 0.

use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::angles::{Angles, full_turn};
use crate::invalid::Invalid;
use crate::math::{Aabb, Length, Point, Ray, Span, Vector, lists};
use crate::shapes::border::{Border, along, is_rounding, nears};
use crate::shapes::plain::torus::{Torus, from_axis};
use crate::shapes::{Candidate, Context, Shape, Specification, Surface};

/// The points of a [`Torus`] with azimuth φ (`x = ρ sin φ`, `z = ρ cos φ`) and angle around the tube
/// θ (`ρ = a + b cos θ`, `y = b sin θ`) in these ranges, ends included. A range whose first end is the
/// larger goes on through 360°.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PartTorus {
    /// The radius of the circle in the middle of the tube, the book's `a`; positive.
    #[schemars(with = "Length")]
    pub swept_radius: f64,
    /// The radius of the tube, the book's `b`: positive, and less than `swept_radius`.
    #[schemars(with = "Length")]
    pub tube_radius: f64,
    /// From the first azimuth up to the second, in degrees from +z towards +x, each from −360 to 360;
    /// through 360 where the first is larger.
    #[serde(deserialize_with = "lists::exactly", default = "full_turn")]
    pub phi: [f64; 2],
    /// From the first angle around the tube up to the second, in degrees from its outermost line
    /// upward.
    #[serde(deserialize_with = "lists::exactly", default = "full_turn")]
    pub theta: [f64; 2],
    /// Whether the normal points into the tube instead.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub inward: bool,
}

#[derive(Debug)]
struct PartTorusShape {
    torus: Torus,
    phi: Angles,
    theta: Angles,
    /// Its bounds, padded by more than the rounding of a hit.
    padded: Aabb,
}

impl Specification for PartTorus {
    fn build(&self, _: &mut Context) -> Result<Arc<dyn Shape>, Invalid> {
        let &Self { swept_radius, tube_radius, inward, .. } = self;
        let torus = Torus { swept_radius, tube_radius, inward };
        torus.check()?;
        let (phi, theta) = (Angles::new("phi", self.phi)?, Angles::new("theta", self.theta)?);
        let padded = bounds(&torus, &phi, &theta).padded();
        Ok(Arc::new(PartTorusShape { torus, phi, theta, padded }))
    }
}

impl PartTorusShape {
    fn hits(&self, ray: &Ray, span: Span) -> impl Iterator<Item = Candidate> {
        self.torus.hits(ray, span, &self.padded, |t, p| {
            self.phi.has_azimuth_of(p) && self.theta.contains(self.section_point(p))
                || nears(self.edge_distances(p), self.size()) && is_rounding(self, ray, t)
        })
    }

    /// The point in the plane of a section, from the middle of the tube.
    fn section_point(&self, p: Vector) -> [f64; 2] {
        [from_axis(p) - self.torus.swept_radius, p.y()]
    }

    /// The distances from both circles and both sections.
    fn edge_distances(&self, p: Vector) -> [f64; 4] {
        let [first, last] = self.theta.end_distances(self.section_point(p));
        let [start, end] = self.phi.meridian_distances(p);
        [first, last, start, end]
    }

    /// The largest number in the test.
    fn size(&self) -> f64 {
        self.torus.swept_radius + self.torus.tube_radius
    }

    fn border(&self, p: Vector) -> Option<Box<Border>> {
        Border::of(self.edge_distances(p), self.size(), || {
            let radial = along(p.across_y());
            let in_section = |[out, up]: [f64; 2]| out * radial + up * Vector::Y;
            let [first, last] = self.theta.away_from_ends().map(in_section);
            let [start, end] = self.phi.away_from_meridians();
            [first, last, start, end]
        })
    }
}

impl Shape for PartTorusShape {
    fn hit(&self, ray: &Ray, span: Span) -> Option<Candidate> {
        self.hits(ray, span).next()
    }

    fn surface(&self, ray: &Ray, at: &Candidate) -> Surface {
        let surface = self.torus.surface_at(ray, at);
        let border = self.border(surface.point.to_vector());
        surface.within(border)
    }

    fn roots(&self, ray: &Ray, span: Span) -> Vec<Candidate> {
        self.hits(ray, span).collect()
    }

    fn bounds(&self) -> Aabb {
        bounds(&self.torus, &self.phi, &self.theta)
    }
}

/// A box around the part.
fn bounds(torus: &Torus, phi: &Angles, theta: &Angles) -> Aabb {
    let (a, b) = (torus.swept_radius, torus.tube_radius);
    let tube = theta.extremes().map(|[cos, sin]| [a + b * cos, b * sin]);
    let [[near, low], [far, high]] = tube;
    let [min, max] = phi.bounds(near, far);
    Aabb { min: Point::new(min.x(), low, min.z()), max: Point::new(max.x(), high, max.z()) }
}
