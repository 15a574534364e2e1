//! Cones, paraboloids, and the quadrics that are instances: closed forms.

use std::fs;

use groundtruth::shapes::{Annulus, Cone, Paraboloid};

use super::parts::{built, some_ray, ts};
use crate::prelude::*;

/// Tolerance for coordinates near 1: less than a thousand roundings.
const CLOSE: f64 = 1e-13;

/// Law: every hit of a cone obeys `(h/r)² (x² + z²) = (h − y)²` and `0 ≤ y ≤ h`; the normal is
/// perpendicular to the generator through the point, in the plane of the axis, and outward. Oracle:
/// the equation, and the line to the apex.
/// Book: spheres, cylinders and cones, convex and concave.
#[test]
fn cone_hits_obey_its_equation_and_normals_are_perpendicular_to_generators() {
    let mut draw = Draw::new(1940);
    let mut hits = 0;
    for _ in 0..10_000 {
        let (h, r) = (draw.between(0.2, 2.0), draw.between(0.2, 2.0));
        let cone = built(Cone { height: h, radius: r, inward: false });
        let ray = some_ray(&mut draw, 1.0);
        for root in cone.roots(&ray, Span::AHEAD) {
            let Surface { point, normal, .. } = cone.surface(&ray, &root);
            let [x, y, z] = point.to_array();
            near!((x * x + z * z) * h * h, (r * (h - y)) * (r * (h - y)), CLOSE);
            assert!((-CLOSE..=h + CLOSE).contains(&y), "{y} of {h}");
            let generator = Point::new(0.0, h, 0.0) - point;
            assert!(normal.dot(generator).abs() < CLOSE, "{normal:?} at {point:?}");
            let around = Vector::new(z, 0.0, -x);
            near!(normal.dot(around), 0.0, CLOSE);
            above!(normal.dot(point.to_vector().across_y()), 0.0);
            above!(normal.y(), 0.0);
            hits += 1;
        }
    }
    assert!(hits > 5_000, "{hits}");
}

/// Law: a point of the wall of a cone is hit; a point on the other half of the double cone or below the
/// base is not. Oracle: the point aimed at.
/// Book: spheres, cylinders and cones, convex and concave.
#[test]
fn a_point_of_the_wall_is_hit_and_one_beyond_its_ends_is_not() {
    let mut draw = Draw::new(1941);
    let (mut hits, mut misses) = (0, 0);
    for _ in 0..10_000 {
        let (h, r) = (draw.decades(-2.0, 2.0), draw.decades(-2.0, 2.0));
        let up = draw.between(-1.0, 2.0);
        if up.abs() < 1e-6 || (up - 1.0).abs() < 1e-6 {
            continue;
        }
        let across = draw.direction().across_y_unit();
        let point = Point::new(0.0, up * h, 0.0) + ((1.0 - up) * r) * across;
        let normal = Normal::new(h * across + Vector::new(0.0, r, 0.0)).expect("not zero");
        let away = draw.direction();
        if normal.dot(away).abs() < 0.05 {
            continue;
        }
        let ray = Ray::new(point + 2.0 * h.max(r) * away, -2.0 * h.max(r) * away);
        let found = ts(&*built(Cone { height: h, radius: r, inward: false }), &ray);
        let hit = found.iter().any(|t| (t - 1.0).abs() < 1e-9);
        let expected = (0.0..=1.0).contains(&up);
        assert_eq!(hit, expected, "at {up} of cone {h} {r}: {found:?}");
        *(if expected { &mut hits } else { &mut misses }) += 1;
    }
    assert!(hits > 1_000 && misses > 1_000, "{hits} {misses}");
}

trait Across {
    fn across_y_unit(self) -> Vector;
}

impl Across for Normal {
    fn across_y_unit(self) -> Vector {
        Vector::from(self).across_y().unit().unwrap_or(Vector::X)
    }
}

/// Law: a line parallel to a generator meets the cone once; a steep line meets this half once; a level
/// line above the apex does not meet it. Oracle: worked by hand (`|x| = 1 − y`).
/// Book: spheres, cylinders and cones, convex and concave.
#[test]
fn rays_along_generators_and_down_the_axis_meet_a_cone_once() {
    let cone = built(Cone { height: 1.0, radius: 1.0, inward: false });
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

/// Law: a cone with the disk of its base, and a paraboloid with its lid, are closed: every line meets
/// them an even number of times. Oracle: topology.
/// Book: compound objects.
#[test]
fn a_cone_and_its_base_are_closed() {
    let cone = built(Cone { height: 0.8, radius: 0.6, inward: false });
    let base = built(Disk { center: Point::ORIGIN, normal: -Vector::Y, radius: 0.6 });
    let bowl = built(Paraboloid { height: 0.8, radius: 0.6, inward: false });
    let lid = Point::new(0.0, 0.8, 0.0);
    let lid =
        built(Annulus { center: lid, normal: Vector::Y, inner_radius: 0.0, outer_radius: 0.6 });
    let mut draw = Draw::new(1942);
    let mut hits = [0; 2];
    for _ in 0..20_000 {
        let ray = some_ray(&mut draw, 0.8);
        for (i, (wall, end)) in [(&cone, &base), (&bowl, &lid)].into_iter().enumerate() {
            let crossings = ts(&**wall, &ray).len() + ts(&**end, &ray).len();
            assert!(crossings.is_multiple_of(2), "{crossings}: {ray:?} and {wall:?}");
            hits[i] += crossings;
        }
    }
    assert!(hits.iter().all(|&n| n > 10_000), "{hits:?}");
}

/// Law: cones and paraboloids, from very flat to very thin, end at their rim: a ray that crosses the
/// wall 10⁻¹¹ of its length inside the rim hits, and one as far outside misses. Rays are parallel to the
/// axis if the wall is flat, and perpendicular to it if the wall is steep. Oracle: the equation of the
/// wall: at the share `s` of the radius its height is `h (1 − s)` or `h s²`.
#[test]
fn flat_and_steep_walls_end_at_their_rim() {
    let mut draw = Draw::new(1945);
    for _ in 0..10_000 {
        let (height, radius) = (draw.decades(-8.0, 0.0), draw.decades(-8.0, 0.0));
        let cone = built(Cone { height, radius, inward: false });
        let bowl = built(Paraboloid { height, radius, inward: false });
        let angle = draw.between(0.0, 360.0);
        let out = Vector::new(sin_degrees(angle), 0.0, cos_degrees(angle));
        let (away, apart) = (draw.between(1.0, 2.0), 1e-11);
        for (share, hits) in [(1.0 - apart, 1), (1.0 + apart, 0)] {
            for (wall, y) in [(&cone, height * (1.0 - share)), (&bowl, height * share * share)] {
                let (at, from) = match height < radius {
                    true => (Point::ORIGIN + radius * share * out, away * Vector::Y),
                    false => (Point::new(0.0, y, 0.0), away * out),
                };
                // straight down through the wall, or only as far as the axis: one crossing
                let span = Span { min: 0.0, max: if height < radius { 2.0 } else { 1.0 } };
                let ray = Ray::new(at + from, -from);
                assert_eq!(wall.roots(&ray, span).len(), hits, "{wall:?}: {ray:?}");
            }
        }
    }
}

/// Law: every hit of a paraboloid obeys `y/h = (x² + z²)/r²`, `y ≤ h`, and light along its axis is
/// reflected through its focus, at `r²/4h`. Oracle: the equation, and optics.
#[test]
fn a_paraboloid_gathers_light_in_its_focus() {
    let mut draw = Draw::new(1943);
    let mut hits = 0;
    for _ in 0..10_000 {
        let (h, r) = (draw.between(0.2, 2.0), draw.between(0.2, 2.0));
        let mirror = built(Paraboloid { height: h, radius: r, inward: true });
        let ray = some_ray(&mut draw, 1.0);
        for root in mirror.roots(&ray, Span::AHEAD) {
            let Surface { point, normal, .. } = mirror.surface(&ray, &root);
            let [x, y, z] = point.to_array();
            near!(y / h, (x * x + z * z) / (r * r), CLOSE * 10.0);
            at_most!(y, h + CLOSE);
            let n = Vector::from(normal);
            let reflected = -Vector::Y + 2.0 * normal.dot(Vector::Y) * n;
            let focus = Point::new(0.0, r * r / (4.0 * h), 0.0);
            let miss = (focus - point).cross(reflected).length();
            assert!(miss < 100.0 * CLOSE, "{miss:e} beside the focus");
            above!(normal.y(), 0.0);
            hits += 1;
        }
    }
    assert!(hits > 4_000, "{hits}");
}

/// The example in the row of docs/book.md whose first cell is `of`.
fn example(of: &str) -> Kind {
    let map = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/book.md");
    let map = fs::read_to_string(map).expect("the map is there");
    let row = map.lines().find(|line| line.starts_with(&format!("| {of} |")));
    let code = row.and_then(|row| row.split('`').nth(1)).expect("the row has an example");
    toml::from_str(code).expect("the example is a shape")
}

/// Law: the ellipsoid in docs/book.md is `x²/4 + y²/9 + z² = 1`, its elliptic cylinder `x²/4 + z² = 1`
/// for `0 ≤ y ≤ 1`, its hemisphere the upper half of the unit sphere; the normal of each is the
/// gradient. Oracle: the equations.
#[test]
fn the_examples_of_the_map_are_the_quadrics_they_say() {
    let mut draw = Draw::new(1944);
    for (name, [a, b, c], low, high) in [
        ("ellipsoid", [0.25, 1.0 / 9.0, 1.0], -3.0, 3.0),
        ("elliptic cylinder", [0.25, 0.0, 1.0], 0.0, 1.0),
        ("hemisphere", [1.0, 1.0, 1.0], 0.0, 1.0),
    ] {
        let shape = built(example(name));
        let (mut hits, mut expected) = (0, 0);
        for _ in 0..5_000 {
            let ray = some_ray(&mut draw, 2.0);
            // the roots of the quadratic by the textbook formula, which is accurate enough near 1
            let ([ox, oy, oz], [dx, dy, dz]) = (ray.origin.to_array(), ray.direction.to_array());
            let qa = a * dx * dx + b * dy * dy + c * dz * dz;
            let qb = a * ox * dx + b * oy * dy + c * oz * dz;
            let qc = a * ox * ox + b * oy * oy + c * oz * oz - 1.0;
            let root = (qb * qb - qa * qc).sqrt();
            let on = |t: &f64| t.is_finite() && (low..=high).contains(&(oy + t * dy));
            let textbook = [(-qb - root) / qa, (-qb + root) / qa];
            expected += textbook.iter().filter(|t| on(t)).count();
            for root in shape.roots(&ray, Span::LINE) {
                let near = textbook.iter().any(|t| (t - root.t).abs() < 1e-6 * (1.0 + t.abs()));
                assert!(near, "{name}: {} of {textbook:?}", root.t);
                let Surface { point, normal, .. } = shape.surface(&ray, &root);
                let [x, y, z] = point.to_array();
                assert!(
                    (a * x * x + b * y * y + c * z * z - 1.0).abs() < 1e-12,
                    "{name} {point:?}"
                );
                let gradient = Normal::new(Vector::new(a * x, b * y, c * z)).expect("not zero");
                near!(Vector::from(gradient), Vector::from(normal), 1e-12);
                hits += 1;
            }
        }
        assert_eq!(hits, expected, "{name}");
        assert!(hits > 500, "{name}: {hits}");
    }
}
