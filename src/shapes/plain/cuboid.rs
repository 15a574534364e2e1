//! The box with faces along the axes (Suffern, ch. 19): the intersection of three slabs.
//!
//! Along each axis a ray is in the slab from `(min − o)/d` to `(max − o)/d`, swapped if d < 0. It
//! enters the box at the largest of the first and leaves it at the smallest of the second, if they
//! are in this order. The book multiplies by `1/d`; here the differences are divided, as a quotient
//! is monotone: a segment that ends in front of a face does not reach it by rounding.
//!
//! The book's own routine: `src/shapes/textbook/cuboid.rs`.

use std::sync::Arc;

use crate::invalid::Invalid;
use crate::math::{Aabb, Normal, Point, Ray, Span, UNIT_ROUNDOFF, Vector};
use crate::shapes::border::Border;
use crate::shapes::{
    Candidate, Context, Face, Made, Shape, Specification, Surface, Within, made, textbook,
};

/// The surface of the box between two corners; normals point outward.
#[kind(PartialEq)]
pub struct Cuboid {
    /// The corner with the smallest coordinates.
    pub min: Point,
    /// The corner with the largest coordinates, each above that of `min`.
    pub max: Point,
}

impl Specification for Cuboid {
    fn make(&self, _: &mut Context) -> Made {
        let Self { min, max } = *self;
        if (0..3).any(|axis| min.along(axis) >= max.along(axis)) {
            let (min, max) = (min.to_array(), max.to_array());
            return Err(Invalid::field(
                "max",
                format!("found {max:?}, but each coordinate must be above that of min, {min:?}"),
            ));
        }
        made(self.clone())
    }
}

impl Cuboid {
    /// Where the line enters and leaves each of the three slabs. For a ray in the plane of a face
    /// one is NaN, from `0/0`; [`Cuboid::within`] takes it to be inside that slab.
    fn slabs(&self, ray: &Ray) -> [[f64; 3]; 2] {
        let slab = |axis: usize| {
            let (o, d) = (ray.origin.along(axis), ray.direction.along(axis));
            let low = (self.min.along(axis) - o) / d;
            let high = (self.max.along(axis) - o) / d;
            if d.is_sign_negative() { (high, low) } else { (low, high) }
        };
        let (x, y, z) = (slab(0), slab(1), slab(2));
        [[x.0, y.0, z.0], [x.1, y.1, z.1]]
    }

    /// The part of the line that is in all slabs.
    fn within([enter, leave]: &[[f64; 3]; 2]) -> Option<[f64; 2]> {
        let (mut first, mut last) = (f64::NEG_INFINITY, f64::INFINITY);
        for (&enter, &leave) in enter.iter().zip(leave) {
            first = if enter > first { enter } else { first };
            last = if leave < last { leave } else { last };
        }
        (first <= last).then_some([first, last])
    }

    /// Where the line enters and leaves the box.
    pub(in crate::shapes) fn chord(&self, ray: &Ray) -> Option<[f64; 2]> {
        Self::within(&self.slabs(ray))
    }

    /// The hit at `t`, where the line enters one of these slabs, or leaves it if `far`. Faces are
    /// numbered `2·axis`, and one more on the side of `max`.
    fn face(slabs: &[f64; 3], t: f64, far: bool, ray: &Ray) -> Candidate {
        let axis = if slabs[0] == t { 0 } else { 2 - usize::from(slabs[1] == t) };
        let is_max = far != ray.direction.along(axis).is_sign_negative();
        Candidate { part: 2 * axis as u32 + u32::from(is_max), ..Candidate::at(t) }
    }
}

impl Shape for Cuboid {
    fn hit(&self, ray: &Ray, span: Span) -> Option<Candidate> {
        let slabs = self.slabs(ray);
        let [first, last] = Self::within(&slabs)?;
        if span.contains(first) {
            return Some(Self::face(&slabs[0], first, false, ray));
        }
        span.contains(last).then(|| Self::face(&slabs[1], last, true, ray))
    }

    fn surface(&self, ray: &Ray, at: &Candidate) -> Surface {
        let axis = at.part as usize / 2;
        let outward = [Normal::X, Normal::Y, Normal::Z][axis];
        let (face, normal) = match at.part % 2 {
            0 => (self.min.along(axis), -outward),
            _ => (self.max.along(axis), outward),
        };
        let point = ray.at(at.t).with(axis, face);
        let [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
        let from_min = |axis| point.along(axis) - self.min.along(axis);
        let from_max = |axis| self.max.along(axis) - point.along(axis);
        let size = self.min.to_vector().max_abs().max(self.max.to_vector().max_abs());
        let border = Border::of([from_min(u), from_max(u), from_min(v), from_max(v)], size, || {
            let [u, v] = [u, v].map(|axis| [Vector::X, Vector::Y, Vector::Z][axis]);
            [u, -u, v, -v]
        });
        Surface::new(point, 4.0 * UNIT_ROUNDOFF * face.abs(), normal).within(border)
    }

    fn within(&self, at: &Candidate) -> Within<'_> {
        let faces = [Face::MinX, Face::MaxX, Face::MinY, Face::MaxY, Face::MinZ, Face::MaxZ];
        Within::Face(faces[at.part as usize])
    }

    fn roots(&self, ray: &Ray, span: Span) -> Vec<Candidate> {
        let slabs = self.slabs(ray);
        let Some([first, last]) = Self::within(&slabs) else { return Vec::new() };
        let mut faces =
            vec![Self::face(&slabs[0], first, false, ray), Self::face(&slabs[1], last, true, ray)];
        faces.retain(|face| span.contains(face.t));
        faces
    }

    fn bounds(&self) -> Aabb {
        Aabb { min: self.min, max: self.max }
    }

    fn textbook(&self, epsilon: f64) -> Option<Arc<dyn Shape>> {
        textbook::form(self.clone(), self.clone(), epsilon)
    }
}
