//! The annulus (Suffern, ch. 19), a disk with a hole: the points `p` of the plane through `c` with the
//! normal `n` for which `r_in² ≤ |p − c|² ≤ r_out²`.
//!
//! A ray meets the plane at `t = (c − o)·n / d·n`, and then the point is tested, as in the book.
//!
//! The book's own routine: `src/shapes/textbook/annulus.rs`.

use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::invalid::{Invalid, direction, finite_point, length, not_negative, shown};
use crate::math::{Aabb, Length, Normal, Point, Ray, Span, Vector};
use crate::shapes::border::{Border, along, is_rounding, nears};
use crate::shapes::{Candidate, Context, Shape, Specification, Surface, plane_distance};

/// The points of a plane from `inner_radius` to `outer_radius` away from `center`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Annulus {
    /// The centre.
    pub center: Point,
    /// Perpendicular to the annulus; not zero, need not be unit.
    pub normal: Vector,
    /// The radius of the hole; not negative.
    #[schemars(with = "Length")]
    pub inner_radius: f64,
    /// The outer radius, above `inner_radius`.
    #[schemars(with = "Length")]
    pub outer_radius: f64,
}

#[derive(Debug)]
struct AnnulusShape {
    center: Point,
    normal: Normal,
    radii: [f64; 2],
}

impl Specification for Annulus {
    fn build(&self, _: &mut Context) -> Result<Arc<dyn Shape>, Invalid> {
        Ok(Arc::new(AnnulusShape {
            center: finite_point("center", self.center)?,
            normal: direction("normal", self.normal)?,
            radii: radii(self.inner_radius, self.outer_radius)?,
        }))
    }
}

/// The fields `inner_radius` and `outer_radius`, if they are in order.
pub fn radii(inner: f64, outer: f64) -> Result<[f64; 2], Invalid> {
    not_negative("inner_radius", inner)?;
    length("outer_radius", outer)?;
    if inner >= outer {
        let (inner, outer) = (shown(inner), shown(outer));
        let problem = format!("found {outer}, but it must be above inner_radius, {inner}");
        return Err(Invalid::field("outer_radius", problem));
    }
    Ok([inner, outer])
}

/// Whether `r_in² ≤ |p − c|² ≤ r_out²`.
pub fn between([inner, outer]: [f64; 2], from_center: Vector) -> bool {
    (inner * inner..=outer * outer).contains(&from_center.length_squared())
}

/// The distances from both circles, for [`Border::of`]; a hole of radius 0 is none.
pub fn rim_distances([inner, outer]: [f64; 2], from_center: Vector) -> [f64; 2] {
    let rho = from_center.length();
    [outer - rho, if inner > 0.0 { rho - inner } else { f64::INFINITY }]
}

/// The directions away from them.
pub fn away_from_rims(from_center: Vector) -> [Vector; 2] {
    let radial = along(from_center);
    [-radial, radial]
}

impl AnnulusShape {
    /// The largest number in the test.
    fn size(&self) -> f64 {
        self.radii[1] + self.center.to_vector().max_abs()
    }
}

impl Shape for AnnulusShape {
    fn hit(&self, ray: &Ray, span: Span) -> Option<Candidate> {
        let t = plane_distance(ray, self.center, self.normal);
        if !span.contains(t) {
            return None;
        }
        let from_center = ray.at(t) - self.center;
        let is_nearly = || nears(rim_distances(self.radii, from_center), self.size());
        let within = between(self.radii, from_center) || is_nearly() && is_rounding(self, ray, t);
        within.then(|| Candidate::at(t))
    }

    fn surface(&self, ray: &Ray, at: &Candidate) -> Surface {
        let surface = Surface::flat(ray.at(at.t), self.center, self.normal);
        let from_center = surface.point - self.center;
        let distances = rim_distances(self.radii, from_center);
        surface.within(Border::of(distances, self.size(), || away_from_rims(from_center)))
    }

    fn bounds(&self) -> Aabb {
        // the annulus extends r sin θ along an axis at the angle θ to the normal
        let [x, y, z] = self.normal.to_array();
        let sine = |a: f64, b: f64| (a * a + b * b).sqrt();
        let half = self.radii[1] * Vector::new(sine(y, z), sine(z, x), sine(x, y));
        Aabb { min: self.center - half, max: self.center + half }
    }
}
