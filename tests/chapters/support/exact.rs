//! The exact counterparts of library shapes, for laws that need exact intersections.

pub use exact::oracle_shape;
use oracle::Shape;

use crate::prelude::*;

/// The exact intersections of the shape with the line along the normal of a hit, within `reach` of the hit;
/// distances above the surface are positive.
pub fn walls_along_normal(exact: &Shape, s: &Surface, reach: f64) -> Vec<f64> {
    let side = |sign: f64| {
        let direction = (sign * Vector::from(s.normal)).into();
        let ray = oracle::Ray { origin: s.point.into(), direction };
        let roots = oracle::intersect(exact, &ray).roots.into_iter().map(|root| root.t);
        roots.filter(move |t| *t <= reach).map(move |t| sign * t)
    };
    side(1.0).chain(side(-1.0)).collect()
}
