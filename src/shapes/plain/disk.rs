//! The disk (Suffern, ch. 19): the points `p` of the plane through `c` with the normal `n` for which
//! `|p − c|² ≤ r²`.
//!
//! A ray meets the plane at `t = (c − o)·n / d·n`, and then the point is tested, as in the book.
//!
//! The book's own routine: `src/shapes/textbook/disk.rs`.

use std::f64::consts::PI;
use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::invalid::{Invalid, direction, finite_point, length};
use crate::math::{Aabb, Frame, Length, Normal, Point, Ray, Span, Vector, maps};
use crate::shapes::border::{Border, along, is_rounding, nears};
use crate::shapes::sampled::{ByArea, EvenSurface};
use crate::shapes::{
    Candidate, Context, SampledSurface, Sampling, Shape, Specification, Surface, plane_distance,
};

/// The points of a plane within `radius` of `center`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Disk {
    /// The centre.
    pub center: Point,
    /// Perpendicular to the disk; not zero, need not be unit.
    pub normal: Vector,
    /// The radius; positive.
    #[schemars(with = "Length")]
    pub radius: f64,
}

#[derive(Clone, Debug)]
struct DiskShape {
    center: Point,
    normal: Normal,
    radius: f64,
}

impl Specification for Disk {
    fn build(&self, _: &mut Context) -> Result<Arc<dyn Shape>, Invalid> {
        Ok(Arc::new(DiskShape {
            center: finite_point("center", self.center)?,
            normal: direction("normal", self.normal)?,
            radius: length("radius", self.radius)?,
        }))
    }
}

impl DiskShape {
    /// The largest number in the test.
    fn size(&self) -> f64 {
        self.radius + self.center.to_vector().max_abs()
    }

    fn nears_rim(&self, from_center: Vector) -> bool {
        nears([self.radius - from_center.length()], self.size())
    }
}

impl Shape for DiskShape {
    fn hit(&self, ray: &Ray, span: Span) -> Option<Candidate> {
        let t = plane_distance(ray, self.center, self.normal);
        if !span.contains(t) {
            return None;
        }
        let from_center = ray.at(t) - self.center;
        let within = from_center.length_squared() <= self.radius * self.radius;
        (within || self.nears_rim(from_center) && is_rounding(self, ray, t))
            .then(|| Candidate::at(t))
    }

    fn surface(&self, ray: &Ray, at: &Candidate) -> Surface {
        let surface = Surface::flat(ray.at(at.t), self.center, self.normal);
        let from_center = surface.point - self.center;
        let border =
            Border::of([self.radius - from_center.length()], self.size(), || [-along(from_center)]);
        surface.within(border)
    }

    fn sampled(&self, sampling: Sampling) -> Option<Box<dyn SampledSurface>> {
        (sampling == Sampling::Area).then(|| Box::new(ByArea(self.clone())) as _)
    }

    fn bounds(&self) -> Aabb {
        // the disk extends r sin θ along an axis at the angle θ to the normal
        let [x, y, z] = self.normal.to_array();
        let sine = |a: f64, b: f64| (a * a + b * b).sqrt();
        let half = self.radius * Vector::new(sine(y, z), sine(z, x), sine(x, y));
        Aabb { min: self.center - half, max: self.center + half }
    }
}

impl EvenSurface for DiskShape {
    fn area(&self) -> f64 {
        PI * self.radius * self.radius
    }

    fn point(&self, u: [f64; 2]) -> Surface {
        let [x, y] = maps::disk(u);
        let from_center = Frame::around(self.normal).to_world(Vector::new(x, y, 0.0));
        Surface::flat(self.center + self.radius * from_center, self.center, self.normal)
    }
}
