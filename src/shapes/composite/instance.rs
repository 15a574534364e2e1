//! Instances (Suffern, ch. 21): a shape transformed by an affine map M.
//!
//! A ray meets the instance at the `t` at which the inverse ray `o' = M⁻¹ o`, `d' = M⁻¹ d`, not
//! normalised, meets the shape. The normal is `(M⁻¹)ᵀ n'`, normalised. Beside the book an instance
//! knows how far roundings of M and of M⁻¹ can move a point off the surface.

use std::sync::Arc;

use crate::invalid::{Invalid, direction, finite, finite_point, finite_vector, lengths, shown};
use crate::math::{Aabb, Normal, Point, Ray, Span, Step, Transform, UNIT_ROUNDOFF, Vector};
use crate::shapes::{
    Candidate, Context, Kind, Made, Role, SampledSurface, Sampling, Shape, Specification, Surface,
    Within, made, normal_along,
};

/// A shape transformed by a list of steps, first to last.
#[kind]
pub struct Instance {
    /// What is transformed; it may be an instance itself.
    pub of: Box<Kind>,
    /// The steps, in the order in which they are applied, about the origin of coordinates.
    pub transform: Vec<Step>,
    /// Whether the texture moves with the shape. If not, it is looked up at the point where the ray
    /// hits this instance (the book's `transform_the_texture`).
    #[optional(true)]
    pub transform_texture: bool,
}

/// A shape and its map.
#[derive(Debug)]
struct Placed {
    shape: Arc<dyn Shape>,
    transform: Transform,
    transform_texture: bool,
}

impl Instance {
    /// A shape after these steps; the texture moves with it.
    pub fn new(of: impl Into<Kind>, transform: Vec<Step>) -> Self {
        Self { of: Box::new(of.into()), transform, transform_texture: true }
    }
}

impl Specification for Instance {
    fn make(&self, context: &mut Context) -> Made {
        let transform = transform_of("transform", &self.transform)?;
        let shape = context.transformed(&transform, |context| self.of.build(context))?;
        if shape.bounds().is_bounded() && !transform.bounds(&shape.bounds()).is_bounded() {
            let problem = format!("found coordinates beyond any number, but {}", lengths());
            return Err(Invalid::field("transform", problem));
        }
        let transform_texture = self.transform_texture;
        made(Placed { shape, transform, transform_texture })
    }
}

/// The steps of the field of this name as one transformation.
pub fn transform_of(field: &str, steps: &[Step]) -> Result<Transform, Invalid> {
    for (index, step) in steps.iter().enumerate() {
        check(step).map_err(|e| e.inside(index).inside(field))?;
    }
    Transform::from_steps(steps).map_err(|singular| Invalid::field(field, singular.to_string()))
}

/// Refuses numbers that are not finite. A zero factor is refused by the condition number, later.
fn check(step: &Step) -> Result<(), Invalid> {
    match step {
        Step::Translate(by) => finite_vector("translate", *by).map(drop),
        Step::Scale(factors) => finite_vector("scale", *factors).map(drop),
        Step::RotateX(degrees) => finite("rotate_x", *degrees).map(drop),
        Step::RotateY(degrees) => finite("rotate_y", *degrees).map(drop),
        Step::RotateZ(degrees) => finite("rotate_z", *degrees).map(drop),
        Step::RotateAbout { point, direction: along, degrees } => finite_point("point", *point)
            .and(direction("direction", *along))
            .and(finite("degrees", *degrees).map(drop))
            .map_err(|e| e.inside("rotate_about")),
        Step::Reflect(_) => Ok(()),
        Step::Shear(factors) if factors.iter().all(|f| f.is_finite()) => Ok(()),
        Step::Shear(factors) => {
            let problem = format!("found {factors:?}, but six finite numbers are needed");
            Err(Invalid::field("shear", problem))
        }
        Step::Matrix(rows) => check_matrix(rows).map_err(|e| e.inside("matrix")),
    }
}

/// Refuses entries that are not finite, and a last row of no affine map.
fn check_matrix(rows: &[[f64; 4]; 4]) -> Result<(), Invalid> {
    const LAST: [f64; 4] = [0.0, 0.0, 0.0, 1.0];
    for (i, row) in rows.iter().enumerate() {
        for (j, &entry) in row.iter().enumerate() {
            let problem = if !entry.is_finite() {
                format!("found {entry}, but a finite number is needed")
            } else if i == 3 && entry != LAST[j] {
                let found = shown(entry);
                format!("found {found}, but the last of the four rows has to be [0, 0, 0, 1]")
            } else {
                continue;
            };
            return Err(Invalid::new(problem).inside(j).inside(i));
        }
    }
    Ok(())
}

impl Shape for Placed {
    fn hit(&self, ray: &Ray, span: Span) -> Option<Candidate> {
        self.shape.hit(&self.transform.ray_back(ray), span)
    }

    fn shadow_hit(&self, ray: &Ray, span: Span) -> Option<f64> {
        self.shape.shadow_hit(&self.transform.ray_back(ray), span)
    }

    fn surface(&self, ray: &Ray, at: &Candidate) -> Surface {
        let surface = surface_seen_through(&self.transform, &*self.shape, ray, at);
        let local = if self.transform_texture { surface.local } else { surface.point };
        Surface { local, ..surface }
    }

    fn within(&self, at: &Candidate) -> Within<'_> {
        let role =
            Role::Instance { transform: &self.transform, with_texture: self.transform_texture };
        Within::Nested(&*self.shape, *at, role)
    }

    fn material_without_uv(&self, own: u32, needs_uv: &dyn Fn(u32) -> bool) -> Option<u32> {
        self.shape.material_without_uv(own, needs_uv)
    }

    fn roots(&self, ray: &Ray, span: Span) -> Vec<Candidate> {
        self.shape.roots(&self.transform.ray_back(ray), span)
    }

    /// By solid angle only where angles stay as they are.
    fn sampled(&self, sampling: Sampling) -> Option<std::boxed::Box<dyn SampledSurface>> {
        if sampling == Sampling::SolidAngle && !self.transform.is_similarity() {
            return None;
        }
        let Self { transform, transform_texture, .. } = *self;
        let shape = self.shape.sampled(sampling)?;
        Some(std::boxed::Box::new(SampledInstance { shape, transform, transform_texture }))
    }

    fn bounds(&self) -> Aabb {
        bounds_seen_through(&self.transform, &self.shape.bounds())
    }

    fn leaves(&self) -> u64 {
        self.shape.leaves()
    }

    fn whole(&self) -> Option<(&'static str, Arc<dyn Shape>)> {
        let (name, shape) = self.shape.whole()?;
        Some((name, Arc::new(Self { shape, ..*self })))
    }
}

/// The surface of a shape at a hit of the ray, outside.
pub(in crate::shapes) fn surface_seen_through(
    transform: &Transform,
    shape: &dyn Shape,
    ray: &Ray,
    at: &Candidate,
) -> Surface {
    let inner = shape.surface(&transform.ray_back(ray), at);
    moved_out(transform, inner, ray)
}

/// A surface in inner coordinates, outside; the ray meets it.
fn moved_out(transform: &Transform, inner: Surface, ray: &Ray) -> Surface {
    let point = transform.point(inner.point);
    let outer = |n: Normal| normal_along(transform.covector(n), ray);
    let normal = outer(inner.normal);
    // the length outside of a unit step along the normal inside
    let stretch = 1.0 / transform.covector(inner.normal).length();
    // the next ray's origin is moved back: its distance from the inner point, and the rounding of that
    let back = transform.inverse();
    let drift = (back.point(point) - inner.point).dot(inner.normal).abs();
    let rounding = back.magnitude(point).dot(Vector::from(inner.normal).abs());
    let error = stretch * (inner.error + drift + 12.0 * UNIT_ROUNDOFF * rounding);
    let border = inner.border.as_ref().map(|border| {
        let rounding = UNIT_ROUNDOFF * back.magnitude(point).max_abs();
        Box::new(border.outside(transform, rounding))
    });
    Surface { point, error, normal, shading: outer(inner.shading), border, ..inner }
}

/// The box around a transformed box, padded by the rounding of a hit that is moved into the inner
/// coordinates and back: where large translations cancel, that is more than a few u of the outer
/// coordinates.
pub(in crate::shapes) fn bounds_seen_through(transform: &Transform, inner: &Aabb) -> Aabb {
    let outer = transform.bounds(inner);
    if !outer.is_bounded() {
        return outer;
    }
    let back = transform.inverse();
    let moved = |corner: Point| {
        let rounding = back.magnitude(transform.point(corner));
        transform.magnitude(corner) + transform.stretch(rounding)
    };
    let worst = inner.corners().map(moved).into_iter().fold(Vector::ZERO, Vector::max);
    let pad = 16.0 * UNIT_ROUNDOFF * worst;
    Aabb { min: outer.min - pad, max: outer.max + pad }
}

/// A sampled shape, seen from outside the instance.
#[derive(Debug)]
struct SampledInstance {
    shape: std::boxed::Box<dyn SampledSurface>,
    transform: Transform,
    transform_texture: bool,
}

impl SampledInstance {
    /// The solid angle inside that is one steradian outside, around the direction `v` of an inner
    /// point: `|M v|³/|det M|` for unit `v`.
    fn solid_angle_ratio(&self, inner_from: Point, inner_point: Point) -> f64 {
        let way = inner_point - inner_from;
        let stretch = self.transform.vector(way).length() / way.length();
        stretch * stretch * stretch / self.transform.determinant().abs()
    }
}

impl SampledSurface for SampledInstance {
    fn sample(&self, from: Point, u: [f64; 2]) -> Option<(Surface, f64)> {
        let inner_from = self.transform.inverse().point(from);
        let (inner, pdf) = self.shape.sample(inner_from, u)?;
        let pdf = pdf * self.solid_angle_ratio(inner_from, inner.point);
        let ray = Ray::new(from, self.transform.point(inner.point) - from);
        let mut outer = moved_out(&self.transform, inner, &ray);
        if !self.transform_texture {
            outer.local = outer.point;
        }
        (pdf > 0.0 && pdf.is_finite()).then_some((outer, pdf))
    }

    fn candidate(&self, from: Point, u: [f64; 2]) -> Candidate {
        self.shape.candidate(self.transform.inverse().point(from), u)
    }

    fn pdf(&self, from: Point, at: &Surface) -> f64 {
        let back = self.transform.inverse();
        let (inner_from, point) = (back.point(from), back.point(at.point));
        let normal = Normal::new(back.covector(at.normal)).unwrap_or(at.normal);
        let inner = Surface { point, normal, ..at.clone() };
        self.shape.pdf(inner_from, &inner) * self.solid_angle_ratio(inner_from, point)
    }
}
