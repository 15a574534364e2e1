//! Simple shapes of random sizes, and the rays that leave them.

use groundtruth::shapes::{
    Annulus, Cone, OpenCylinder, Paraboloid, PartAnnulus, PartCylinder, PartSphere,
};

use super::exact::{oracle_shape, walls_along_normal};
use crate::prelude::*;

/// How often a ray that leaves the surface hits the shape again.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Form {
    /// Never.
    Flat,
    /// Once to the inside, never to the outside.
    Convex,
    /// As convex, but a ray may also leave through the open ends.
    Tube,
}

/// A shape of this size, up to a thousand sizes from the origin, and a point on it or inside it.
pub fn body(draw: &mut Draw, size: f64) -> (Kind, Form, Point) {
    let reach = size * draw.decades(-1.0, 3.0);
    let center = draw.point(reach);
    let n: Vector = draw.direction().into();
    let across = n.cross(draw.direction()).unit().expect("not parallel");
    let third = n.cross(across);
    match draw.below(12) {
        0 => (Plane { point: center, normal: n }.into(), Form::Flat, center),
        1 => {
            let inside = center + draw.between(0.0, 0.99 * size) * draw.direction();
            (Sphere { center, radius: size, inward: false }.into(), Form::Convex, inside)
        }
        2 => {
            let half = size * Vector::new(1.0, draw.decades(-3.0, 0.0), 0.5);
            let v = draw.vector(0.99);
            let [x, y, z] = [0, 1, 2].map(|i| v.along(i) * half.along(i));
            let inside = center + Vector::new(x, y, z);
            (Cuboid { min: center - half, max: center + half }.into(), Form::Convex, inside)
        }
        3 => {
            let far = center + (size * draw.decades(-5.0, 0.0)) * third;
            let vertices = [center, center + size * across, far];
            let (beta, gamma) = (draw.between(0.01, 0.49), draw.between(0.01, 0.49));
            let middle = center + (beta * (vertices[1] - center) + gamma * (far - center));
            (Triangle { vertices, normals: None }.into(), Form::Flat, middle)
        }
        4 => {
            let (a, b) = (size * across, size * third);
            let middle = center + (draw.between(0.01, 0.99) * a + draw.between(0.01, 0.99) * b);
            (Rectangle { corner: center, a, b }.into(), Form::Flat, middle)
        }
        5 => (Disk { center, normal: n, radius: size }.into(), Form::Flat, center),
        6 => {
            let y0 = center.y();
            let middle = Point::new(0.0, y0 + draw.between(0.1, 0.9) * size, 0.0);
            (
                OpenCylinder { y0, y1: y0 + size, radius: size, inward: false }.into(),
                Form::Tube,
                middle,
            )
        }
        8.. => round_part(draw, size, center),
        _ => {
            let sphere = TessellatedSphere { radius: size, ..TessellatedSphere::new(9, 6, false) };
            (sphere.into(), Form::Convex, Point::ORIGIN)
        }
    }
}

/// A range of azimuths, and one of them.
fn azimuths(draw: &mut Draw) -> ([f64; 2], f64) {
    let (from, width) = (draw.between(0.0, 360.0), draw.between(30.0, 350.0));
    let inside = from + draw.between(0.05, 0.95) * width;
    let to = from + width;
    ([from, if to > 360.0 { to - 360.0 } else { to }], inside)
}

/// An annulus, cone, paraboloid or part, as [`body`]; and a point of it.
fn round_part(draw: &mut Draw, size: f64, center: Point) -> (Kind, Form, Point) {
    let (phi, inside) = azimuths(draw);
    let u = Vector::new(sin_degrees(inside), 0.0, cos_degrees(inside));
    let share = draw.between(0.05, 0.95);
    let mut sizes = [size, size * draw.decades(-3.0, 0.0)];
    sizes.rotate_left(draw.below(2));
    let [height, radius] = sizes;
    let tall = |y: f64, rho: f64| Point::new(0.0, y, 0.0) + rho * u;
    match draw.below(6) {
        0 => {
            let normal: Vector = draw.direction().into();
            let across = normal.cross(draw.direction()).unit().expect("not parallel");
            let [inner_radius, outer_radius] = [0.25 * size, size];
            let point = center + (size * draw.between(0.3, 0.95)) * across;
            (Annulus { center, normal, inner_radius, outer_radius }.into(), Form::Flat, point)
        }
        1 => {
            let [inner_radius, outer_radius] = [0.25 * size, size];
            let point = center + (size * draw.between(0.3, 0.95)) * u;
            let normal = draw.sign() * Vector::Y;
            let part = PartAnnulus { center, normal, inner_radius, outer_radius, phi };
            (part.into(), Form::Flat, point)
        }
        2 => {
            let point = tall(height * share, radius * (1.0 - share));
            (Cone { height, radius, inward: false }.into(), Form::Tube, point)
        }
        3 => {
            let point = tall(height * share * share, radius * share);
            (Paraboloid { height, radius, inward: false }.into(), Form::Tube, point)
        }
        4 => {
            let theta = [draw.between(0.0, 60.0), draw.between(70.0, 180.0)];
            let polar = theta[0] + share * (theta[1] - theta[0]);
            let n = sin_degrees(polar) * u + cos_degrees(polar) * Vector::Y;
            let part = PartSphere { center, radius: size, phi, theta, inward: false };
            (part.into(), Form::Tube, center + size * n)
        }
        _ => {
            let (y0, y1) = (center.y(), center.y() + size);
            let part = PartCylinder { y0, y1, radius: size, phi, inward: false };
            (part.into(), Form::Tube, tall(y0 + share * size, size))
        }
    }
}

/// A hit of a ray through this point of the shape, from up to ten thousand sizes away or from within; `None`
/// if rounding makes it miss a thin shape.
pub fn random_hit(draw: &mut Draw, shape: &dyn Shape, aim: Point, size: f64) -> Option<Surface> {
    let distance = size * draw.decades(-1.0, 4.0);
    let away = draw.direction();
    let ray = Ray::new(aim + distance * away, (-draw.decades(-3.0, 3.0)) * away);
    shape.hit(&ray, Span::AHEAD).map(|hit| shape.surface(&ray, &hit))
}

/// Fails, naming the case, if a ray that leaves to the outer or to the inner side does not behave as the form
/// says. Where a body is thinner than 8 error bounds, its far wall may be skipped; returns whether it was.
pub fn check_leaving(
    draw: &mut Draw,
    kind: &Kind,
    shape: &dyn Shape,
    form: Form,
    s: &Surface,
    case: &str,
) -> bool {
    let mut skipped = false;
    for outward in [true, false] {
        let n = if outward { s.normal } else { -s.normal };
        let direction = draw.decades(-3.0, 3.0) * draw.leaving(n);
        let ray = Ray::new(s.leave(direction), direction);
        let again: Vec<f64> = shape.roots(&ray, Span::AHEAD).iter().map(|hit| hit.t).collect();
        let right = match form {
            Form::Convex if !outward => again.len() == 1,
            Form::Tube if !outward => again.len() <= 1,
            _ => again.is_empty(),
        };
        let steep = direction.dot(n) / direction.length();
        if !right && !outward && is_thin(kind, s) {
            skipped = true;
            continue;
        }
        assert!(
            right,
            "{case}: {ray:?} outward {outward}, slope {steep:e}: hits {again:?} of {s:?}"
        );
        let blocked = shape.shadow_hit(&ray, Span::AHEAD).is_some();
        assert_eq!(blocked, !again.is_empty(), "{case}: the shadow differs");
        check_next(&ray, n.into(), s, case);
    }
    skipped
}

/// Whether the far wall of a body is within 8 error bounds of a hit, along the normal. Oracle:
/// 512-bit arithmetic.
pub fn is_thin(kind: &Kind, s: &Surface) -> bool {
    oracle_shape(kind).is_some_and(|exact| walls_along_normal(&exact, s, 8.0 * s.error).len() > 1)
}

/// Fails, naming the case, if a plane parallel to the surface just beyond 8 error bounds is not hit.
pub fn check_next(ray: &Ray, n: Vector, s: &Surface, case: &str) {
    let anchor = s.point + (8.5 * s.error) * n;
    if (anchor - s.point).dot(n) <= 8.0 * s.error {
        return; // rounding has moved it nearer
    }
    let plane = Kind::from(Plane { point: anchor, normal: n });
    let plane = plane.build(&mut Context::default()).expect("valid");
    assert!(plane.hit(ray, Span::AHEAD).is_some(), "{case}: skips the plane just beyond {s:?}");
}

pub fn built(kind: &Kind) -> Arc<dyn Shape> {
    kind.build(&mut Context::default()).expect("valid")
}
