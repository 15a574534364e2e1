//! Shapes: what a ray can hit (Suffern, ch. 3, 19, 21, 23).
//!
//! A hit is found in two steps. [`Shape::hit`] returns a small [`Candidate`]; for the nearest one
//! of all objects, [`Shape::surface`] then computes point, error bound and normals, once. The
//! book's `hit` does both at a time, and its callers keep the record of the nearest.
//!
//! Each kind is a file with its plain data (as in a scene), the check that builds it, and its
//! `Shape`. Its header states the equation and the formula that `hit` solves, in the book's
//! letters: `o` and `d` are the ray's origin and direction. Its entry in the list at the end gives
//! it its tag in scene files and enrols it in the contract tests.

use std::fmt::Debug;
use std::sync::Arc;

pub use crate::candidate::Candidate;
use crate::invalid::{Invalid, LENGTHS, lengths, shown};
use crate::math::{Aabb, Normal, Point, Ray, Span, UNIT_ROUNDOFF, Vector};

/// The surface at a hit.
#[derive(Clone, Debug, PartialEq)]
pub struct Surface {
    /// The point, moved onto the surface: closer to it than `ray.at(t)`.
    pub point: Point,
    /// Bound on the distance, along the geometric normal, between `point` and the surface that
    /// `hit` finds: a ray that starts farther off than this does not hit the same point again. (A
    /// ray may leave a body thinner than a few of these by its far wall: see `docs/accuracy.md`.)
    pub error: f64,
    /// Perpendicular to the surface; outward for a closed shape, unless its data have `inward`.
    /// Never turned to the viewer.
    pub normal: Normal,
    /// The normal that shading uses; differs from `normal` on smooth meshes only.
    pub shading: Normal,
    /// The point in the coordinates of the innermost shape, where textures live.
    pub local: Point,
    /// Where the point is relative to the border of its part, if that is near. Boxed, because few
    /// hits are near one and every hit is copied.
    pub border: Option<Box<Border>>,
    /// The material of that part of a compound, by its index in the scene; the object's own if
    /// `None`.
    pub material: Option<u32>,
}

impl Surface {
    /// A surface with one normal, in its own coordinates.
    pub fn new(point: Point, error: f64, normal: Normal) -> Self {
        let (shading, local) = (normal, point);
        Self { point, error, normal, shading, local, border: None, material: None }
    }

    /// The same surface, on a part that has this border.
    #[inline]
    fn within(self, border: Option<Box<Border>>) -> Self {
        let along = |mut border: Box<Border>| {
            *border = border.along(self.normal);
            border
        };
        Self { border: border.map(along), ..self }
    }

    /// The same surface, its normals turned round if it is an inward one.
    fn turned(self, inward: bool) -> Self {
        if !inward {
            return self;
        }
        Self { normal: -self.normal, shading: -self.shading, ..self }
    }

    /// A plane through `anchor`, hit near `point`, which is moved onto it.
    #[inline]
    pub fn flat(point: Point, anchor: Point, normal: Normal) -> Self {
        let off = (point - anchor).dot(normal);
        let point = point - off * normal;
        // the rounding of a sum of three products of differences is γ₅ of the magnitudes, here doubled;
        // that of the step to the plane counts where the point is almost zero
        let magnitude = point.to_vector().abs() + anchor.to_vector().abs();
        let error = 10.0 * UNIT_ROUNDOFF * (magnitude.dot(Vector::from(normal).abs()) + off.abs());
        Self::new(point, error, normal)
    }

    /// Whether a ray in this direction meets the side the normal points to.
    pub fn is_front(&self, direction: Vector) -> bool {
        self.normal.dot(direction) <= 0.0
    }

    /// Where a ray that leaves in this direction starts: off the surface by three error bounds, on
    /// the side it leaves to, and not nearer to the border of its part than rounding can tell.
    /// There is no constant epsilon: see Pharr, Jakob & Humphreys, *PBRT*, "Managing rounding
    /// error".
    pub fn leave(&self, direction: Vector) -> Point {
        let side = 3.0_f64.copysign(self.normal.dot(direction));
        let inside = match &self.border {
            None => self.point,
            Some(border) => border.moved_inside(self.point),
        };
        inside + (side * self.error) * self.normal
    }
}

/// Something a ray can hit.
///
/// `t` depends on the ray and the shape alone, never on the span: accelerators rely on it to give
/// the same bits as the list. Contract: `tests/contracts/shape.rs`.
pub trait Shape: Debug + Send + Sync {
    /// The nearest hit inside the span.
    fn hit(&self, ray: &Ray, span: Span) -> Option<Candidate>;

    /// Some hit inside the span, for shadows: its `t`. Any will do, and the first found may be
    /// cheaper than the nearest.
    fn shadow_hit(&self, ray: &Ray, span: Span) -> Option<f64> {
        self.hit(ray, span).map(|candidate| candidate.t)
    }

    /// Everything about the surface at a hit of this ray.
    fn surface(&self, ray: &Ray, at: &Candidate) -> Surface;

    /// Every hit inside the span in ascending order; a double root counts once or twice. The
    /// default serves shapes that a line meets at most once.
    fn roots(&self, ray: &Ray, span: Span) -> Vec<Candidate> {
        self.hit(ray, span).into_iter().collect()
    }

    /// What of the shape is hit: a shape nested in it, or a part of its own. Called only where a
    /// texture or an explanation needs it.
    fn within(&self, _: &Candidate) -> Within<'_> {
        Within::Whole
    }

    /// A material (its index in the scene) that needs texture coordinates where the shape has none,
    /// if there is one. `own` is the material of parts that name none. Called once, when a world is
    /// built.
    fn material_without_uv(&self, own: u32, needs_uv: &dyn Fn(u32) -> bool) -> Option<u32> {
        needs_uv(own).then_some(own)
    }

    /// The surface as one on which points are drawn in this way, for area lights; `None` if that
    /// cannot be done. Called once, when a light is built.
    fn sampled(&self, _: Sampling) -> Option<std::boxed::Box<dyn SampledSurface>> {
        None
    }

    /// A box that contains every point of the surface.
    fn bounds(&self) -> Aabb;

    /// How many shapes are nested in it, itself included: one more than the largest
    /// [`Candidate::leaf`].
    fn leaves(&self) -> u64 {
        1
    }

    /// The surface without edges of which the shape is a part, and what it is called: the plane of
    /// a disk.
    fn whole(&self) -> Option<(&'static str, Arc<dyn Shape>)> {
        None
    }

    /// The shape as the book hits it, beyond epsilon; `None` if the book has no routine for it, or
    /// if it is made of parts that have theirs.
    fn textbook(&self, _epsilon: f64) -> Option<Arc<dyn Shape>> {
        None
    }
}

/// The normal along `v`. If `v` is zero or not finite, as for extreme lengths, it faces the ray.
fn normal_along(v: Vector, ray: &Ray) -> Normal {
    Normal::new(v).or_else(|| Normal::new(-ray.direction)).unwrap_or(Normal::Y)
}

// shared by the kinds
mod border;
mod context;
mod facet;
mod sampled;
pub mod textbook;
mod trimmed;
mod within;

mod composite;
mod meshes;
mod part;
mod plain;
mod solid;

use composite::*;
use meshes::*;
use part::*;
use plain::*;
use solid::*;

pub use border::Border;
pub use composite::assembly::Materials;
pub use composite::compound::Part;
pub use composite::part_path::{Face, Level, PartPath};
pub use context::{Context, PartMaterial};
pub use facet::Facet;
pub use plain::algebraic::Term;
pub use sampled::{SampledSurface, Sampling};
pub use solid::boundaries::BoundaryMaterials;
pub use within::{Role, Within};

pub use composite::instance::transform_of;
pub use meshes::triangle_mesh::{AcceleratedMesh, TriangleMesh};

crate::kinds! {
    /// The surface of an object. Lengths are in the unit of the scene.
    Kind builds dyn Shape with Context, finished by finished;
    ch03 plane::Plane,
    ch03 sphere::Sphere,
    ch19 cuboid::Cuboid as "box",
    ch19 triangle::Triangle,
    ch19 rectangle::Rectangle,
    ch19 disk::Disk,
    ch19 annulus::Annulus,
    ch19 open_cylinder::OpenCylinder,
    ch19 compound::Compound,
    ch19 solid_cylinder::SolidCylinder,
    ch19 solid_cone::SolidCone,
    ch19 thick_ring::ThickRing,
    ch19 flat_rimmed_bowl::FlatRimmedBowl,
    ch19 round_rimmed_bowl::RoundRimmedBowl,
    ch19 concave_lens::ConcaveLens,
    ch19 cut_face::CutFace,
    ch19 cone::Cone,
    ch19 paraboloid::Paraboloid,
    ch19 part_sphere::PartSphere,
    ch19 part_cylinder::PartCylinder,
    ch19 part_annulus::PartAnnulus,
    ch19 torus::Torus,
    ch19 part_torus::PartTorus,
    ch19 algebraic::Algebraic,
    ch21 instance::Instance,
    ch21 beveled_box::BeveledBox,
    ch21 beveled_cylinder::BeveledCylinder,
    ch21 beveled_ring::BeveledRing,
    ch21 beveled_wedge::BeveledWedge,
    ch21 rosette::Rosette,
    ch21 archway::Archway,
    ch22 random_spheres::RandomSpheres,
    ch22 lattice::Lattice,
    ch23 mesh::Mesh,
    ch23 tessellated_sphere::TessellatedSphere,
    ch28 glass_of_water::GlassOfWater,
    ch28 fish_bowl::FishBowl,
}

/// What was built of these data: of a supported size, and in the book's form if the scene asks for
/// that.
fn finished(shape: Arc<dyn Shape>, context: &Context) -> Result<Arc<dyn Shape>, Invalid> {
    let shape = of_supported_size(shape)?;
    let form = context.textbook().and_then(|epsilon| shape.textbook(epsilon));
    Ok(form.unwrap_or(shape))
}

/// The shape, if its extent and its distance from the origin are in [`LENGTHS`]; the unbounded have
/// neither.
fn of_supported_size(shape: Arc<dyn Shape>) -> Result<Arc<dyn Shape>, Invalid> {
    let bounds = shape.bounds();
    if bounds == Aabb::EVERYTHING || bounds == Aabb::EMPTY {
        return Ok(shape);
    }
    if bounds.extent().max_abs() == 0.0 {
        let problem = "too small to be told from a point at its coordinates: make it larger, or move it \
                       nearer to the origin";
        return Err(Invalid::new(problem));
    }
    match size_problem(bounds) {
        Some(problem) => Err(Invalid::new(problem)),
        None => Ok(shape),
    }
}

/// What is wrong with the extent, unless it is 0, or with the distance from the origin, if they are
/// not in [`LENGTHS`].
fn size_problem(bounds: Aabb) -> Option<String> {
    let farthest = bounds.min.to_vector().max_abs().max(bounds.max.to_vector().max_abs());
    let extent = bounds.extent().max_abs();
    let found = if farthest > *LENGTHS.end() {
        format!("found coordinates up to {}", shown(farthest))
    } else if extent > 0.0 && extent < *LENGTHS.start() {
        format!("found an extent of {}", shown(extent))
    } else {
        return None;
    };
    Some(format!("{found}, but {}", lengths()))
}
