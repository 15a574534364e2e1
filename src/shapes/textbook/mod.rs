//! The book's intersection routines (Suffern, ch. 3 and 19), which a scene may ask for: the
//! formulas as they stand, with a constant epsilon and no care for rounding. They show what the
//! library's own routines are for: surface acne, lost roots, and leaks.
//!
//! The book's roots of a carrier and its test of a trim stand beside the library's own:
//! `book_roots` and `book_has` of `src/shapes/trimmed.rs`. Here are the other shapes, and what
//! is longer. Where the book has no formula, what would usually be done. A form only says where a
//! ray hits. Normals, materials and texture coordinates are those of the library's shape, at that
//! hit. Compounds, solids, instances and lattices are the library's, made of such forms (the book's
//! compound is its list of parts); meshes and random spheres are searched as the scene says. The
//! caps of a beveled wedge, for which the book has no part, and shapes of a user's own keep their
//! routine.

// shared by the kinds
mod quartic;
mod searched;

mod algebraic;
mod cuboid;
mod torus;
mod triangle;

use std::f64::consts::TAU;
use std::fmt::Debug;
use std::sync::Arc;

pub use quartic::{cubic_roots, quartic_roots};
pub(super) use searched::{mesh, spheres};
pub(super) use torus::torus_roots;

use super::{Candidate, Role, SampledSurface, Sampling, Shape, Surface, Within};
use crate::math::{Aabb, Ray, Span, Vector, atan2, to_radians};

/// Where a hit is too near to the ray's origin to count, as a distance: the book's `kEpsilon` of
/// most shapes, here of all (its tori, cones and part objects have a tenth of it).
pub const EPSILON: f64 = 0.001;

/// Where a ray hits a shape, as the book finds it.
pub(super) trait Form: Debug + Send + Sync {
    /// The first hit inside the span, whose start is the book's epsilon.
    fn first(&self, ray: &Ray, span: Span) -> Option<Candidate>;

    /// Some hit inside the span, for shadows: its `t`.
    fn shadow(&self, ray: &Ray, span: Span) -> Option<f64> {
        self.first(ray, span).map(|at| at.t)
    }

    /// The surface at a hit of this ray, by the library's shape.
    fn surface(&self, ours: &dyn Shape, ray: &Ray, at: &Candidate) -> Surface {
        ours.surface(ray, at)
    }
}

/// A shape hit as the book hits it; everything else is the library's.
#[derive(Debug)]
struct Textbook<F> {
    form: F,
    ours: Arc<dyn Shape>,
    bounds: Aabb,
}

impl<F: Form> Textbook<F> {
    /// As the book's boxes, the bounds are larger by epsilon on each side.
    fn new(form: F, ours: Arc<dyn Shape>, epsilon: f64) -> Self {
        Self { form, bounds: grown(ours.bounds(), epsilon), ours }
    }
}

/// The box, larger by epsilon on each side.
fn grown(bounds: Aabb, epsilon: f64) -> Aabb {
    let more = epsilon * Vector::new(1.0, 1.0, 1.0);
    Aabb { min: bounds.min - more, max: bounds.max + more }
}

/// A shape hit by this form.
pub(super) fn form(
    form: impl Form + 'static,
    ours: impl Shape + 'static,
    epsilon: f64,
) -> Option<Arc<dyn Shape>> {
    Some(Arc::new(Textbook::new(form, Arc::new(ours), epsilon)))
}

/// A whole object, of the book's forms, as the book's tracer meets it: rays are of unit direction,
/// hits count beyond epsilon, and rays that leave the object start at the hit point itself.
pub(super) fn object(of: Arc<dyn Shape>, epsilon: f64) -> Arc<dyn Shape> {
    let whole = Whole { of: Arc::clone(&of), epsilon };
    Arc::new(Textbook { form: whole, bounds: of.bounds(), ours: of })
}

#[derive(Debug)]
struct Whole {
    of: Arc<dyn Shape>,
    epsilon: f64,
}

impl Whole {
    /// The ray with a unit direction, the span along it from epsilon on, and the length of the
    /// direction.
    fn normalised(&self, ray: &Ray, span: Span) -> (Ray, Span, f64) {
        let length = ray.direction.length();
        let unit = Ray::new(ray.origin, (1.0 / length) * ray.direction);
        let min = (span.min * length).max(self.epsilon);
        (unit, Span { min, max: span.max * length }, length)
    }
}

impl Form for Whole {
    fn first(&self, ray: &Ray, span: Span) -> Option<Candidate> {
        let (unit, beyond, length) = self.normalised(ray, span);
        let at = self.of.hit(&unit, beyond)?;
        let t = at.t / length;
        span.contains(t).then_some(Candidate { t, ..at })
    }

    fn shadow(&self, ray: &Ray, span: Span) -> Option<f64> {
        let (unit, beyond, length) = self.normalised(ray, span);
        let t = self.of.shadow_hit(&unit, beyond)? / length;
        span.contains(t).then_some(t)
    }

    /// The point is on the ray; an error of 0 lets the next ray start there.
    fn surface(&self, ours: &dyn Shape, ray: &Ray, at: &Candidate) -> Surface {
        let (point, border) = (ray.at(at.t), None);
        Surface { point, error: 0.0, border, ..ours.surface(ray, at) }
    }
}

impl<F: Form> Shape for Textbook<F> {
    fn hit(&self, ray: &Ray, span: Span) -> Option<Candidate> {
        self.form.first(ray, span)
    }

    fn shadow_hit(&self, ray: &Ray, span: Span) -> Option<f64> {
        self.form.shadow(ray, span)
    }

    fn surface(&self, ray: &Ray, at: &Candidate) -> Surface {
        self.form.surface(&*self.ours, ray, at)
    }

    /// Each hit is the first beyond the one before.
    fn roots(&self, ray: &Ray, span: Span) -> Vec<Candidate> {
        let next = |min: f64| self.form.first(ray, Span { min, ..span });
        std::iter::successors(next(span.min), |at| next(at.t)).collect()
    }

    fn within(&self, at: &Candidate) -> Within<'_> {
        Within::Nested(&*self.ours, *at, Role::Same)
    }

    fn material_without_uv(&self, own: u32, needs_uv: &dyn Fn(u32) -> bool) -> Option<u32> {
        self.ours.material_without_uv(own, needs_uv)
    }

    fn sampled(&self, sampling: Sampling) -> Option<Box<dyn SampledSurface>> {
        self.ours.sampled(sampling)
    }

    fn bounds(&self) -> Aabb {
        self.bounds
    }

    fn leaves(&self) -> u64 {
        self.ours.leaves()
    }

    fn whole(&self) -> Option<(&'static str, Arc<dyn Shape>)> {
        self.ours.whole()
    }
}

/// The first of the `ts`, which ascend, inside the span and on the shape.
pub(super) fn first_on(
    ts: impl IntoIterator<Item = f64>,
    span: Span,
    is_on: impl Fn(f64) -> bool,
) -> Option<Candidate> {
    ts.into_iter().find(|&t| span.contains(t) && is_on(t)).map(Candidate::at)
}

/// The roots of `a t² + b t + c` by the schoolbook's formula, smaller first for `a > 0`. The book
/// has no case for `a = 0`, where both are infinite or NaN.
pub(super) fn schoolbook_roots(a: f64, b: f64, c: f64) -> Option<[f64; 2]> {
    let disc = b * b - 4.0 * a * c;
    if disc < 0.0 {
        return None;
    }
    let e = disc.sqrt();
    let denom = 2.0 * a;
    Some([(-b - e) / denom, (-b + e) / denom])
}

/// A range of angles in radians; a minimum above the maximum goes through 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct BookAngles {
    min: f64,
    max: f64,
}

impl BookAngles {
    /// The range between two angles in degrees, as scenes have them.
    pub(super) fn degrees([min, max]: [f64; 2]) -> Self {
        if max - min >= 360.0 {
            return Self { min: 0.0, max: TAU };
        }
        let [min, max] = [min, max].map(|degrees| to_radians(degrees.rem_euclid(360.0)));
        Self { min, max }
    }

    pub(super) fn contains(self, angle: f64) -> bool {
        if self.min <= self.max {
            self.min <= angle && angle <= self.max
        } else {
            angle >= self.min || angle <= self.max
        }
    }
}

/// The angle of the direction `(cos, sin)` of any length, in `[0, 2π)`.
pub(super) fn angle(sin: f64, cos: f64) -> f64 {
    let angle = atan2(sin, cos);
    if angle < 0.0 { angle + TAU } else { angle }
}
