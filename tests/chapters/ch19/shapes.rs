//! The shapes of chapter 19, checked against their equations and against each other.

use groundtruth::math::exact_cross;
use groundtruth::shapes::OpenCylinder;

use crate::prelude::*;
use crate::support::bodies::body;
use testkit::scaling::scaled;

fn built(kind: impl Into<Kind>) -> Arc<dyn Shape> {
    kind.into().build(&mut Context::default()).expect("valid")
}

fn first(shape: &dyn Shape, ray: &Ray) -> Option<(Candidate, Surface)> {
    let hit = shape.hit(ray, Span::AHEAD)?;
    Some((hit, shape.surface(ray, &hit)))
}

/// A ray aimed at a random point near the origin, at most about `extent` away.
fn some_ray(draw: &mut Draw, extent: f64) -> Ray {
    let target = draw.point(extent);
    let origin = target + draw.between(0.0, 4.0) * draw.direction();
    Ray::new(origin, draw.decades(-2.0, 2.0) * (target - origin))
}

/// Tolerance for coordinates near 1: less than a thousand roundings.
const CLOSE: f64 = 1e-13;

/// Law: every hit of a cylinder obeys `x² + z² = r²`, `y0 ≤ y ≤ y1`, and the normal is `(x, 0, z)/r`.
/// Oracle: the equation.
/// Book: spheres, cylinders and cones, convex and concave.
#[test]
fn cylinder_hits_obey_its_equation() {
    let cylinder = built(OpenCylinder { y0: -0.5, y1: 1.25, radius: 0.75, inward: false });
    let mut draw = Draw::new(1920);
    let mut hits = 0;
    for _ in 0..10_000 {
        let ray = some_ray(&mut draw, 1.0);
        for root in cylinder.roots(&ray, Span::AHEAD) {
            let Surface { point, normal, .. } = cylinder.surface(&ray, &root);
            let [x, y, z] = point.to_array();
            near!(x * x + z * z, 0.5625, CLOSE);
            at_least!(y, -0.5);
            at_most!(y, 1.25);
            near!(0.75 * normal, Vector::new(x, 0.0, z), CLOSE);
            below!(ray.at(root.t).distance(point), CLOSE * 100.0);
            hits += 1;
        }
    }
    above!(hits, 2_000);
}

/// Law: where the near root is beyond an end of the cylinder, the far one is found. Oracle: worked by
/// hand.
/// Book: spheres, cylinders and cones, convex and concave.
#[test]
fn the_far_wall_of_a_cylinder_is_seen_through_its_open_end() {
    let cylinder = built(OpenCylinder { y0: 0.0, y1: 1.0, radius: 1.0, inward: false });
    let ray = Ray::new(Point::new(-2.0, 2.0, 0.0), Vector::new(2.0, -1.0, 0.0));
    let (hit, surface) = first(&*cylinder, &ray).expect("the far wall");
    assert_eq!((hit.t, surface.normal), (1.5, Normal::X));
    assert_eq!(cylinder.roots(&ray, Span::AHEAD).len(), 1);
}

/// Law: a box has the hits and the outward normals of its six rectangles, from outside and from inside.
/// Oracle: the rectangles, one by one.
/// Book: boxes, triangles, rectangles and disks.
#[test]
fn a_box_equals_its_six_rectangles() {
    let (min, max) = (Point::new(-0.5, -1.0, 0.25), Point::new(1.0, 0.5, 1.5));
    let [x, y, z] = (max - min).to_array();
    let (x, y, z) = (x * Vector::X, y * Vector::Y, z * Vector::Z);
    let sides =
        [(min, y, x), (min, z, y), (min, x, z), (max, -y, -z), (max, -z, -x), (max, -x, -y)];
    let sides = sides.map(|(corner, a, b)| built(Rectangle { corner, a, b }));
    let cuboid = built(Cuboid { min, max });
    let mut draw = Draw::new(1921);
    let mut hits = 0;
    for _ in 0..10_000 {
        let ray = some_ray(&mut draw, 1.0);
        let mut found: Vec<(f64, Normal)> = Vec::new();
        for side in &sides {
            found.extend(first(&**side, &ray).map(|(hit, surface)| (hit.t, surface.normal)));
        }
        found.sort_by(|a, b| a.0.total_cmp(&b.0));
        let roots = cuboid.roots(&ray, Span::AHEAD);
        assert_eq!(roots.len(), found.len(), "{ray:?}");
        for (root, (t, normal)) in roots.iter().zip(found) {
            near!(root.t, t, CLOSE * t);
            below!((cuboid.surface(&ray, root).normal + -normal).length(), CLOSE);
            hits += 1;
        }
    }
    above!(hits, 2_000);
}

/// Law: barycentric coordinates reproduce the hit, and lie in [0, 1] with a sum up to 1. Oracle:
/// the vertices weighted.
/// Book: boxes, triangles, rectangles and disks.
#[test]
fn barycentric_coordinates_reproduce_the_hit() {
    let mut draw = Draw::new(1922);
    let mut hits = 0;
    for _ in 0..10_000 {
        let vertices @ [a, b, c] = [draw.point(1.0), draw.point(1.0), draw.point(1.0)];
        let triangle = built(Triangle { vertices, normals: None });
        let target = a + (draw.between(-0.2, 0.7) * (b - a) + draw.between(-0.2, 0.7) * (c - a));
        let origin = draw.point(4.0);
        let ray = Ray::new(origin, target - origin);
        let Some((hit, surface)) = first(&*triangle, &ray) else { continue };
        let [beta, gamma] = hit.parameters;
        at_least!(beta, 0.0);
        at_least!(gamma, 0.0);
        at_most!(beta + gamma, 1.0 + 4.0 * U);
        let weighted = a + (beta * (b - a) + gamma * (c - a));
        let slope = surface.normal.dot(ray.direction).abs() / ray.direction.length();
        let allowed = 1e-14 * (1.0 + 1.0 / slope) * 10.0 / (exact_cross(a, b, c).length()).min(1.0);
        assert!(weighted.distance(ray.at(hit.t)) < allowed.max(1e-9 * slope), "{ray:?}");
        below!(surface.point.distance(ray.at(hit.t)), allowed.max(1e-9 * slope));
        hits += 1;
    }
    above!(hits, 3_000);
}

/// Law: a disk and a rectangle are hit inside their border and not outside. Oracle: the point aimed at.
/// Book: boxes, triangles, rectangles and disks.
#[test]
fn disks_and_rectangles_end_at_their_borders() {
    let mut draw = Draw::new(1923);
    for _ in 0..10_000 {
        let n = draw.direction();
        let u = n.cross(draw.direction()).unit().expect("not parallel");
        let v = n.cross(u);
        let center = draw.point(2.0);
        let (f, g) = (draw.between(-0.5, 1.5), draw.between(-0.5, 1.5));
        let from = n * draw.sign() + draw.vector(2.0);
        let aimed = |target: Point| Ray::new(target + from, -from);
        if from.dot(n).abs() < 1e-3 {
            continue;
        }

        let disk = built(Disk { center, normal: 2.5 * n, radius: 1.0 });
        let hit = first(&*disk, &aimed(center + f * u));
        assert_eq!(hit.is_some(), f.abs() <= 1.0, "disk at {f}");

        let rectangle = built(Rectangle { corner: center, a: 2.0 * u, b: 0.5 * v });
        let hit = first(&*rectangle, &aimed(center + (f * (2.0 * u) + g * (0.5 * v))));
        let inside = (0.0..=1.0).contains(&f) && (0.0..=1.0).contains(&g);
        assert_eq!(hit.is_some(), inside, "rectangle at {f}, {g}");
        if let Some((hit, surface)) = hit {
            near!(hit.t, 1.0, 1e-11);
            below!((surface.normal + -n).length(), CLOSE);
        }
    }
}

/// Law: two triangles that share an edge leave no gap, whichever way they are wound. Oracle: the
/// points of the edge that rays are aimed at.
/// Book: boxes, triangles, rectangles and disks.
#[test]
fn two_triangles_that_share_an_edge_leave_no_gap() {
    let mut draw = Draw::new(1924);
    for _ in 0..20_000 {
        let n = draw.direction();
        let u = n.cross(draw.direction()).unit().expect("not parallel");
        let v = n.cross(u);
        let a = draw.point(3.0);
        let b = a + draw.decades(-2.0, 1.0) * u;
        let side = |draw: &mut Draw, s: f64| {
            a + (draw.between(-1.0, 2.0) * (b - a) + (s * draw.decades(-5.0, 0.0)) * v)
        };
        let (c, d) = (side(&mut draw, 1.0), side(&mut draw, -1.0));
        let turned = if draw.coin() { [a, b, d] } else { [b, a, d] };
        let pair = [[a, b, c], turned].map(|vertices| built(Triangle { vertices, normals: None }));
        let target = a + draw.between(0.01, 0.99) * (b - a);
        let origin = target + draw.decades(-1.0, 3.0) * draw.direction();
        let ray = Ray::new(origin, target - origin);
        if ray.direction.dot(n).abs() < 1e-6 * ray.direction.length() {
            continue;
        }
        let found = pair.iter().any(|triangle| triangle.hit(&ray, Span::AHEAD).is_some());
        assert!(found, "a gap at {target:?} of {a:?} {b:?} for {ray:?}");
    }
}

/// Law: `t` is measured in lengths of the direction: with a direction four times as long each `t` is a
/// quarter, and with the opposite direction it is negated, bit for bit. Oracle: arithmetic.
#[test]
fn t_is_inverse_to_the_length_of_the_direction() {
    let mut draw = Draw::new(1925);
    let mut hits = 0;
    for _ in 0..20_000 {
        let (kind, _, middle) = body(&mut draw, 1.0);
        let shape = built(kind);
        let origin = middle + draw.between(0.0, 5.0) * draw.direction();
        let ray = Ray::new(origin, middle - origin);
        let fast = Ray::new(origin, 4.0 * ray.direction);
        let back = Ray::new(origin, -ray.direction);
        let ts = |ray: &Ray| -> Vec<f64> {
            shape.roots(ray, Span::LINE).iter().map(|root| root.t).collect()
        };
        let plain = ts(&ray);
        assert_eq!(ts(&fast), plain.iter().map(|t| 0.25 * t).collect::<Vec<_>>());
        assert_eq!(ts(&back), plain.iter().rev().map(|t| -t).collect::<Vec<_>>());
        hits += plain.len();
    }
    above!(hits, 10_000);
}

/// Law: scaling a shape by a power of two scales all its distances and points by the same factor, bit
/// for bit. Oracle: arithmetic.
#[test]
fn shapes_scale_exactly_by_powers_of_two() {
    let mut draw = Draw::new(1926);
    for _ in 0..10_000 {
        let (kind, _, middle) = body(&mut draw, 1.0);
        let factor = draw.pick(&[1.0 / 1_048_576.0, 0.5, 2.0, 65_536.0]);
        let (shape, larger) = (built(kind.clone()), built(scaled(&kind, factor)));
        let origin = middle + draw.between(0.0, 5.0) * draw.direction();
        let ray = Ray::new(origin, draw.direction() + 2.0 * (middle - origin));
        let large = Ray::new(origin.scaled(factor), ray.direction);
        let (a, b) = (first(&*shape, &ray), first(&*larger, &large));
        assert_eq!(a.is_some(), b.is_some());
        if let (Some((a, p)), Some((b, q))) = (a, b) {
            assert_eq!((a.t * factor, a.part, a.parameters), (b.t, b.part, b.parameters));
            assert_eq!((p.point.scaled(factor), p.normal), (q.point, q.normal));
            assert_eq!(p.error * factor, q.error);
        }
    }
}

/// Law: a ray in the plane of a flat shape, or parallel to it, misses it, whatever the signs of its
/// zeros. Oracle: convention.
#[test]
fn a_ray_in_the_plane_misses() {
    let flat: [Arc<dyn Shape>; 3] = [
        built(Disk { center: Point::ORIGIN, normal: Vector::Y, radius: 1.0 }),
        built(Rectangle { corner: Point::ORIGIN, a: Vector::X, b: Vector::Z }),
        built(Triangle {
            vertices: [Point::ORIGIN, Point::new(1.0, 0.0, 0.0), Point::new(0.0, 0.0, 1.0)],
            normals: None,
        }),
    ];
    for shape in flat {
        for zero in [0.0, -0.0] {
            for height in [zero, 0.5] {
                let ray = Ray::new(Point::new(-1.0, height, 0.25), Vector::new(1.0, zero, 0.125));
                assert!(shape.roots(&ray, Span::LINE).is_empty(), "{shape:?}");
            }
        }
    }
}

/// Law: the bounding box of a shape contains every hit. Oracle: comparison, with a margin of a few
/// roundings.
/// Book: listing 19.1, the bounding box.
#[test]
fn bounds_contain_every_hit() {
    let mut draw = Draw::new(1927);
    for _ in 0..20_000 {
        let (kind, _, middle) = body(&mut draw, 1.0);
        let shape = built(kind);
        let origin = middle + draw.between(0.0, 5.0) * draw.direction();
        let ray = Ray::new(origin, (middle - origin) + 0.1 * draw.direction());
        for root in shape.roots(&ray, Span::LINE) {
            let point = shape.surface(&ray, &root).point;
            assert!(shape.bounds().padded().contains(point), "{shape:?}: {point:?}");
        }
    }
}

/// Law: the normal of a sphere is the gradient of `|p − c|²`. Oracle: central differences.
/// Book: spheres, cylinders and cones, convex and concave.
#[test]
fn normals_of_spheres_are_gradients() {
    let mut draw = Draw::new(1928);
    for _ in 0..2_000 {
        let (center, radius) = (draw.point(2.0), draw.between(0.2, 2.0));
        let shape = built(Sphere { center, radius, inward: false });
        let origin = draw.point(9.0);
        let ray = Ray::new(origin, center + draw.vector(0.5 * radius) - origin);
        let (_, Surface { point, normal, .. }) = first(&*shape, &ray).expect("aimed inside");
        let h = 1e-5 * radius;
        let f = |v: Vector| (point + v).distance_squared(center);
        let slope = |v: Vector| (f(h * v) - f(-h * v)) / (2.0 * h);
        let gradient = Vector::new(slope(Vector::X), slope(Vector::Y), slope(Vector::Z));
        near!(Vector::from(normal), (0.5 / radius) * gradient, 1e-7);
    }
}
