//! The exact counterparts of library shapes, for laws that need exact intersections.

use groundtruth::math::{Transform, Vector};
use groundtruth::shapes::{Kind, Surface};
use oracle::Shape;

/// The oracle's shape with the same data; `None` for kinds that the oracle does not have.
pub fn exact(kind: &Kind) -> Option<Shape> {
    Some(match kind {
        Kind::Sphere(it) => Shape::Sphere { center: it.center.into(), radius: it.radius },
        Kind::Cuboid(it) => Shape::Cuboid { min: it.min.into(), max: it.max.into() },
        Kind::OpenCylinder(it) => Shape::OpenCylinder { y0: it.y0, y1: it.y1, radius: it.radius },
        Kind::PartCylinder(it) => {
            Shape::PartCylinder { y0: it.y0, y1: it.y1, radius: it.radius, phi: it.phi }
        }
        Kind::PartSphere(it) => Shape::PartSphere {
            center: it.center.into(),
            radius: it.radius,
            phi: it.phi,
            theta: it.theta,
        },
        Kind::Cone(it) => Shape::Cone { height: it.height, radius: it.radius },
        Kind::Paraboloid(it) => Shape::Paraboloid { height: it.height, radius: it.radius },
        Kind::Instance(it) => {
            let matrix = Transform::from_steps(&it.transform).ok()?.rows();
            Shape::Instance { matrix, of: Box::new(exact(&it.of)?) }
        }
        _ => return None,
    })
}

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
