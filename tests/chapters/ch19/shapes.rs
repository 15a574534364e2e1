//! The shapes of chapter 19, checked against their equations and against each other.

use std::fs;

use groundtruth::math::exact_cross;
use groundtruth::shapes::{Cone, OpenCylinder, Paraboloid};
use testkit::cases::with_field;

use crate::prelude::*;

/// Tolerance for coordinates near 1: less than a thousand roundings.
const CLOSE: f64 = 1e-13;

/// The shape of `a x² + b y² + c z² + 2 e y + f = 0` between two heights.
struct Quadric {
    kind: Kind,
    squares: [f64; 3],
    e: f64,
    f: f64,
    heights: [f64; 2],
}

/// A sphere, cylinder, cone and paraboloid of random sizes, and the quadrics of docs/book.md.
fn quadrics(draw: &mut Draw) -> [Quadric; 7] {
    let (h, r) = (draw.between(0.2, 2.0), draw.between(0.2, 2.0));
    let inward = false;
    let round = [1.0 / (r * r), 0.0, 1.0 / (r * r)];
    let of =
        |kind: Kind, squares, [e, f]: [f64; 2], heights| Quadric { kind, squares, e, f, heights };
    [
        of(
            Sphere { center: Point::new(0.0, h, 0.0), radius: r, inward }.into(),
            [1.0; 3],
            [-h, h * h - r * r],
            [-9.0, 9.0],
        ),
        of(
            OpenCylinder { y0: -h, y1: 0.5, radius: r, inward }.into(),
            round,
            [0.0, -1.0],
            [-h, 0.5],
        ),
        // (h/r)² (x² + z²) = (h − y)²
        of(
            Cone { height: h, radius: r, inward }.into(),
            [round[0], -1.0 / (h * h), round[2]],
            [1.0 / h, -1.0],
            [0.0, h],
        ),
        // y/h = (x² + z²)/r²
        of(Paraboloid { height: h, radius: r, inward }.into(), round, [-0.5 / h, 0.0], [0.0, h]),
        of(example("ellipsoid"), [0.25, 1.0 / 9.0, 1.0], [0.0, -1.0], [-3.0, 3.0]),
        of(example("elliptic cylinder"), [0.25, 0.0, 1.0], [0.0, -1.0], [0.0, 1.0]),
        of(example("hemisphere"), [1.0; 3], [0.0, -1.0], [0.0, 1.0]),
    ]
}

/// The example in the row of docs/book.md whose first cell is `of`.
fn example(of: &str) -> Kind {
    let map = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/book.md");
    let map = fs::read_to_string(map).expect("the map is there");
    let row = map.lines().find(|line| line.starts_with(&format!("| {of} |")));
    let code = row.and_then(|row| row.split('`').nth(1)).expect("the row has an example");
    toml::from_str(code).expect("the example is a shape")
}

/// Law: a sphere, an open cylinder, a cone, a paraboloid and the quadrics of docs/book.md are hit where the quadratic of
/// their equation has roots between their ends, the far one also where the near one is beyond an end; the normal is
/// the gradient. Oracle: the equations, and the textbook formula for their roots.
/// Book: spheres, cylinders and cones, convex and concave.
#[test]
fn quadrics_are_hit_at_the_roots_between_their_ends() {
    let mut draw = Draw::new(1940);
    let mut hits = [0; 7];
    for _ in 0..1_000 {
        let all = quadrics(&mut draw);
        for (i, Quadric { kind, squares, e, f, heights: [low, high] }) in
            all.into_iter().enumerate()
        {
            let shape = shape_of(kind.clone());
            for _ in 0..5 {
                let ray = some_ray(&mut draw, 1.5);
                let (o, d) = (ray.origin.to_array(), ray.direction.to_array());
                let sum =
                    |of: &dyn Fn(usize) -> f64| (0..3).map(|k| squares[k] * of(k)).sum::<f64>();
                let a = sum(&|k| d[k] * d[k]);
                let b = sum(&|k| o[k] * d[k]) + e * d[1];
                let c = sum(&|k| o[k] * o[k]) + 2.0 * e * o[1] + f;
                let root = (b * b - a * c).sqrt();
                let is_between = |t: &f64| (low..=high).contains(&(o[1] + t * d[1]));
                let mut expected = vec![(-b - root) / a, (-b + root) / a];
                expected.retain(|t| t.is_finite() && is_between(t));
                expected.sort_by(f64::total_cmp);
                let found = shape.roots(&ray, Span::LINE);
                assert_eq!(found.len(), expected.len(), "{kind:?}: {found:?}, not {expected:?}");
                for (at, t) in found.iter().zip(expected) {
                    near!(at.t, t, 1e-6 * (1.0 + t.abs()), "{kind:?}");
                    let Surface { point, normal, .. } = shape.surface(&ray, at);
                    let p = point.to_array();
                    let gradient =
                        Vector::from([0, 1, 2].map(|k| squares[k] * p[k])) + e * Vector::Y;
                    let off = sum(&|k| p[k] * p[k]) + 2.0 * e * p[1] + f;
                    near!(off / gradient.length(), 0.0, CLOSE, "{kind:?} at {point:?}");
                    let gradient = gradient.unit().expect("not zero");
                    near!(Vector::from(normal), gradient, 1e-11, "{kind:?} at {point:?}");
                    hits[i] += 1;
                }
            }
        }
    }
    assert!(hits.iter().all(|&n| n > 1_000), "{hits:?}");
}

/// Law: a line parallel to a generator meets the cone once; a steep line meets this half once; a level
/// line above the apex does not meet it. Oracle: worked by hand (`|x| = 1 − y`).
/// Book: spheres, cylinders and cones, convex and concave.
#[test]
fn rays_along_generators_and_down_the_axis_meet_a_cone_once() {
    let cone = shape_of(Cone { height: 1.0, radius: 1.0, inward: false });
    let along = |o: [f64; 3], d: [f64; 3]| ts(&*cone, &Ray::new(o.into(), d.into()));
    assert_eq!(along([-2.0, 2.0, 0.0], [1.0, -1.0, 0.0]), [1.5]);
    assert_eq!(along([2.0, 2.0, 0.0], [-2.0, -2.0, 0.0]), [0.75]);
    assert_eq!(along([0.25, 5.0, 0.0], [0.0, -1.0, 0.0]), [4.25]);
    assert_eq!(along([0.25, -5.0, 0.0], [0.0, 1.0, -0.0]), [5.75]);
    assert_eq!(along([-5.0, 1.5, 0.0], [1.0, 0.0, 0.0]), [0.0; 0]);
    assert_eq!(along([-5.0, 0.5, 0.0], [1.0, 0.0, 0.0]), [4.5, 5.5]);
    // in the wall itself, and level through the apex: the apex counts once
    assert_eq!(along([1.0, 0.0, 0.0], [-0.5, 0.5, 0.0]), [2.0]);
    assert_eq!(along([0.0, -1.0, 2.0], [0.0, 1.0, -1.0]), [2.0]);
    assert_eq!(along([-3.0, 1.0, 0.0], [1.0, 0.0, 0.0]), [3.0]);
    // through the other half of the double cone, which is not part of the shape
    assert_eq!(along([0.0, 1.25, 0.0], [0.5, -1.5, 0.0]), [0.25]);
}

/// Law: convex and concave twins are hit at the same points, with opposite normals. Oracle: each
/// other, bit for bit.
/// Book: spheres, cylinders and cones, convex and concave.
#[test]
fn inward_twins_have_the_same_hits_and_opposite_normals() {
    let mut draw = Draw::new(1936);
    let mut kinds = 0;
    for entry in Kind::ENTRIES {
        let specimens = (entry.specimens)();
        let mut hits = 0;
        let twins =
            |kind| Some([with_field(kind, "inward", false)?, with_field(kind, "inward", true)?]);
        for twins in specimens.iter().filter_map(twins) {
            let twins = twins.map(shape_of);
            assert_eq!(twins[0].bounds(), twins[1].bounds());
            for _ in 0..1_000 {
                let ray = line(&mut draw, &*twins[0]);
                let [roots, same] = twins.each_ref().map(|twin| twin.roots(&ray, Span::LINE));
                assert_eq!(roots, same);
                for root in roots {
                    let [out, inward] = twins.each_ref().map(|twin| twin.surface(&ray, &root));
                    let turned = Surface { normal: -out.normal, shading: -out.shading, ..out };
                    let border = inward.border.clone();
                    assert_eq!(Surface { border, ..turned }, inward);
                    hits += 1;
                }
            }
            kinds += usize::from(hits > 300);
        }
    }
    at_least!(kinds, 8);
}

/// Law: the bounding box of a shape contains every hit, and that of an instance of it the hits of the instance. Oracle:
/// comparison, with a margin of a few roundings.
/// Book: listing 19.1, the bounding box.
#[test]
fn bounds_contain_every_hit() {
    let mut draw = Draw::new(1927);
    for kind in Kind::ENTRIES.iter().flat_map(|entry| (entry.specimens)()) {
        let steps = vec![
            Step::Scale(Vector::new(0.5, -2.0, 3.0)),
            Step::RotateX(draw.between(-180.0, 180.0)),
            Step::Shear([0.0, draw.between(-0.5, 0.5), 0.0, 0.0, draw.between(-0.5, 0.5), 0.0]),
            Step::RotateY(draw.between(-180.0, 180.0)),
            Step::Translate(draw.vector(2.0)),
        ];
        for kind in [kind.clone(), Instance::new(kind, steps).into()] {
            let shape = shape_of(kind.clone());
            let bounds = shape.bounds();
            for _ in 0..if bounds.is_bounded() { 500 } else { 0 } {
                let ray = line(&mut draw, &*shape);
                for root in shape.roots(&ray, Span::LINE) {
                    let point = shape.surface(&ray, &root).point;
                    assert!(bounds.padded().contains(point), "{kind:?}: {point:?}");
                }
            }
        }
    }
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
    let sides = sides.map(|(corner, a, b)| shape_of(Rectangle { corner, a, b }));
    let cuboid = shape_of(Cuboid { min, max });
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
        let triangle = shape_of(Triangle { vertices, normals: None });
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

        let disk = shape_of(Disk { center, normal: 2.5 * n, radius: 1.0 });
        let hit = first(&*disk, &aimed(center + f * u));
        assert_eq!(hit.is_some(), f.abs() <= 1.0, "disk at {f}");

        let rectangle = shape_of(Rectangle { corner: center, a: 2.0 * u, b: 0.5 * v });
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
        let pair =
            [[a, b, c], turned].map(|vertices| shape_of(Triangle { vertices, normals: None }));
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
