//! The backward error of hits: the library's shapes compared with the oracle's.
//!
//! The error of a hit is measured in units of `u · cond`, as if the input had a relative error of that
//! many `u`. Hit or miss is judged only if no relative change of the input by 1e-13 would change the
//! answer. In instances, this margin and the error of a normal are multiplied by the condition number of
//! the matrix, and the error of `t` by its part for the surface that is hit ([`oracle::Root::squeeze`]).
//! Used by the chapters' sweeps and by the report.

use std::sync::Arc;

use oracle::hard::Family;

use groundtruth::math::{Point, Ray, Span, Transform, UNIT_ROUNDOFF, Vector, power_of_two};
use groundtruth::shapes::{self, Context, textbook};

use crate::same_shape::{oracle_shape, our_shape, steps};

/// An answer that a smaller relative change of the input would change may be wrong.
pub const MIN_MARGIN: f64 = 1e-13;
/// The error allowed in `t` and in normals of curved shapes, in units of `u · cond`.
pub const ALLOWED: f64 = 100.0;
/// The error allowed in normals of flat shapes, and in the length of all normals, in units of `u`.
pub const FLAT_NORMAL: f64 = 4.0;

/// A shape of the library, and the same shape for the oracle.
#[derive(Clone, Debug)]
pub struct ShapePair {
    /// Built for rays.
    pub ours: Arc<dyn shapes::Shape>,
    /// The oracle's shape; an instance has the matrix that the library computed from its steps.
    pub exact: oracle::Shape,
}

/// Whether rounding cannot change the answer.
pub fn is_decided(answer: &oracle::Answer, condition: f64) -> bool {
    answer.margin > MIN_MARGIN * condition
}

/// The error of a distance, in units of `u · cond`; in an instance, of `u · cond` times its squeeze, the
/// effect of rounding the coordinates inside it.
pub fn t_error(root: &oracle::Root, t: f64) -> f64 {
    root.t_error(t) / (UNIT_ROUNDOFF * root.squeeze * root.cond.max(root.t.abs()))
}

/// The error of a unit normal in units of `u · cond`, and the error allowed; `None` at an edge between two
/// faces, where either normal is right.
pub fn normal_error(
    root: &oracle::Root,
    normal: [f64; 3],
    direction: Vector,
    condition: f64,
) -> Option<(f64, f64)> {
    if root.face_margin <= MIN_MARGIN * condition {
        return None;
    }
    let flat = root.size.is_infinite();
    let moved = if flat { 1.0 } else { (root.cond * direction.length() / root.size).max(1.0) };
    let error = root.normal_error(normal) / (UNIT_ROUNDOFF * condition * moved);
    Some((error, if flat { FLAT_NORMAL } else { ALLOWED }))
}

/// The same ray for the library.
pub fn ray(exact: &oracle::Ray) -> Ray {
    Ray::new(Point::from(exact.origin), Vector::from(exact.direction))
}

/// The ray that a map takes this one to.
pub(crate) fn transformed(ray: &oracle::Ray, map: &Transform) -> oracle::Ray {
    oracle::Ray {
        origin: map.point(ray.origin.into()).into(),
        direction: map.vector(ray.direction.into()).into(),
    }
}

/// The span of a family's rays: everything ahead. For rays that start on the surface it begins at a
/// millionth of the shape's size, because rounding decides whether the start itself is hit. Another law
/// tests that rays leave their surface.
pub fn span(family: Family, shape: &dyn shapes::Shape, ray: &Ray) -> Span {
    if family != Family::OnSurface {
        return Span::AHEAD;
    }
    let size = shape.bounds().extent().length();
    let size = if size.is_finite() { size } else { 1.0 };
    Span { min: size * power_of_two(-20) / ray.direction.length(), ..Span::AHEAD }
}

/// The shape with the book's intersection routines, which find hits beyond [`textbook::EPSILON`]; `None`
/// if the library refuses it.
pub fn by_the_book(kind: &shapes::Kind) -> Option<Arc<dyn shapes::Shape>> {
    let mut context = Context::default();
    context.set_textbook(Some(textbook::EPSILON));
    kind.build(&mut context).ok()
}

/// The library's shape of the same data; `None` if the library refuses them.
pub fn pair(exact: &oracle::Shape) -> Option<ShapePair> {
    let kind = our_shape(exact)?;
    Some(ShapePair { ours: kind.build(&mut Context::default()).ok()?, exact: oracle_shape(&kind)? })
}

/// An instance of the shape, and the ray transformed with it.
pub fn instanced(
    shape: &oracle::Shape,
    ray: &oracle::Ray,
    matrix: [[f64; 4]; 3],
) -> Option<(ShapePair, oracle::Ray)> {
    let moved = oracle::Shape::Instance { matrix, of: Box::new(shape.clone()) };
    let transform = Transform::from_steps(&steps(&matrix)?).ok()?;
    Some((pair(&moved)?, transformed(ray, &transform)))
}
