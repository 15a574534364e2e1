//! The part sphere, convex and concave (Suffern, ch. 19): the points of a [`Sphere`] with azimuth φ and
//! polar angle θ between two angles each, where `x = r sin θ sin φ`, `y = r cos θ` and
//! `z = r sin θ cos φ`.
//!
//! Both roots of the sphere are tested in turn. [`Angles`] tests φ by cross products with both ends; the
//! book computes φ itself and cannot cross φ = 0. The book tests `r cos θ_max ≤ y ≤ r cos θ_min`; here θ
//! is tested by `sin(θ − θ_min) ≥ 0` and `sin(θ_max − θ) ≥ 0`, as near the poles y hardly changes with θ.

use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::angles::{Angles, full_turn};
use crate::invalid::Invalid;
use crate::math::{Aabb, Length, Point, Ray, Span, Vector, cos_degrees, lists, sin_degrees};
use crate::shapes::border::{Border, along, is_rounding, nears};
use crate::shapes::{Candidate, Context, Shape, Specification, Sphere, Surface, all_of, first_of};

/// The part of a sphere within a range of azimuths φ and one of polar angles θ.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PartSphere {
    /// The centre.
    pub center: Point,
    /// The radius; positive.
    #[schemars(with = "Length")]
    pub radius: f64,
    /// From the first azimuth up to the second, in degrees from +z towards +x, each from −360 to 360;
    /// through 360 where the first is larger.
    #[serde(deserialize_with = "lists::exactly", default = "full_turn")]
    pub phi: [f64; 2],
    /// From the first polar angle down to the second, in degrees from +y: `[0, 90]` is the upper
    /// hemisphere.
    #[serde(deserialize_with = "lists::exactly", default = "pole_to_pole")]
    pub theta: [f64; 2],
    /// Whether the normal points to the centre: the book's concave part sphere.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub inward: bool,
}

fn pole_to_pole() -> [f64; 2] {
    [0.0, 180.0]
}

#[derive(Debug)]
struct PartSphereShape {
    whole: Sphere,
    phi: Angles,
    /// `(sin θ, cos θ)` of `θ_min` and `θ_max`.
    theta: [[f64; 2]; 2],
}

impl Specification for PartSphere {
    fn build(&self, _: &mut Context) -> Result<Arc<dyn Shape>, Invalid> {
        let Self { center, radius, phi, theta, inward } = *self;
        let whole = Sphere { center, radius, inward }.checked()?;
        let phi = Angles::new("phi", phi)?;
        let [from, to] = theta;
        let ordered = 0.0 <= from && from < to && to <= 180.0;
        if !ordered {
            let problem =
                format!("found {theta:?}, but two ascending angles from 0 to 180 are needed");
            return Err(Invalid::field("theta", problem));
        }
        Ok(Arc::new(PartSphereShape {
            whole,
            phi,
            theta: theta.map(|a| [sin_degrees(a), cos_degrees(a)]),
        }))
    }
}

impl PartSphereShape {
    fn has(&self, ray: &Ray) -> impl Fn(f64) -> bool {
        |t| {
            let v = ray.at(t) - self.whole.center;
            self.contains(v)
                || nears(self.edge_distances(v), self.size()) && is_rounding(self, ray, t)
        }
    }

    fn contains(&self, v: Vector) -> bool {
        let (y, rho) = (v.y(), v.across_y().length());
        let [[s0, c0], [s1, c1]] = self.theta;
        let below_start = rho * c0 - y * s0 >= 0.0; // r sin(θ − θ_min)
        let above_end = y * s1 - rho * c1 >= 0.0; // r sin(θ_max − θ)
        below_start && above_end && self.phi.has_azimuth_of(v)
    }

    /// The distances from the circles at `θ_min` and `θ_max`, infinite for a pole, and from the meridians at
    /// the ends of φ.
    fn edge_distances(&self, v: Vector) -> [f64; 4] {
        let (y, rho) = (v.y(), v.across_y().length());
        let [[s0, c0], [s1, c1]] = self.theta;
        let upper = if s0 > 0.0 { rho * c0 - y * s0 } else { f64::INFINITY };
        let lower = if s1 > 0.0 { y * s1 - rho * c1 } else { f64::INFINITY };
        let [start, end] = self.phi.meridian_distances(v);
        [upper, lower, start, end]
    }

    /// The largest number in the test.
    fn size(&self) -> f64 {
        self.whole.radius + self.whole.center.to_vector().max_abs()
    }

    fn border(&self, v: Vector) -> Option<Box<Border>> {
        Border::of(self.edge_distances(v), self.size(), || {
            let level = v.across_y();
            let down = along(v.y() * along(level) - level.length() * Vector::Y);
            let [start, end] = self.phi.away_from_meridians();
            [down, -down, start, end]
        })
    }
}

impl Shape for PartSphereShape {
    fn hit(&self, ray: &Ray, span: Span) -> Option<Candidate> {
        first_of(self.whole.distances(ray)?, span, self.has(ray))
    }

    fn surface(&self, ray: &Ray, at: &Candidate) -> Surface {
        let surface = self.whole.surface(ray, at);
        let border = self.border(surface.point - self.whole.center);
        surface.within(border)
    }

    fn roots(&self, ray: &Ray, span: Span) -> Vec<Candidate> {
        all_of(self.whole.distances(ray), span, self.has(ray))
    }

    fn bounds(&self) -> Aabb {
        let [[s0, c0], [s1, c1]] = self.theta;
        let r = self.whole.radius;
        let across_equator = c0 >= 0.0 && c1 <= 0.0;
        let far = if across_equator { r } else { r * s0.max(s1) };
        let [min, max] = self.phi.bounds(r * s0.min(s1), far);
        let center = self.whole.center;
        Aabb { min: center + min + r * c1 * Vector::Y, max: center + max + r * c0 * Vector::Y }
    }
}
