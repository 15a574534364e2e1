//! The box with faces along the axes (Suffern, ch. 19).

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::{Candidate, Context, Shape, Surface};
use crate::invalid::{Invalid, finite_point};
use crate::kinds::Specification;
use crate::math::{Aabb, Normal, Point, Ray, Span, UNIT_ROUNDOFF};

/// The surface of the box between two corners; normals point outward.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Box {
    /// The corner with the smallest coordinates.
    pub min: Point,
    /// The corner with the largest coordinates, each above that of `min`.
    pub max: Point,
}

impl Specification for Box {
    type Built = Arc<dyn Shape>;
    type Context = Context;

    fn build(&self, _: &mut Context) -> Result<Arc<dyn Shape>, Invalid> {
        let (min, max) = (finite_point("min", self.min)?, finite_point("max", self.max)?);
        if (0..3).any(|axis| min.along(axis) >= max.along(axis)) {
            let (min, max) = (min.to_array(), max.to_array());
            return Err(Invalid::field(
                "max",
                format!("found {max:?}, but each coordinate must be above that of min, {min:?}"),
            ));
        }
        Ok(Arc::new(self.clone()))
    }

    fn scaled(&self, factor: f64) -> Self {
        Self { min: self.min.scaled(factor), max: self.max.scaled(factor) }
    }

    fn specimens() -> Vec<Self> {
        vec![
            Self { min: Point::new(-1.0, -1.0, -1.0), max: Point::new(1.0, 1.0, 1.0) },
            Self { min: Point::new(-0.5, 0.25, -2.0), max: Point::new(1.5, 0.5, -1.0) },
        ]
    }
}

impl Box {
    /// Where the ray enters and leaves the three slabs; faces are numbered `2·axis`, and one more
    /// on the side of `max`. A ray in the plane of a face (0/0) is inside that slab.
    pub(super) fn faces(&self, ray: &Ray) -> Option<[Candidate; 2]> {
        let mut entry = Candidate::at(f64::NEG_INFINITY);
        let mut exit = Candidate::at(f64::INFINITY);
        for axis in 0..3 {
            let (o, d) = (ray.origin.along(axis), ray.direction.along(axis));
            let low = Candidate {
                part: 2 * axis as u32,
                ..Candidate::at((self.min.along(axis) - o) / d)
            };
            let high = Candidate {
                part: 2 * axis as u32 + 1,
                ..Candidate::at((self.max.along(axis) - o) / d)
            };
            let (near, far) = if d.is_sign_negative() { (high, low) } else { (low, high) };
            if near.t > entry.t {
                entry = near;
            }
            if far.t < exit.t {
                exit = far;
            }
        }
        (entry.t <= exit.t).then_some([entry, exit])
    }
}

impl Shape for Box {
    fn hit(&self, ray: &Ray, span: Span) -> Option<Candidate> {
        self.faces(ray)?.into_iter().find(|face| span.contains(face.t))
    }

    fn surface(&self, ray: &Ray, at: &Candidate) -> Surface {
        let axis = at.part as usize / 2;
        let outward = [Normal::X, Normal::Y, Normal::Z][axis];
        let (face, normal) = match at.part % 2 {
            0 => (self.min.along(axis), -outward),
            _ => (self.max.along(axis), outward),
        };
        let point = ray.at(at.t).with(axis, face);
        Surface::new(point, 4.0 * UNIT_ROUNDOFF * face.abs(), normal)
    }

    fn roots(&self, ray: &Ray, span: Span) -> Vec<Candidate> {
        let faces = self.faces(ray).into_iter().flatten();
        faces.filter(|face| span.contains(face.t)).collect()
    }

    fn bounds(&self) -> Aabb {
        Aabb { min: self.min, max: self.max }
    }
}
