//! The torus: its equation and its closed forms.

use groundtruth::shapes::Torus;

use crate::prelude::*;

fn torus(swept_radius: f64, tube_radius: f64) -> Torus {
    Torus { swept_radius, tube_radius, inward: false }
}

fn ahead(shape: &dyn Shape, ray: &Ray) -> Vec<f64> {
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
    let shape = shape_of(torus(2.0, 0.5));
    let cases: [([f64; 3], [f64; 3], &[f64]); 5] = [
        ([-5.0, 0.0, 0.0], [1.0, 0.0, 0.0], &[2.5, 3.5, 6.5, 7.5]),
        ([0.0, 5.0, 2.0], [0.0, -1.0, 0.0], &[4.5, 5.5]),
        ([0.0, 5.0, 0.0], [0.0, -1.0, 0.0], &[]),
        ([2.0, 0.0, 0.0], [0.0, 0.0, 2.0], &[0.75]), // from inside: √(2.5² − 2²) = 1.5
        ([0.0, 0.0, 0.0], [0.0, 0.0, -1.0], &[1.5, 2.5]),
    ];
    for (origin, direction, expected) in cases {
        let ray = Ray::new(origin.into(), direction.into());
        assert_close(&ahead(&*shape, &ray), expected, 16.0 * U * 8.0, &format!("{ray:?}"));
    }
}

/// Law: rays through the hole of the torus of radii 0.9 and 0.1, on the axis and beside it, miss; a
/// quartic solver finds false roots there. Oracle: the radius of the hole.
/// Book: tori and their quartic equation.
#[test]
fn rays_through_the_hole_miss() {
    let mut draw = Draw::new(1950);
    let shape = shape_of(torus(0.9, 0.1));
    let axis = Ray::new(Point::new(0.0, 3.0, 0.0), -Vector::Y);
    assert_eq!(ahead(&*shape, &axis)[..], [0.0; 0]);
    for _ in 0..10_000 {
        // one point above the torus and one below, both within 0.8 of the axis, so the segment between
        // them is too
        let mut in_hole = |y: f64| {
            let [x, _, z] = (draw.between(0.0, 0.799) * across(draw.direction())).to_array();
            Point::new(x, y, z)
        };
        let (top, bottom) = (in_hole(0.1001), in_hole(-0.1001));
        let ray = Ray::new(bottom + 30.0 * (top - bottom), bottom - top);
        assert!(ahead(&*shape, &ray).is_empty(), "{ray:?}");
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
        let shape = shape_of(torus(a, b));
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
            assert_close(&ahead(&*shape, &ray), expected, tolerance, &format!("{i}: {a} {b} {z}"));
        }

        let rho = a + b * draw.between(-0.999, 0.999);
        let half = ((b - (rho - a)) * (b + (rho - a))).sqrt();
        let ray = Ray::new(Point::new(0.6 * rho, away, 0.8 * rho), -Vector::Y);
        let tolerance = allowed(a + b, away, half);
        let expected = [away - half, away + half];
        assert_close(&ahead(&*shape, &ray), &expected, tolerance, &format!("{i}: {a} {b} along"));
    }
}

/// Law: every hit of a torus obeys the book's equation, `(x² + y² + z² − a² − b²)² = 4a² (b² − y²)`, and
/// its normal is the gradient of it; a ray from outside crosses it an even number of times, one from inside the tube an
/// odd number. Oracle: the quartic, its central differences, and its sign at the ray's origin.
/// Book: tori and their quartic equation.
#[test]
fn hits_obey_the_quartic_and_normals_are_its_gradient() {
    let mut draw = Draw::new(1953);
    let (mut hits, mut inside) = (0, 0);
    for _ in 0..10_000 {
        let (a, b) = (draw.between(0.5, 2.0), draw.between(0.1, 0.9));
        let b = a * b;
        let f = |p: Point| {
            let [x, y, z] = p.to_array();
            let sum = x * x + y * y + z * z - a * a - b * b;
            (sum * sum - 4.0 * a * a * (b * b - y * y)) / (8.0 * a * a * b)
        };
        let shape = shape_of(torus(a, b));
        let ray = Ray::new(draw.point(1.5 * a), draw.vector(1.0));
        let count = ahead(&*shape, &ray).len();
        assert_eq!(count % 2 == 1, f(ray.origin) < 0.0, "{a} {b} {ray:?}");
        inside += count % 2;
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
    assert!(hits > 2_000 && inside > 300, "{hits} {inside}");
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
    let thin = shape_of(torus(0.5, 0.05));
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
    let narrow = shape_of(torus(25.0, 0.02));
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
