//! The part annulus (Suffern, ch. 19).

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::annulus::{between, radii};
use super::azimuth::{Azimuth, full_turn};
use super::{Candidate, Context, Shape, Surface, plane_distance};
use crate::invalid::{Invalid, finite_point};
use crate::kinds::Specification;
use crate::math::{Aabb, Normal, Point, Ray, Span};

/// The part of a level annulus within a range of azimuths.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PartAnnulus {
    /// The centre.
    pub center: Point,
    /// The radius of the hole; not negative.
    pub inner_radius: f64,
    /// Above `inner_radius`.
    pub outer_radius: f64,
    /// From the first azimuth up to the second, in degrees from +z towards +x.
    #[serde(default = "full_turn")]
    pub phi: [f64; 2],
    /// Whether the normal is (0, −1, 0) and not (0, 1, 0).
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub down: bool,
}

#[derive(Debug)]
struct Built {
    center: Point,
    normal: Normal,
    radii: [f64; 2],
    phi: Azimuth,
}

impl Specification for PartAnnulus {
    type Built = Arc<dyn Shape>;
    type Context = Context;

    fn build(&self, _: &mut Context) -> Result<Arc<dyn Shape>, Invalid> {
        Ok(Arc::new(Built {
            center: finite_point("center", self.center)?,
            normal: if self.down { -Normal::Y } else { Normal::Y },
            radii: radii(self.inner_radius, self.outer_radius)?,
            phi: Azimuth::new("phi", self.phi)?,
        }))
    }

    fn scaled(&self, factor: f64) -> Self {
        Self {
            center: self.center.scaled(factor),
            inner_radius: factor * self.inner_radius,
            outer_radius: factor * self.outer_radius,
            ..*self
        }
    }

    fn specimens() -> Vec<Self> {
        let part = |center, radii: [f64; 2], phi, down| Self {
            center,
            inner_radius: radii[0],
            outer_radius: radii[1],
            phi,
            down,
        };
        vec![
            part(Point::ORIGIN, [0.5, 1.0], [0.0, 90.0], false),
            part(Point::new(0.5, -0.25, 1.0), [0.0, 0.75], [300.0, 130.0], true),
        ]
    }
}

impl Shape for Built {
    fn hit(&self, ray: &Ray, span: Span) -> Option<Candidate> {
        let t = plane_distance(ray, self.center, self.normal);
        if !span.contains(t) {
            return None;
        }
        let from_center = (ray.at(t) - self.center).across_y();
        let hit = between(self.radii, from_center) && self.phi.contains(from_center);
        hit.then(|| Candidate::at(t))
    }

    fn surface(&self, ray: &Ray, at: &Candidate) -> Surface {
        Surface::flat(ray.at(at.t), self.center, self.normal)
    }

    fn bounds(&self) -> Aabb {
        let [min, max] = self.phi.bounds(self.radii[0], self.radii[1]);
        Aabb { min: self.center + min, max: self.center + max }
    }
}
