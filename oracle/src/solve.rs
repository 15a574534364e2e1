//! For each kind of shape: its intersections with a ray, their derivatives, and the margin.

mod algebraic;
mod border;
mod cuboid;
mod cylinder;
mod disk;
pub(crate) mod face;
mod flat;
mod instance;
mod polynomial;
mod quadric;
mod revolution;
mod ring;
pub(crate) mod solid;
mod sphere;
mod torus;

pub use instance::condition;
pub(crate) use polynomial::Polynomial;

use crate::{
    margin::Gate,
    real::{M, Real, V},
    shape::{Ray, Shape},
};

/// A ray in the space of a shape.
pub(crate) struct Beam {
    pub(crate) o: V,
    pub(crate) d: V,
    /// A relative change by ε of all inputs other than the shape's moves `o` by at most `o_shift·ε` …
    pub(crate) o_shift: f64,
    /// … and `d` by at most `d_shift·ε`.
    pub(crate) d_shift: f64,
}

impl Beam {
    pub(crate) fn new(ray: &Ray<Real>) -> Beam {
        let (o, d) = (V(ray.origin.clone()), V(ray.direction.clone()));
        let (o_shift, d_shift) = (o.len(), d.len());
        assert!(d_shift > 0.0, "a ray has a direction");
        Beam { o, d, o_shift, d_shift }
    }

    pub(crate) fn at(&self, t: &Real) -> V {
        &self.o + &(&self.d * t)
    }
}

/// A root of `F(o + t d) = 0`, and the derivatives of `F` there.
pub(crate) struct Hit {
    pub(crate) t: Real,
    /// `∇F`, along the outward normal.
    pub(crate) gradient: V,
    /// The sum over the shape's inputs `x` of `|∂F/∂x|·|x|`.
    pub(crate) inputs: f64,
    /// Second derivatives of `F`; `None` where the surface is flat.
    pub(crate) hessian: Option<M>,
    pub(crate) face_margin: f64,
    /// See [`crate::Root::squeeze`].
    pub(crate) squeeze: f64,
}

impl Hit {
    fn new(t: Real, gradient: V, inputs: f64, hessian: Option<M>) -> Hit {
        Hit { t, gradient, inputs, hessian, face_margin: f64::INFINITY, squeeze: 1.0 }
    }

    fn flat(t: Real, gradient: V, inputs: f64) -> Hit {
        Hit::new(t, gradient, inputs, None)
    }
}

/// All roots, also those behind the origin, and the margin of the answer for `t > 0`.
pub(crate) struct Found {
    pub(crate) hits: Vec<Hit>,
    pub(crate) margin: f64,
}

pub(crate) fn solve(shape: &Shape<Real>, beam: &Beam) -> Found {
    let v = |x: &[Real; 3]| V(x.clone());
    match shape {
        Shape::Plane { point, normal } => flat::plane(&v(point), &v(normal), beam),
        Shape::Sphere { center, radius } => sphere::sphere(&v(center), radius, beam),
        Shape::Cuboid { min, max } => cuboid::cuboid([&v(min), &v(max)], beam),
        Shape::Triangle { vertices } => flat::triangle(vertices.each_ref().map(v), beam),
        Shape::Rectangle { corner, a, b } => flat::rectangle(&v(corner), &v(a), &v(b), beam),
        Shape::Disk { center, normal, radius } => disk::disk(&v(center), &v(normal), radius, beam),
        Shape::OpenCylinder { y0, y1, radius } => cylinder::cylinder([y0, y1], radius, beam),
        Shape::Annulus { center, normal, inner, outer } => {
            ring::annulus(&v(center), &v(normal), [inner, outer], beam)
        }
        Shape::PartAnnulus { center, inner, outer, phi } => {
            ring::part_annulus(&v(center), [inner, outer], phi, beam)
        }
        Shape::Cone { height, radius } => revolution::cone(height, radius, beam),
        Shape::Paraboloid { height, radius } => revolution::paraboloid(height, radius, beam),
        Shape::PartSphere { center, radius, phi, theta } => {
            revolution::part_sphere(&v(center), radius, phi, theta, beam)
        }
        Shape::PartCylinder { y0, y1, radius, phi } => {
            revolution::part_cylinder([y0, y1], radius, phi, beam)
        }
        Shape::Torus { swept_radius, tube_radius } => {
            torus::torus(swept_radius, tube_radius, None, beam)
        }
        Shape::PartTorus { swept_radius, tube_radius, phi, theta } => {
            let part = [phi.each_ref(), theta.each_ref()];
            torus::torus(swept_radius, tube_radius, Some(part), beam)
        }
        Shape::Algebraic { terms, min, max } => {
            algebraic::algebraic(terms, [&v(min), &v(max)], beam)
        }
        Shape::CutFace { size, radius } => face::cut_face(size, radius, beam),
        Shape::Solid(of) => solid::solid(of, beam),
        Shape::Instance { matrix, of } => instance::instance(matrix, of, beam),
    }
}

/// The sign of `n·d`: 0 when the ray is parallel to the plane.
fn facing(n: &V, beam: &Beam) -> Gate {
    let (n_len, d_len) = (n.len(), beam.d.len());
    Gate::new(&n.dot(&beam.d), n_len * (beam.d_shift + d_len), n_len * beam.d_shift)
}

/// The sign of `(p − o)·n`: 0 when the ray starts in the plane.
fn height(p: &V, n: &V, beam: &Beam) -> Gate {
    let (w, n_len) = (p - &beam.o, n.len());
    let shift = n_len * (beam.o_shift + p.len());
    Gate::new(&w.dot(n), shift + w.len() * n_len, shift)
}

/// Both real roots of `a t² + 2 b t + c`, ascending, for a given discriminant `b² − a c`. The root of
/// larger modulus is computed first, the other from it, so that nothing cancels.
fn quadratic(a: &Real, b: &Real, c: &Real, discriminant: &Real) -> Vec<Real> {
    use crate::real::{real, sign};
    if sign(a).is_eq() || sign(discriminant).is_lt() {
        return Vec::new();
    }
    let root = discriminant.sqrt();
    let q = if sign(b).is_lt() { root - b } else { -(root + b) };
    if sign(&q).is_eq() {
        return vec![real(0.0), real(0.0)]; // b = 0 and c = 0
    }
    let mut roots = vec![&q / a, c / &q];
    roots.sort();
    roots
}
