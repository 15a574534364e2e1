//! The lattice: copies of one shape in rows, columns and layers, as in the grids of instances of
//! Suffern, ch. 22 and 23.
//!
//! Copy (i, j, k) is moved by `v = (i s_x, j s_y, k s_z)`. A ray meets it where the ray from
//! `o − v` with the same direction meets the shape, so copies need no matrices.

use std::sync::Arc;

use super::instance::surface_seen_through;
use crate::accel::{Accel, Method};
use crate::invalid::Invalid;
use crate::math::{Aabb, Displacement, Point, Ray, Span, Transform, UNIT_ROUNDOFF, Vector};
use crate::shapes::{
    Candidate, Context, Kind, Made, Role, Shape, Specification, Surface, Within, made,
};

/// Copies of a shape, moved by `(i, j, k)` times `spacing` with `0 ≤ i, j, k <` the counts. All
/// share what is copied, so that a lattice of lattices can hold more copies than there are atoms.
#[kind]
pub struct Lattice {
    /// What is copied; the first copy stands where it is.
    pub of: Box<Kind>,
    /// How many copies there are along x, y and z, each at least 1.
    pub counts: [u32; 3],
    /// How far it is from one copy to the next along x, y and z.
    pub spacing: Displacement,
    /// How rays find the copies; as the scene if left out.
    pub accel: Option<Method>,
}

#[derive(Debug)]
struct Places {
    counts: [u32; 3],
    spacing: Vector,
}

#[derive(Debug)]
struct LatticeShape {
    shape: Arc<dyn Shape>,
    leaves: u64,
    places: Places,
    accel: Accel,
    bounds: Aabb,
}

impl Specification for Lattice {
    fn make(&self, context: &mut Context) -> Made {
        if self.counts.contains(&0) {
            let problem = format!("found {:?}, but each must be at least 1", self.counts);
            return Err(Invalid::field("counts", problem));
        }
        let copies = self.counts.iter().fold(1_u64, |n, &count| n.saturating_mul(count.into()));
        context.take_parts(copies).map_err(|e| e.inside("counts"))?;
        let shape = context.nested(|context| self.of.build(context)).map_err(|e| e.inside("of"))?;
        if !shape.bounds().is_bounded() {
            return Err(Invalid::field("of", "an unbounded shape cannot be copied side by side"));
        }
        let leaves = shape.leaves();
        if leaves.checked_mul(copies).is_none() {
            let problem = "more than 2⁶⁴ shapes are nested here; leave out a level";
            return Err(Invalid::field("counts", problem));
        }
        let places = Places { counts: self.counts, spacing: self.spacing };
        let inner = shape.bounds();
        let copies = 0..copies as u32;
        let bounds: Vec<Aabb> = copies.map(|copy| places.bounds(copy, &inner)).collect();
        made(LatticeShape {
            accel: Accel::build(self.accel.unwrap_or(context.accel()), &bounds),
            bounds: bounds.into_iter().fold(Aabb::EMPTY, Aabb::union),
            shape,
            leaves,
            places,
        })
    }
}

impl Places {
    /// Where in the lattice the copy of this number is; the first index runs fastest.
    fn indices(&self, copy: u32) -> [u32; 3] {
        let [columns, rows, _] = self.counts;
        [copy % columns, copy / columns % rows, copy / columns / rows]
    }

    /// By how much the copy of this number is moved.
    fn shift(&self, copy: u32) -> Vector {
        let [i, j, k] = self.indices(copy).map(f64::from);
        let [x, y, z] = self.spacing.to_array();
        Vector::new(i * x, j * y, k * z)
    }

    /// The ray that meets the first copy as this ray meets the given one.
    fn ray_back(&self, copy: u32, ray: &Ray) -> Ray {
        Ray::new(ray.origin - self.shift(copy), ray.direction)
    }

    /// What [`super::instance::bounds_seen_through`] says of a translation, in a tenth of its time:
    /// the sizes of both corners' coordinates, here and there, bound the roundings.
    fn bounds(&self, copy: u32, inner: &Aabb) -> Aabb {
        let shift = self.shift(copy);
        let sizes = |corner: Point| {
            let there = (corner + shift).to_vector();
            corner.to_vector().abs() + shift.abs() + (there.abs() + shift.abs())
        };
        let pad = 16.0 * UNIT_ROUNDOFF * sizes(inner.min).max(sizes(inner.max));
        Aabb { min: inner.min + shift - pad, max: inner.max + shift + pad }
    }

    fn number(&self) -> u32 {
        self.counts.iter().product()
    }
}

impl LatticeShape {
    /// The number of the copy that is hit, and the same hit of the first copy.
    fn copy(&self, at: &Candidate) -> (u32, Candidate) {
        let (copy, leaf) = (at.leaf / self.leaves, at.leaf % self.leaves);
        (copy as u32, Candidate { leaf, ..*at })
    }
}

impl Shape for LatticeShape {
    fn hit(&self, ray: &Ray, span: Span) -> Option<Candidate> {
        let (copy, at) = self.accel.nearest(ray, span, &mut (), |copy, span| {
            self.shape.hit(&self.places.ray_back(copy, ray), span)
        })?;
        Some(Candidate { leaf: u64::from(copy) * self.leaves + at.leaf, ..at })
    }

    fn shadow_hit(&self, ray: &Ray, span: Span) -> Option<f64> {
        let copy = |copy| self.shape.shadow_hit(&self.places.ray_back(copy, ray), span);
        self.accel.any(ray, span, &mut (), copy).map(|(_, t)| t)
    }

    fn surface(&self, ray: &Ray, at: &Candidate) -> Surface {
        let (copy, within) = self.copy(at);
        let place = Transform::translation(self.places.shift(copy));
        surface_seen_through(&place, &*self.shape, ray, &within)
    }

    fn within(&self, at: &Candidate) -> Within<'_> {
        let (copy, within) = self.copy(at);
        let role = Role::Copy(self.places.indices(copy), self.places.shift(copy));
        Within::Nested(&*self.shape, within, role)
    }

    fn material_without_uv(&self, own: u32, needs_uv: &dyn Fn(u32) -> bool) -> Option<u32> {
        self.shape.material_without_uv(own, needs_uv)
    }

    fn roots(&self, ray: &Ray, span: Span) -> Vec<Candidate> {
        let mut roots = Vec::new();
        for copy in 0..self.places.number() {
            let within = self.shape.roots(&self.places.ray_back(copy, ray), span).into_iter();
            let first = u64::from(copy) * self.leaves;
            roots.extend(within.map(|at| Candidate { leaf: first + at.leaf, ..at }));
        }
        roots.sort_by(|a, b| a.t.total_cmp(&b.t));
        roots
    }

    fn bounds(&self) -> Aabb {
        self.bounds
    }

    fn leaves(&self) -> u64 {
        u64::from(self.places.number()) * self.leaves
    }
}
