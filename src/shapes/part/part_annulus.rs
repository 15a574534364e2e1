//! The part annulus (Suffern, ch. 19): the points of a level [`Annulus`](super::Annulus) with azimuth φ
//! between two angles, where `x = ρ sin φ` and `z = ρ cos φ`.
//!
//! A hit of the plane is tested for its distance from the centre and for φ. [`Angles`] tests φ by cross
//! products with both ends; the book computes φ itself and cannot cross φ = 0.

use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::angles::{Angles, full_turn};
use crate::invalid::{Invalid, direction, finite_point};
use crate::math::{Aabb, Length, Normal, Point, Ray, Span, Vector, lists};
use crate::shapes::border::{Border, is_rounding, nears};
use crate::shapes::plain::annulus::{away_from_rims, between, radii, rim_distances};
use crate::shapes::{Candidate, Context, Shape, Specification, Surface, plane_distance};

/// The part of a level annulus within a range of azimuths.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PartAnnulus {
    /// The centre.
    pub center: Point,
    /// Upward or downward, as azimuths are about the y axis; need not be unit.
    #[serde(default = "upward")]
    pub normal: Vector,
    /// The radius of the hole; not negative.
    #[schemars(with = "Length")]
    pub inner_radius: f64,
    /// The outer radius, above `inner_radius`.
    #[schemars(with = "Length")]
    pub outer_radius: f64,
    /// From the first azimuth up to the second, in degrees from +z towards +x, each from −360 to 360;
    /// through 360 where the first is larger.
    #[serde(deserialize_with = "lists::exactly", default = "full_turn")]
    pub phi: [f64; 2],
}

fn upward() -> Vector {
    Vector::Y
}

#[derive(Debug)]
struct PartAnnulusShape {
    center: Point,
    normal: Normal,
    radii: [f64; 2],
    phi: Angles,
}

impl Specification for PartAnnulus {
    fn build(&self, _: &mut Context) -> Result<Arc<dyn Shape>, Invalid> {
        Ok(Arc::new(PartAnnulusShape {
            center: finite_point("center", self.center)?,
            normal: vertical(self.normal)?,
            radii: radii(self.inner_radius, self.outer_radius)?,
            phi: Angles::new("phi", self.phi)?,
        }))
    }
}

/// The field `normal`, if it is along the y axis.
fn vertical(normal: Vector) -> Result<Normal, Invalid> {
    let [x, y, z] = direction("normal", normal)?.to_array();
    if x != 0.0 || z != 0.0 {
        let found = normal.to_array();
        let problem = format!(
            "found {found:?}, but a part annulus is level: [0, 1, 0] or [0, -1, 0]; an instance tilts it"
        );
        return Err(Invalid::field("normal", problem));
    }
    Ok(if y > 0.0 { Normal::Y } else { -Normal::Y })
}

impl PartAnnulusShape {
    /// The distances from both circles and both straight sides.
    fn edge_distances(&self, from_center: Vector) -> [f64; 4] {
        let [outer, inner] = rim_distances(self.radii, from_center);
        let [start, end] = self.phi.meridian_distances(from_center);
        [outer, inner, start, end]
    }

    /// The largest number in the test.
    fn size(&self) -> f64 {
        self.radii[1] + self.center.to_vector().max_abs()
    }
}

impl Shape for PartAnnulusShape {
    fn hit(&self, ray: &Ray, span: Span) -> Option<Candidate> {
        let t = plane_distance(ray, self.center, self.normal);
        if !span.contains(t) {
            return None;
        }
        let from_center = (ray.at(t) - self.center).across_y();
        let within = between(self.radii, from_center) && self.phi.has_azimuth_of(from_center);
        let is_nearly = || nears(self.edge_distances(from_center), self.size());
        (within || is_nearly() && is_rounding(self, ray, t)).then(|| Candidate::at(t))
    }

    fn surface(&self, ray: &Ray, at: &Candidate) -> Surface {
        let surface = Surface::flat(ray.at(at.t), self.center, self.normal);
        let from_center = (surface.point - self.center).across_y();
        surface.within(Border::of(self.edge_distances(from_center), self.size(), || {
            let ([outer, inner], [start, end]) =
                (away_from_rims(from_center), self.phi.away_from_meridians());
            [outer, inner, start, end]
        }))
    }

    fn bounds(&self) -> Aabb {
        let [min, max] = self.phi.bounds(self.radii[0], self.radii[1]);
        Aabb { min: self.center + min, max: self.center + max }
    }
}
