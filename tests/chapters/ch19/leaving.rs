//! Leaving a surface: no ray meets again the point it starts from, and none skips what comes next.

use std::ops::Range;
use std::sync::Arc;

use groundtruth::math::{Point, Ray, Span, Vector, cos_degrees, sin_degrees};
use groundtruth::shapes::{
    Annulus, Box, Cone, Context, Disk, Kind, OpenCylinder, Paraboloid, PartAnnulus, PartCylinder,
    PartSphere, Plane, Rectangle, Shape, Sphere, Surface, TessellatedSphere, Triangle,
};
use groundtruth::verify::Draw;

use crate::exact::{exact, walls_along_normal};
use crate::leaving::check_kinds;
use crate::support::U;

/// How often a ray that leaves meets the shape again.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Form {
    /// Never.
    Flat,
    /// Once to the inside, never to the outside.
    Convex,
    /// As convex, but through the open ends.
    Tube,
}

/// A shape of this size, placed up to a thousand sizes from the origin; and a point of it or
/// inside.
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
            (Box { min: center - half, max: center + half }.into(), Form::Convex, inside)
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

/// A hit of a ray through this point of the shape, from up to ten thousand sizes away or from
/// within; `None` where rounding makes it miss a thin one.
pub fn random_hit(draw: &mut Draw, shape: &dyn Shape, aim: Point, size: f64) -> Option<Surface> {
    let distance = size * draw.decades(-1.0, 4.0);
    let away = draw.direction();
    let ray = Ray::new(aim + distance * away, (-draw.decades(-3.0, 3.0)) * away);
    shape.hit(&ray, Span::AHEAD).map(|hit| shape.surface(&ray, &hit))
}

/// Ends with the case if the ray that leaves in a direction on the outer (or inner) side does not
/// do what the form says. Where a body is thinner than 8 error bounds, its far wall may be skipped:
/// says whether it was.
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
    exact(kind).is_some_and(|exact| walls_along_normal(&exact, s, 8.0 * s.error).len() > 1)
}

/// Ends with the case if a plane parallel to the surface just beyond 8 error bounds is not found.
pub fn check_next(ray: &Ray, n: Vector, s: &Surface, case: &str) {
    let anchor = s.point + (8.5 * s.error) * n;
    if (anchor - s.point).dot(n) <= 8.0 * s.error {
        return; // rounding has moved it nearer
    }
    let plane = Kind::from(Plane { point: anchor, normal: n });
    let plane = plane.build(&mut Context::default()).expect("valid");
    assert!(plane.hit(ray, Span::AHEAD).is_some(), "{case}: skips what lies beyond {s:?}");
}

fn built(kind: &Kind) -> Arc<dyn Shape> {
    kind.build(&mut Context::default()).expect("valid")
}

fn check_shapes(cases: Range<usize>, seed: u64) {
    let count = cases.len();
    let (mut largest, mut hits) = (0.0_f64, 0);
    for i in cases {
        let mut draw = Draw::case(seed, i);
        let size = draw.decades(-6.0, 6.0);
        let (kind, form, middle) = body(&mut draw, size);
        let shape = built(&kind);
        let Some(surface) = random_hit(&mut draw, &*shape, middle, size) else { continue };
        hits += 1;
        let case = format!("case {i}: {kind:?}");
        let coordinates = surface.point.to_vector().max_abs() + size;
        largest = largest.max(surface.error / (U * coordinates));
        assert!(
            surface.error <= MOST * U * coordinates,
            "{case}: the bound {surface:?} is too wide"
        );
        let skipped = check_leaving(&mut draw, &kind, &*shape, form, &surface, &case);
        assert!(!skipped, "{case}: none of these is so thin");
    }
    assert!(10 * hits > 8 * count, "only {hits} hits");
    println!("widest bound: {largest:.1} u of the coordinates");
}

/// Error bounds may be a few dozen roundings of the largest coordinate or size, no more.
const MOST: f64 = 100.0;

/// Law: a ray that leaves a surface does not meet it again at the same place, finds the far side of
/// what it is inside of and whatever lies beyond 8 error bounds; at scales from 1e-6 to 1e6 and
/// down to 1e-9 of grazing. Oracle: how often a line meets convex and flat shapes.
#[test]
fn a_ray_that_leaves_does_not_meet_the_same_point_again() {
    check_shapes(0..40_000, 1900);
}

/// The same, four million cases.
#[test]
#[ignore = "cost: cargo test ch19 -- --ignored"]
fn rays_leave_thoroughly() {
    check_shapes(0..4_000_000, 1901);
}

/// Law: a segment between two points of a convex surface, offset at both ends, meets nothing, down
/// to points a millionth of the size apart. Oracle: convexity.
#[test]
fn a_shadow_segment_is_free_of_both_its_ends() {
    let mut draw = Draw::new(1902);
    let mut checked = 0;
    for i in 0..60_000 {
        let size = draw.decades(-6.0, 6.0);
        let (kind, form, middle) = body(&mut draw, size);
        if form == Form::Flat {
            continue;
        }
        let shape = built(&kind);
        let Some(p) = random_hit(&mut draw, &*shape, middle, size) else { continue };
        // another point of the surface, as near as that: across from one beside it, inside
        let inside = p.point - (size * draw.decades(-6.0, -1.0)) * p.normal;
        let other = Ray::new(inside, draw.leaving(p.normal));
        let Some(hit) = shape.hit(&other, Span::AHEAD) else { continue };
        let q = shape.surface(&other, &hit);
        let line = q.point - p.point;
        let same_face = form != Form::Tube && p.normal.dot(line) >= -1e-12 * size;
        if same_face || line.length() < 1e-6 * size || q.normal.dot(line) <= 1e-12 * size {
            continue; // in a face of a box: the chord lies in the surface
        }
        if p.normal.dot(line) >= -1e-12 * size {
            continue; // along a generator
        }
        let (from, to) = (p.leave(line), q.leave(-line));
        let segment = Ray::new(from, to - from);
        let blocked = shape.shadow_hit(&segment, Span::SEGMENT);
        assert_eq!(blocked, None, "case {i}: {kind:?} between {p:?} and {q:?}");
        checked += 1;
    }
    assert!(checked > 10_000, "only {checked} segments");
}

/// Law: between two parallel planes as near as 1e-9 of their distance from the origin a segment
/// meets neither, and a third one half-way is found. Oracle: geometry.
#[test]
fn a_shadow_segment_between_planes_meets_only_what_is_between() {
    let mut draw = Draw::new(1903);
    for i in 0..20_000 {
        let size = draw.decades(-6.0, 6.0);
        let place = draw.point(size);
        let n = draw.direction();
        let gap = size * draw.decades(-9.0, 0.0);
        let plane = |point| built(&Plane { point, normal: n.into() }.into());
        let [low, middle, high] = [0.0, 0.5, 1.0].map(|f| plane(place + (f * gap) * n));
        let aim = draw.leaving(n);
        let down = Ray::new(place + (10.0 * gap) * n, -aim);
        let up = Ray::new(place - (10.0 * gap) * n, draw.leaving(n));
        let surface = |shape: &Arc<dyn Shape>, ray: &Ray| {
            shape.hit(ray, Span::AHEAD).map(|hit| shape.surface(ray, &hit))
        };
        let (Some(p), Some(q)) = (surface(&low, &down), surface(&high, &up)) else {
            panic!("case {i}: a plane is missed")
        };
        if p.point.to_vector().max_abs() > 4.0 * size || q.point.to_vector().max_abs() > 4.0 * size
        {
            continue; // the segment itself is rounded by more than the bound of its nearer end
        }
        let line = q.point - p.point;
        let (from, to) = (p.leave(line), q.leave(-line));
        let segment = Ray::new(from, to - from);
        let hits = [&low, &middle, &high].map(|s| s.shadow_hit(&segment, Span::SEGMENT).is_some());
        assert_eq!(hits, [false, true, false], "case {i}: gap {gap:e} of {size:e}: {p:?} to {q:?}");
    }
}

/// Law: every kind of the chapter is left for good, at scales from 1e-6 to 1e6, up to a thousand
/// sizes from the origin and down to 1e-9 of grazing: what a ray that leaves hits next it meets from the
/// side that it left to, and it finds whatever lies beyond 8 error bounds. Oracle: what is closed is
/// left and entered in turn.
#[test]
fn every_kind_of_the_chapter_is_left_for_good() {
    check_kinds("ch19", [40, 100], 1905);
}

/// The same, at a thousand scales.
#[test]
#[ignore = "cost: cargo test ch19 -- --ignored"]
fn every_kind_of_the_chapter_is_left_for_good_thoroughly() {
    check_kinds("ch19", [1000, 1000], 1906);
}
