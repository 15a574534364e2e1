//! The backward error of hits: the library's shapes compared with the oracle's.
//!
//! The error of a hit is measured in units of `u · cond`, as if the input had a relative error of that
//! many `u`. Hit or miss is judged only if no relative change of the input by 1e-13 would change the
//! answer. In instances, this margin and the error of a normal are multiplied by the condition number of
//! the matrix, and the error of `t` by its part for the surface that is hit ([`oracle::Root::squeeze`]).
//! Used by the chapters' sweeps and by the report.

use std::sync::Arc;

use oracle::hard::Family;

use groundtruth::math::{
    Point, Ray, Span, Step, Transform, UNIT_ROUNDOFF, Vector, atan2, power_of_two, to_degrees,
};
use groundtruth::shapes::{self, Context, Instance, textbook};

/// An answer that a smaller relative change of the input would change may be wrong.
pub const MIN_MARGIN: f64 = 1e-13;
/// The error allowed in `t` and in normals of curved shapes, in units of `u · cond`.
pub const ALLOWED: f64 = 100.0;
/// The error allowed in normals of flat shapes, and in the length of all normals, in units of `u`.
pub const FLAT_NORMAL: f64 = 4.0;

/// A shape of the library, and the same shape for the oracle.
#[derive(Clone, Debug)]
pub struct Pair {
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
pub fn pair(exact: &oracle::Shape) -> Option<Pair> {
    let (kind, exact) = ours(exact)?;
    Some(Pair { ours: kind.build(&mut Context::default()).ok()?, exact })
}

/// An instance of the shape, and the ray transformed with it.
pub fn instanced(
    shape: &oracle::Shape,
    ray: &oracle::Ray,
    matrix: [[f64; 4]; 3],
) -> Option<(Pair, oracle::Ray)> {
    let moved = oracle::Shape::Instance { matrix, of: Box::new(shape.clone()) };
    let transform = Transform::from_steps(&steps(&matrix)?).ok()?;
    let ray = oracle::Ray {
        origin: transform.point(ray.origin.into()).into(),
        direction: transform.vector(ray.direction.into()).into(),
    };
    Some((pair(&moved)?, ray))
}

/// The library's description of a shape, and the oracle's shape with the library's matrices. `None` if the
/// library has no such shape.
pub fn ours(exact: &oracle::Shape) -> Option<(shapes::Kind, oracle::Shape)> {
    if let oracle::Shape::Instance { matrix, of } = exact {
        let (inner, exact_inner) = ours(of)?;
        let transform = steps(matrix)?;
        let matrix = Transform::from_steps(&transform).ok()?.rows();
        let instance = Instance::new(inner, transform);
        return Some((
            instance.into(),
            oracle::Shape::Instance { matrix, of: Box::new(exact_inner) },
        ));
    }
    let kind = flat(exact.clone()).or_else(|| curved(exact.clone()))?;
    Some((kind, exact.clone()))
}

/// The library's description of a flat shape, or of one with flat faces.
fn flat(exact: oracle::Shape) -> Option<shapes::Kind> {
    Some(match exact {
        oracle::Shape::Plane { point, normal } => {
            shapes::Plane { point: point.into(), normal: normal.into() }.into()
        }
        oracle::Shape::Cuboid { min, max } => {
            shapes::Cuboid { min: min.into(), max: max.into() }.into()
        }
        oracle::Shape::Triangle { vertices } => {
            shapes::Triangle { vertices: vertices.map(Point::from), normals: None }.into()
        }
        oracle::Shape::Rectangle { corner, a, b } => {
            shapes::Rectangle { corner: corner.into(), a: a.into(), b: b.into() }.into()
        }
        oracle::Shape::Disk { center, normal, radius } => {
            shapes::Disk { center: center.into(), normal: normal.into(), radius }.into()
        }
        oracle::Shape::Annulus { center, normal, inner, outer } => shapes::Annulus {
            center: center.into(),
            normal: normal.into(),
            inner_radius: inner,
            outer_radius: outer,
        }
        .into(),
        oracle::Shape::PartAnnulus { center, inner, outer, phi } => shapes::PartAnnulus {
            center: center.into(),
            normal: Vector::Y,
            inner_radius: inner,
            outer_radius: outer,
            phi,
        }
        .into(),
        oracle::Shape::CutFace { size, radius } => shapes::CutFace { size, radius }.into(),
        _ => return None,
    })
}

/// The library's description of a shape with a curved surface.
fn curved(exact: oracle::Shape) -> Option<shapes::Kind> {
    Some(match exact {
        oracle::Shape::Sphere { center, radius } => {
            shapes::Sphere { center: center.into(), radius, inward: false }.into()
        }
        oracle::Shape::OpenCylinder { y0, y1, radius } => {
            shapes::OpenCylinder { y0, y1, radius, inward: false }.into()
        }
        oracle::Shape::Cone { height, radius } => {
            shapes::Cone { height, radius, inward: false }.into()
        }
        oracle::Shape::Paraboloid { height, radius } => {
            shapes::Paraboloid { height, radius, inward: false }.into()
        }
        oracle::Shape::PartSphere { center, radius, phi, theta } => {
            shapes::PartSphere { center: center.into(), radius, phi, theta, inward: false }.into()
        }
        oracle::Shape::PartCylinder { y0, y1, radius, phi } => {
            shapes::PartCylinder { y0, y1, radius, phi, inward: false }.into()
        }
        oracle::Shape::Torus { swept_radius, tube_radius } => {
            shapes::Torus { swept_radius, tube_radius, inward: false }.into()
        }
        oracle::Shape::PartTorus { swept_radius, tube_radius, phi, theta } => {
            shapes::PartTorus { swept_radius, tube_radius, phi, theta, inward: false }.into()
        }
        oracle::Shape::Algebraic { terms, min, max } => {
            let term = |(coefficient, powers)| shapes::Term { coefficient, powers };
            let terms = terms.into_iter().map(term).collect();
            shapes::Algebraic { terms, min: min.into(), max: max.into() }.into()
        }
        oracle::Shape::Solid(of) => solid(of),
        oracle::Shape::Plane { .. }
        | oracle::Shape::Cuboid { .. }
        | oracle::Shape::Triangle { .. }
        | oracle::Shape::Rectangle { .. }
        | oracle::Shape::Disk { .. }
        | oracle::Shape::Annulus { .. }
        | oracle::Shape::PartAnnulus { .. }
        | oracle::Shape::CutFace { .. }
        | oracle::Shape::Instance { .. } => return None,
    })
}

/// The library's description of a solid.
fn solid(exact: oracle::Solid) -> shapes::Kind {
    use oracle::Solid;
    let materials = shapes::Materials::new();
    match exact {
        Solid::Cylinder { y0, y1, radius } => {
            shapes::SolidCylinder { y0, y1, radius, materials }.into()
        }
        Solid::Cone { height, radius } => shapes::SolidCone { height, radius, materials }.into(),
        Solid::ThickRing { y0, y1, inner: inner_radius, outer: outer_radius } => {
            shapes::ThickRing { y0, y1, inner_radius, outer_radius, materials }.into()
        }
        Solid::FlatRimmedBowl { inner: inner_radius, outer: outer_radius, opening } => {
            shapes::FlatRimmedBowl { inner_radius, outer_radius, opening, materials }.into()
        }
        Solid::RoundRimmedBowl { inner: inner_radius, outer: outer_radius, opening } => {
            shapes::RoundRimmedBowl { inner_radius, outer_radius, opening, materials }.into()
        }
        Solid::ConcaveLens { radius, thickness, min_distance } => {
            shapes::ConcaveLens { radius, thickness, min_distance, materials }.into()
        }
        Solid::BeveledBox { min, max, bevel } => {
            shapes::BeveledBox { min: min.into(), max: max.into(), bevel, materials }.into()
        }
        Solid::BeveledCylinder { y0, y1, radius, bevel } => {
            shapes::BeveledCylinder { y0, y1, radius, bevel, materials }.into()
        }
        Solid::BeveledRing { y0, y1, inner: inner_radius, outer: outer_radius, bevel } => {
            shapes::BeveledRing { y0, y1, inner_radius, outer_radius, bevel, materials }.into()
        }
        Solid::BeveledWedge { y0, y1, inner: inner_radius, outer: outer_radius, phi, bevel } => {
            shapes::BeveledWedge { y0, y1, inner_radius, outer_radius, phi, bevel, materials }
                .into()
        }
    }
}

/// Steps whose product is this matrix up to rounding: shear, scale, rotation and translation, by the
/// Gram–Schmidt process on the columns. `None` if the matrix is singular. (Does not find the axis of a half
/// turn.)
pub fn steps(matrix: &[[f64; 4]; 3]) -> Option<Vec<Step>> {
    let [c0, c1, c2, shift] =
        [0, 1, 2, 3].map(|j| Vector::new(matrix[0][j], matrix[1][j], matrix[2][j]));
    let x = c0.unit()?;
    let y = (c1 - c1.dot(x) * x).unit()?;
    let z = x.cross(y);
    let (sx, sy, sz) = (c0.dot(x), c1.dot(y), c2.dot(z));
    let shear = [c1.dot(x) / sx, c2.dot(x) / sx, 0.0, c2.dot(y) / sy, 0.0, 0.0];
    // the rotation with these columns: its axis from the skew part, its angle from the skew part and
    // the trace
    let axis = Vector::new(y.z() - z.y(), z.x() - x.z(), x.y() - y.x());
    let angle = atan2(axis.length(), x.x() + y.y() + z.z() - 1.0);
    let turn =
        Step::RotateAbout { point: Point::ORIGIN, direction: axis, degrees: to_degrees(angle) };
    let mut steps = vec![Step::Shear(shear), Step::Scale(Vector::new(sx, sy, sz))];
    if angle > 0.0 {
        steps.push(turn);
    }
    steps.push(Step::Translate(shift));
    Some(steps)
}
