//! The exact answer, and the errors of a computed answer.

use crate::{
    real::{M, Real, V, nearest, real, sign},
    shape::{Ray, Shape},
    solve::{self, Beam},
};

/// One point where the ray meets the surface.
#[derive(Clone, Debug)]
pub struct Root {
    /// The nearest `f64` to the exact parameter.
    pub t: f64,
    /// The condition of `t`: the sum over all inputs `x` of `|∂t/∂x|·|x|`, infinite at tangency.
    pub cond: f64,
    /// The shape's normal in world space, unit, each component correct to its last bit.
    pub normal: [f64; 3],
    /// The smallest radius of curvature of the surface there; infinite where it is flat.
    pub size: f64,
    /// The smallest relative change for which another face of a cuboid is hit (so that `normal`
    /// jumps while `t` does not); infinite for shapes without edges between faces.
    pub face_margin: f64,
    /// The factor by which rounding object-space coordinates of an instance matters more than rounding
    /// world-space coordinates: `‖A⁻¹‖·|g|/|A⁻ᵀ g|` for the surface's object-space gradient g. It is at
    /// most the condition of A, and 1 for shapes that are not instances.
    pub squeeze: f64,
    pub(crate) exact_t: Real,
    pub(crate) exact_normal: V,
}

impl Root {
    /// `|computed − t|` for the exact `t`; infinite if `computed` is no number.
    pub fn t_error(&self, computed: f64) -> f64 {
        if !computed.is_finite() {
            return f64::INFINITY;
        }
        nearest(&(real(computed) - &self.exact_t)).abs()
    }

    /// The distance between the unit vectors along `computed` and the exact normal; infinite if
    /// `computed` has no direction.
    pub fn normal_error(&self, computed: [f64; 3]) -> f64 {
        if !computed.iter().all(|x| x.is_finite()) {
            return f64::INFINITY;
        }
        let direction = V(computed.map(real)).unit();
        direction.map_or(f64::INFINITY, |unit| (&unit - &self.exact_normal).len())
    }
}

/// Everything about one ray and one shape.
#[derive(Clone, Debug)]
pub struct Answer {
    /// Every intersection with `t > 0`, or beyond the given start, in ascending order; a double root may
    /// be listed once or twice.
    pub roots: Vec<Root>,
    /// No relative change of the inputs smaller than this changes the number of roots; for an
    /// instance, none smaller than this over [`Shape::condition`]. A lower bound, mostly within a
    /// factor of 4 of the truth; 0 where an arbitrarily small change can change the answer, and where the
    /// surface has no normal.
    pub margin: f64,
}

/// Where the ray meets the shape.
///
/// # Panics
/// If an input is not finite, a direction or normal is zero, or a matrix is singular.
pub fn intersect(shape: &Shape, ray: &Ray) -> Answer {
    answer(&shape.exact(), &ray.exact())
}

/// Where the ray meets the shape beyond `start`. [`Answer::margin`] considers only these roots, however
/// close the ray's origin is to the shape.
///
/// # Panics
/// As [`intersect`].
pub fn intersect_beyond(shape: &Shape, ray: &Ray, start: f64) -> Answer {
    answer_beyond(&shape.exact(), &ray.exact(), &real(start))
}

/// [`intersect`] for inputs of full precision.
pub(crate) fn answer(shape: &Shape<Real>, ray: &Ray<Real>) -> Answer {
    answer_beyond(shape, ray, &real(0.0))
}

/// The roots with `t > start`, computed for the ray moved to its point at `start`.
fn answer_beyond(shape: &Shape<Real>, ray: &Ray<Real>, start: &Real) -> Answer {
    let beam = Beam::new(ray);
    let moved = Ray { origin: beam.at(start).0, direction: ray.direction.clone() };
    // how far a change of the inputs moves the new origin: this may exceed the new origin's length
    let o_shift = beam.o_shift + nearest(start).abs() * beam.d_shift;
    let mut found = solve::solve(shape, &Beam { o_shift, ..Beam::new(&moved) });
    found.hits.retain(|hit| sign(&hit.t).is_gt());
    found.hits.sort_by(|a, b| a.t.cmp(&b.t));
    if found.hits.iter().any(|hit| hit.gradient.unit().is_none()) {
        found.margin = 0.0;
    }
    let beyond = |hit: solve::Hit| solve::Hit { t: &hit.t + start, ..hit };
    let roots = found.hits.into_iter().map(|hit| root(beyond(hit), &beam)).collect();
    Answer { roots, margin: found.margin }
}

/// For a surface `F(o + t d; x) = 0` with gradient `g`: `∂t/∂x = −F_x / (g·d)`, where `F_o = g` and
/// `F_d = t g`; the shape adds the terms of its own inputs.
fn root(hit: solve::Hit, beam: &Beam) -> Root {
    let slope = nearest(&hit.gradient.dot(&beam.d)).abs();
    let t = nearest(&hit.t);
    let ray_inputs = hit.gradient.len() * (beam.o.len() + t.abs() * beam.d.len());
    // where a surface has no normal, as at the apex of a cone or at a double zero, any direction is as good
    let normal = hit.gradient.unit().or_else(|| beam.d.unit()).expect("a ray has a direction");
    Root {
        t,
        cond: (ray_inputs + hit.inputs) / slope,
        normal: normal.0.each_ref().map(nearest),
        size: hit.hessian.as_ref().map_or(f64::INFINITY, |h| radius(&hit.gradient, &normal, h)),
        face_margin: hit.face_margin,
        squeeze: hit.squeeze,
        exact_t: hit.t,
        exact_normal: normal,
    }
}

/// The smallest radius of curvature of `F = 0`: the greatest curvature is the eigenvalue of largest
/// modulus of the Hessian on the tangent plane, over the length of the gradient.
fn radius(gradient: &V, normal: &V, hessian: &M) -> f64 {
    let smallest = (0..3).min_by_key(|&i| normal.0[i].clone() * &normal.0[i]).unwrap_or(0);
    let axis = V(std::array::from_fn(|i| real(if i == smallest { 1.0 } else { 0.0 })));
    let u = normal.cross(&axis).unit().expect("the axis is the farthest from the normal");
    let v = normal.cross(&u);
    let (hu, hv) = (hessian.times(&u), hessian.times(&v));
    let (a, b, c) = (nearest(&u.dot(&hu)), nearest(&u.dot(&hv)), nearest(&v.dot(&hv)));
    let spread = ((a - c) * (a - c) + 4.0 * b * b).sqrt();
    gradient.len() / (0.5 * ((a + c).abs() + spread))
}
