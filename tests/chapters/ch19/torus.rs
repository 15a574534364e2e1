//! The torus: its equation, its closed forms, and rays that leave it.

use groundtruth::shapes::Torus;

use crate::prelude::*;
use crate::support::bodies::random_hit;

pub fn built(kind: impl Into<Kind>) -> Arc<dyn Shape> {
    kind.into().build(&mut Context::default()).expect("valid")
}

pub fn torus(swept_radius: f64, tube_radius: f64) -> Torus {
    Torus { swept_radius, tube_radius, inward: false }
}

pub fn ts(shape: &dyn Shape, ray: &Ray) -> Vec<f64> {
    shape.roots(ray, Span::AHEAD).iter().map(|root| root.t).collect()
}

fn assert_close(found: &[f64], expected: &[f64], tolerance: f64, case: &str) {
    let close = |(t, e): (&f64, &f64)| (t - e).abs() <= tolerance;
    let equal = found.len() == expected.len() && found.iter().zip(expected).all(close);
    assert!(equal, "{case}: {found:?}, not {expected:?}");
}

/// Law: the torus of radii 2 and 0.5 is met at t = 2.5, 3.5, 6.5 and 7.5 along x from x = −5, at 4.5 and
/// 5.5 straight down from (0, 5, 2), and nowhere along its axis. Oracle: worked by hand.
/// Book: tori and their quartic equation.
#[test]
fn a_torus_is_hit_where_arithmetic_says() {
    let shape = built(torus(2.0, 0.5));
    let cases: [([f64; 3], [f64; 3], &[f64]); 5] = [
        ([-5.0, 0.0, 0.0], [1.0, 0.0, 0.0], &[2.5, 3.5, 6.5, 7.5]),
        ([0.0, 5.0, 2.0], [0.0, -1.0, 0.0], &[4.5, 5.5]),
        ([0.0, 5.0, 0.0], [0.0, -1.0, 0.0], &[]),
        ([2.0, 0.0, 0.0], [0.0, 0.0, 2.0], &[0.75]), // from inside: √(2.5² − 2²) = 1.5
        ([0.0, 0.0, 0.0], [0.0, 0.0, -1.0], &[1.5, 2.5]),
    ];
    for (origin, direction, expected) in cases {
        let ray = Ray::new(origin.into(), direction.into());
        assert_close(&ts(&*shape, &ray), expected, 16.0 * U * 8.0, &format!("{ray:?}"));
    }
}

/// Law: rays through the hole of the torus of radii 0.9 and 0.1, on the axis and beside it, miss; a
/// quartic solver finds false roots there. Oracle: the radius of the hole.
/// Book: tori and their quartic equation.
#[test]
fn rays_through_the_hole_miss() {
    let mut draw = Draw::new(1950);
    let shape = built(torus(0.9, 0.1));
    let axis = Ray::new(Point::new(0.0, 3.0, 0.0), -Vector::Y);
    assert_eq!(ts(&*shape, &axis)[..], [0.0; 0]);
    for _ in 0..10_000 {
        // one point above the torus and one below, both within 0.8 of the axis, so the segment between
        // them is too
        let mut in_hole = |y: f64| {
            let [x, _, z] = (draw.between(0.0, 0.799) * across(draw.direction())).to_array();
            Point::new(x, y, z)
        };
        let (top, bottom) = (in_hole(0.1001), in_hole(-0.1001));
        let ray = Ray::new(bottom + 30.0 * (top - bottom), bottom - top);
        assert!(ts(&*shape, &ray).is_empty(), "{ray:?}");
    }
}

/// The unit vector of the normal's projection on the plane y = 0.
fn across(n: Normal) -> Vector {
    Vector::new(n.x(), 0.0, n.z()).unit().unwrap_or(Vector::X)
}

/// Tolerance for the closed forms: the rounding errors of radii and distance, larger where the ray
/// grazes.
fn allowed(size: f64, away: f64, half: f64) -> f64 {
    16.0 * U * (away + size) * (1.0 + size / half)
}

/// Law: the plane of its centre circle cuts a torus in two circles; a plane through its axis cuts it in
/// the circle of the tube. Thin tubes and thick ones, from near and far. Oracle: Pythagoras.
/// Book: tori and their quartic equation.
#[test]
fn a_torus_is_two_circles_across_and_along() {
    let mut draw = Draw::new(1951);
    for i in 0..10_000 {
        let a = draw.decades(-3.0, 3.0);
        let b = a * if draw.coin() { draw.decades(-3.0, -0.1) } else { 0.999 };
        let shape = built(torus(a, b));
        let away = (a + b) * draw.decades(0.2, 4.0);

        let z = draw.between(0.0, a + b);
        let ray = Ray::new(Point::new(-away, 0.0, z), Vector::X);
        let half = |r: f64| if r > z { ((r - z) * (r + z)).sqrt() } else { 0.0 };
        let (outer, inner) = (half(a + b), half(a - b));
        let expected = [away - outer, away - inner, away + inner, away + outer];
        let smallest = if inner > 0.0 { inner } else { outer };
        let is_tangent = (z - (a - b)).abs() < 1e-6 * a || smallest < 1e-5 * a;
        if !is_tangent {
            let expected = if inner > 0.0 { &expected[..] } else { &[expected[0], expected[3]] };
            let tolerance = allowed(a + b, away, smallest);
            assert_close(&ts(&*shape, &ray), expected, tolerance, &format!("{i}: {a} {b} {z}"));
        }

        let rho = a + b * draw.between(-0.999, 0.999);
        let half = ((b - (rho - a)) * (b + (rho - a))).sqrt();
        let ray = Ray::new(Point::new(0.6 * rho, away, 0.8 * rho), -Vector::Y);
        let tolerance = allowed(a + b, away, half);
        let expected = [away - half, away + half];
        assert_close(&ts(&*shape, &ray), &expected, tolerance, &format!("{i}: {a} {b} along"));
    }
}

/// Law: rays that are tangent to the torus at its highest or outermost circle hit it if they are moved
/// inward by a tiny distance, and miss it if moved outward. Oracle: geometry.
#[test]
fn tangent_rays_hit_inside_and_miss_outside() {
    let mut draw = Draw::new(1952);
    for _ in 0..10_000 {
        let a = draw.decades(-2.0, 2.0);
        let b = a * draw.between(0.01, 0.99);
        let shape = built(torus(a, b));
        let hair = draw.decades(-13.0, -4.0);
        let u = across(draw.direction());
        let v = u.cross(Vector::Y);
        let from = |touched: Vector, along: Vector| {
            Ray::new(Point::ORIGIN + (touched + -3.0 * a * along), draw.pick(&[1.0, 0.25]) * along)
        };
        let mut from = from;
        for (out, expected) in [(1.0 - hair, 2), (1.0 + hair, 0)] {
            let top = from(a * u + Vector::new(0.0, out * b, 0.0), v);
            assert_eq!(ts(&*shape, &top).len(), expected, "top {out} {a} {b}");
            let outside = from((out * (a + b)) * u, v);
            assert_eq!(ts(&*shape, &outside).len(), expected, "outside {out} {a} {b}");
            let upright = from((out * (a + b)) * u, Vector::Y);
            assert_eq!(ts(&*shape, &upright).len(), expected, "upright {out} {a} {b}");
        }
    }
}

/// Law: every hit of a torus obeys the book's equation, `(x² + y² + z² − a² − b²)² = 4a² (b² − y²)`, and
/// its normal is the gradient of it. Oracle: the quartic, and its central differences.
/// Book: tori and their quartic equation.
#[test]
fn hits_obey_the_quartic_and_normals_are_its_gradient() {
    let mut draw = Draw::new(1953);
    let mut hits = 0;
    for _ in 0..10_000 {
        let (a, b) = (draw.between(0.5, 2.0), draw.between(0.1, 0.9));
        let b = a * b;
        let f = |p: Point| {
            let [x, y, z] = p.to_array();
            let sum = x * x + y * y + z * z - a * a - b * b;
            (sum * sum - 4.0 * a * a * (b * b - y * y)) / (8.0 * a * a * b)
        };
        let shape = built(torus(a, b));
        let ray = Ray::new(draw.point(5.0), draw.vector(1.0));
        for root in shape.roots(&ray, Span::LINE) {
            let surface = shape.surface(&ray, &root);
            let p = surface.point;
            assert!(f(p).abs() < 1e-13 * (1.0 + a / b), "{a} {b} {p:?}: {:e}", f(p));
            assert!(p.distance(ray.at(root.t)) < 1e-12 * (1.0 + a / b), "{a} {b} {p:?}");
            at_most!(surface.error, 100.0 * U * (a + b));
            let slope = |v: Vector| (f(p + 1e-6 * v) - f(p + -1e-6 * v)) / 2e-6;
            let gradient = Vector::new(slope(Vector::X), slope(Vector::Y), slope(Vector::Z));
            let gradient = gradient.unit().expect("regular");
            assert!((surface.normal + -gradient).length() < 1e-7, "{a} {b} {p:?}");
            hits += 1;
        }
    }
    assert!(hits > 2_000, "{hits}");
}

/// Law: a ray from outside crosses a torus an even number of times, one from inside the tube an odd
/// number. Oracle: topology; the distance of the origin from the centre circle tells whether it is
/// inside.
/// Book: tori and their quartic equation.
#[test]
fn outside_rays_cross_a_torus_an_even_number_of_times() {
    let mut draw = Draw::new(1954);
    let mut counts = [0; 5];
    for _ in 0..20_000 {
        let (a, b) = (1.0, draw.between(0.05, 0.95));
        let shape = built(torus(a, b));
        let (origin, d) = (draw.point(2.0), draw.vector(1.0));
        let rho = (origin.x() * origin.x() + origin.z() * origin.z()).sqrt();
        let inside = (rho - a) * (rho - a) + origin.y() * origin.y() < b * b;
        let count = ts(&*shape, &Ray::new(origin, d)).len();
        assert_eq!(count % 2 == 1, inside, "{b} {origin:?} {d:?}");
        counts[count] += 1;
    }
    assert!(counts.iter().all(|&n| n > 30), "{counts:?}");
}

/// Law: a torus whose normals point inward is hit at the same points, with opposite normals. Oracle: the
/// torus with outward normals.
/// Book: tori and their quartic equation.
#[test]
fn an_inward_torus_has_opposite_normals() {
    let mut draw = Draw::new(1955);
    let plain = torus(1.0, 0.4);
    let [out, inward] = [built(plain.clone()), built(Torus { inward: true, ..plain })];
    for _ in 0..5_000 {
        let ray = Ray::new(draw.point(3.0), draw.vector(1.0));
        let roots = out.roots(&ray, Span::LINE);
        assert_eq!(roots, inward.roots(&ray, Span::LINE));
        for root in roots {
            let [a, b] = [&out, &inward].map(|shape| shape.surface(&ray, &root));
            assert_eq!((a.point, a.error, a.normal), (b.point, b.error, -b.normal));
        }
    }
}

/// Law: a ray that leaves a torus, outward or into the tube, has the hits that it has in exact
/// arithmetic: not its starting point, but the next sheet, even where that is very near. Scales are from
/// 1e-6 to 1e6, tubes thin and thick, angles to the surface down to 1e-9. Oracle: 512-bit arithmetic.
#[test]
fn a_ray_that_leaves_a_torus_meets_what_an_exact_one_does() {
    let mut draw = Draw::new(1956);
    let mut next = 0;
    for i in 0..600 {
        let a = draw.decades(-6.0, 6.0);
        let b = a * if draw.coin() { draw.decades(-3.0, -0.01) } else { draw.between(0.1, 0.999) };
        let shape = built(torus(a, b));
        let aim = Point::ORIGIN + a * across(draw.direction());
        let Some(s) = random_hit(&mut draw, &*shape, aim, b) else { continue };
        for n in [s.normal, -s.normal] {
            let direction = draw.decades(-3.0, 3.0) * draw.leaving(n);
            let ray = Ray::new(s.leave(direction), direction);
            let found = ts(&*shape, &ray);
            let exact = oracle::intersect(
                &oracle::Shape::Torus { swept_radius: a, tube_radius: b },
                &oracle::Ray { origin: ray.origin.into(), direction: direction.into() },
            );
            let expected: Vec<f64> = exact.roots.iter().map(|root| root.t).collect();
            assert_eq!(found.len(), expected.len(), "case {i}: {a} {b} {ray:?}: {expected:?}");
            for (t, root) in found.iter().zip(&exact.roots) {
                assert!(root.t_error(*t) <= 100.0 * U * root.cond.max(root.t), "case {i}");
                next += 1;
            }
            let outward = n == s.normal;
            assert_eq!(
                found.len().is_multiple_of(2),
                outward,
                "case {i}: starts on the wrong side"
            );
        }
    }
    assert!(next > 600, "{next}");
}

/// Law: hits are on the torus also for a line that runs along it in a direction of almost zero
/// curvature, a few roundings inside or outside the surface. Oracle: Euler's formula for the curvature
/// `cos²α/b + sin²α cosθ/ρ` in such a direction, and the distance from the tube.
#[test]
fn hits_of_lines_along_a_torus_are_on_it() {
    let mut draw = Draw::new(1957);
    let mut hits = 0;
    for i in 0..20_000 {
        let (a, b) = (1.0, draw.between(0.05, 0.95));
        let shape = built(torus(a, b));
        let radial = across(draw.direction());
        let theta = draw.between(110.0, 250.0);
        let (s, c) = (sin_degrees(theta), cos_degrees(theta));
        let (rho, n) = (a + b * c, c * radial + s * Vector::Y);
        let (along_tube, around) = (-s * radial + c * Vector::Y, Vector::Y.cross(radial));
        let flat = (rho / (-b * c)).sqrt() * (1.0 + draw.sign() * draw.decades(-6.0, -1.0));
        let d = (along_tube + (draw.sign() * flat) * around).unit().expect("not zero");
        let off = draw.between(-8.0, 8.0) * U * (a + b);
        let near = Point::ORIGIN + a * radial + (b + off) * n;
        let ray = Ray::new(near + draw.between(-1.0, 0.0) * d, d);
        for root in shape.roots(&ray, Span::LINE) {
            let p = ray.at(root.t);
            let [rho, y] = [p.to_vector().across_y().length(), p.y()];
            let beside = ((rho - a) * (rho - a) + y * y).sqrt() - b;
            assert!(beside.abs() <= 32.0 * U * (a + b), "case {i}: {b} {ray:?}: {beside:e}");
            hits += 1;
        }
    }
    assert!(hits > 20_000, "{hits}");
}

/// Law: radii that make no torus are refused; the message names the field and what is needed.
#[test]
fn radii_that_make_no_torus_are_refused() {
    let text = |torus: Torus| {
        let kind = Kind::from(torus);
        kind.build(&mut Context::default()).expect_err("no torus").to_string()
    };
    assert_eq!(
        text(torus(1.0, 1.0)),
        "torus.tube_radius: found 1, but it must be less than swept_radius, 1"
    );
    assert_eq!(
        text(torus(-1.0, 0.5)),
        "torus.swept_radius: found -1, but a positive, finite number is needed"
    );
    assert_eq!(
        text(torus(1.0, f64::NAN)),
        "torus.tube_radius: found NaN, but a positive, finite number is needed"
    );
}

/// Law: the point of a hit is on the torus, however far away the ray starts, even if rounding puts the
/// position along the ray on the axis or on the centre circle of the tube. Oracle: the distance from
/// that circle.
#[test]
fn points_of_hits_from_afar_are_on_the_torus() {
    let assert_on_torus = |surface: Surface, swept_radius: f64, tube_radius: f64, ray: &Ray| {
        let p = surface.point;
        let off = (p.x() * p.x() + p.z() * p.z()).sqrt() - swept_radius;
        let off = (off * off + p.y() * p.y()).sqrt() - tube_radius;
        assert!(off.abs() <= surface.error, "{p:?} is off by {off:e}: {ray:?}");
    };

    let mut draw = Draw::new(1957);
    let thin = built(torus(0.5, 0.05));
    let mut on_axis = 0;
    for case in 0..4_000 {
        let away = power(10.0, draw.between(0.0, 39.0));
        let whole = |x: f64| if case % 2 == 0 { x.round() } else { x };
        let from = Vector::new(whole(draw.between(-1.0, 1.0)), 0.0, whole(draw.between(-1.0, 1.0)));
        let Some(direction) = (-from).unit() else { continue };
        let ray = Ray::new(Point::ORIGIN - away * direction, direction);
        for hit in thin.roots(&ray, Span::AHEAD) {
            let raw = ray.at(hit.t);
            on_axis += usize::from(raw.x() == 0.0 && raw.z() == 0.0);
            assert_on_torus(thin.surface(&ray, &hit), 0.5, 0.05, &ray);
        }
    }
    assert!(on_axis > 100, "{on_axis}");

    // 7² + 24² = 25²: such a position can be exactly on the centre circle of the tube, though 25 times
    // the rounded 7 / 25 is not 7
    let narrow = built(torus(25.0, 0.02));
    let mut on_middle = 0;
    for (x, z) in [(7.0, 24.0), (24.0, 7.0), (-7.0, 24.0), (24.0, -7.0)] {
        for exponent in 44..48 {
            let direction = Vector::new(x, 0.0, z);
            let ray =
                Ray::new(Point::ORIGIN - power(2.0, f64::from(exponent)) * direction, direction);
            for hit in narrow.roots(&ray, Span::AHEAD) {
                let raw = ray.at(hit.t);
                on_middle += usize::from(raw.x() * raw.x() + raw.z() * raw.z() == 25.0 * 25.0);
                assert_on_torus(narrow.surface(&ray, &hit), 25.0, 0.02, &ray);
            }
        }
    }
    assert!(on_middle > 20, "{on_middle}");
}
