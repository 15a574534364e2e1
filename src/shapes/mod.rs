//! Shapes: what a ray can hit (Suffern, ch. 3, 19, 21, 23).
//!
//! A hit is found in two steps. [`Shape::hit`] answers with a small [`Candidate`]; for the nearest
//! one of all objects, [`Shape::surface`] then works out point, error bound and normals, once. The
//! book's `hit` does both at a time and its callers must remember to keep the nearest record.
//!
//! Each kind is a file with its plain data (what a scene says), the check that builds it, and its
//! `Shape`; its entry in the list at the end gives it its tag in scene files and enrols it in the
//! contract tests.

use std::fmt::Debug;
use std::sync::Arc;

use crate::invalid::{Invalid, LENGTHS, lengths, shown};
use crate::math::{Aabb, Normal, Point, Ray, Span, Transform, UNIT_ROUNDOFF, Vector};

/// A hit that may turn out not to be the nearest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Candidate {
    /// Where along the ray, in units of its direction.
    pub t: f64,
    /// Which of the shapes inside a compound, counted through all that are nested in it: those of
    /// its first part, then those of its second …; 0 for a shape that holds no others.
    pub leaf: u64,
    /// Which face of a box, which triangle of a mesh; 0 for shapes of one part.
    pub part: u32,
    /// Two parameters on that part, such as barycentric coordinates; 0 where none are needed.
    pub parameters: [f64; 2],
}

impl Candidate {
    /// A hit of a shape of one part.
    pub fn at(t: f64) -> Self {
        Self { t, leaf: 0, part: 0, parameters: [0.0; 2] }
    }
}

/// The surface at a hit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surface {
    /// The point, moved onto the surface: closer to it than `ray.at(t)`.
    pub point: Point,
    /// Bound on the distance, along the geometric normal, between `point` and the surface as the
    /// shape's own `hit` sees it: a ray that starts farther off than this does not hit it again.
    /// (A body thinner than a few of these, such as one that instances press flat to some dozens of
    /// roundings of its coordinates, may be left by its far wall: see `docs/accuracy.md`.)
    pub error: f64,
    /// Perpendicular to the surface; outward for what has an inside, unless its data say `inward`.
    /// Never turned to the viewer.
    pub normal: Normal,
    /// The normal that shading uses; differs from `normal` on smooth meshes only.
    pub shading: Normal,
    /// The point in the coordinates of the innermost shape, where textures live.
    pub local: Point,
    /// The material of that part of a compound, by its place in the scene; the object's own if
    /// `None`.
    pub material: Option<u32>,
}

impl Surface {
    /// A surface with one normal, in its own coordinates.
    pub fn new(point: Point, error: f64, normal: Normal) -> Self {
        Self { point, error, normal, shading: normal, local: point, material: None }
    }

    /// The same surface, its normals turned round if it is an inward one.
    fn turned(self, inward: bool) -> Self {
        if !inward {
            return self;
        }
        Self { normal: -self.normal, shading: -self.shading, ..self }
    }

    /// A plane through `anchor`, hit near `point`, which is moved onto it.
    pub fn flat(point: Point, anchor: Point, normal: Normal) -> Self {
        let off = (point - anchor).dot(normal);
        let point = point - off * normal;
        // the sum of three products of differences, rounded: γ₅ of the magnitudes, doubled; and the
        // way back to the plane, which counts where the point itself is almost zero
        let magnitude = point.to_vector().abs() + anchor.to_vector().abs();
        let error = 10.0 * UNIT_ROUNDOFF * (magnitude.dot(Vector::from(normal).abs()) + off.abs());
        Self::new(point, error, normal)
    }

    /// Whether a ray in this direction meets the side the normal points to.
    pub fn is_front(&self, direction: Vector) -> bool {
        self.normal.dot(direction) <= 0.0
    }

    /// Where a ray that leaves in this direction starts: off the surface by three error bounds,
    /// on the side it leaves to. There is no constant epsilon: see Pharr, Jakob & Humphreys,
    /// *PBRT*, "Managing rounding error".
    pub fn leave(&self, direction: Vector) -> Point {
        let side = 3.0_f64.copysign(self.normal.dot(direction));
        self.point + (side * self.error) * self.normal
    }
}

/// A triangle that is hit, and where.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Facet {
    /// Its corners, in the coordinates of the innermost shape.
    pub corners: [Point; 3],
    /// The barycentric coordinates β and γ of the point: the shares of the second and the third corner.
    pub barycentric: [f64; 2],
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

    /// The texture coordinates at a hit, if the surface has any. Asked for only where something
    /// looks at them.
    fn uv(&self, _: &Candidate) -> Option<[f64; 2]> {
        None
    }

    /// A material (its index in the scene) that needs texture coordinates where the shape has none, if
    /// there is one. `own` is the material of parts that name none. Asked once, when a world is built.
    fn material_without_uv(&self, own: u32, needs_uv: &dyn Fn(u32) -> bool) -> Option<u32> {
        needs_uv(own).then_some(own)
    }

    /// The triangle that is hit, if it is one. Asked for only where something looks at it.
    fn facet(&self, _: &Candidate) -> Option<Facet> {
        None
    }

    /// The hit moved by a short vector along the surface, in the coordinates of [`Surface::local`], for
    /// [`Shape::uv`] there; shapes without texture coordinates leave it where it is. Asked for only
    /// where a slope is measured.
    fn beside(&self, at: &Candidate, _: Vector) -> Candidate {
        *at
    }

    /// The map from the coordinates of [`Surface::local`] to those of [`Surface::point`] at a hit. Asked
    /// for only where a bump turns the normal.
    fn texture_space(&self, _: &Candidate) -> Transform {
        Transform::IDENTITY
    }

    /// Through which nested shapes the hit went, and which part of the innermost it is on. Asked for
    /// only where something looks at it.
    fn path(&self, _: &Candidate) -> PartPath {
        PartPath::default()
    }

    /// The surface as one on which points are drawn in this way, for area lights; `None` if that
    /// cannot be done. Asked once, when a light is built.
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
}

/// The first of the `ts` (ascending; NaN for none) that the span contains and the shape has, as a
/// candidate of a shape of one part. Both are tried: when the near one lies beyond an end of the
/// shape, the far one may be on it.
fn first_of(ts: [f64; 2], span: Span, has: impl Fn(f64) -> bool) -> Option<Candidate> {
    let counts = |t: f64| span.contains(t) && has(t);
    let [near, far] = ts;
    // no loop: it costs as much as the square root
    if counts(near) {
        return Some(Candidate::at(near));
    }
    counts(far).then(|| Candidate::at(far))
}

/// All of them.
fn all_of(ts: Option<[f64; 2]>, span: Span, has: impl Fn(f64) -> bool) -> Vec<Candidate> {
    let counted = ts.into_iter().flatten().filter(|&t| span.contains(t) && has(t));
    counted.map(Candidate::at).collect()
}

/// The normal along `v`. Where lengths are so far from 1 that nothing is left of `v`, or of the
/// place of a hit, it faces the ray.
fn normal_along(v: Vector, ray: &Ray) -> Normal {
    Normal::new(v).or_else(|| Normal::new(-ray.direction)).unwrap_or(Normal::Y)
}

/// Where a ray meets the plane through `anchor` with this normal; infinite or NaN for a ray in or
/// beside the plane, which no span contains.
fn plane_distance(ray: &Ray, anchor: Point, normal: Normal) -> f64 {
    (anchor - ray.origin).dot(normal) / ray.direction.dot(normal)
}

// shared by the kinds
mod context;
mod sampled;
pub mod textbook;

mod beveled;
mod composite;
mod meshes;
mod part;
mod plain;
mod solid;

use beveled::*;
use composite::*;
use meshes::*;
use part::*;
use plain::*;
use solid::*;

pub use composite::assembly::Materials;
pub use composite::compound::Part;
pub use composite::part_path::{Face, Level, PartPath};
pub use context::{Context, PartMaterial};
pub use plain::algebraic::Term;
pub use sampled::{SampledSurface, Sampling};
pub use solid::boundaries::BoundaryMaterials;

pub(crate) use composite::instance::transform_of;
pub use meshes::triangle_mesh::{AcceleratedMesh, TriangleMesh};

crate::kinds! {
    /// The surface of an object. Lengths are in the unit of the scene.
    Kind builds dyn Shape with Context, finished by finished;
    ch03 plane::Plane,
    ch03 sphere::Sphere,
    ch19 cuboid::Box,
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

/// What was built of these data: of a supported size, and in the book's form if the scene asks for that.
fn finished(
    kind: &Kind,
    shape: Arc<dyn Shape>,
    context: &Context,
) -> Result<Arc<dyn Shape>, Invalid> {
    let shape = of_supported_size(shape)?;
    Ok(match context.textbook() {
        Some(epsilon) => textbook::form(kind, shape, epsilon),
        None => shape,
    })
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

/// What is wrong with the extent, unless it is 0, or with the distance from the origin, if they are not
/// in [`LENGTHS`].
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
