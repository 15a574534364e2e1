//! Algebraic surfaces: zero sets of polynomials that the user gives.

use groundtruth::shapes::{Algebraic, Term};

use super::torus::{built, torus, ts};
use crate::prelude::*;

fn surface(terms: &[(f64, [u32; 3])], half: f64) -> Algebraic {
    let terms = terms.iter().map(|&(coefficient, powers)| Term { coefficient, powers }).collect();
    let corner = Point::new(half, half, half);
    Algebraic { terms, min: corner.scaled(-1.0), max: corner }
}

/// The book's quartic of a torus, multiplied out.
fn quartic(a: f64, b: f64) -> Vec<(f64, [u32; 3])> {
    let k = a * a - b * b;
    let flat = 2.0 * k - 4.0 * a * a;
    vec![
        (1.0, [4, 0, 0]),
        (1.0, [0, 4, 0]),
        (1.0, [0, 0, 4]),
        (2.0, [2, 2, 0]),
        (2.0, [0, 2, 2]),
        (2.0, [2, 0, 2]),
        (flat, [2, 0, 0]),
        (2.0 * k, [0, 2, 0]),
        (flat, [0, 0, 2]),
        (k * k, [0, 0, 0]),
    ]
}

fn agree(polynomial: &dyn Shape, other: &Arc<dyn Shape>, draw: &mut Draw) -> usize {
    let mut hits = 0;
    for _ in 0..5_000 {
        let origin = draw.point(6.0);
        let ray = Ray::new(origin, draw.point(1.0) - origin);
        let (found, expected) = (polynomial.roots(&ray, Span::LINE), other.roots(&ray, Span::LINE));
        assert_eq!(found.len(), expected.len(), "{ray:?}: {found:?}, not {expected:?}");
        for (a, b) in found.iter().zip(&expected) {
            let [p, q] = [polynomial.surface(&ray, a), other.surface(&ray, b)];
            let slope = q.normal.dot(ray.direction).abs() / ray.direction.length();
            assert!(p.point.distance(q.point) < 1e-13 * (1.0 + 1.0 / slope), "{ray:?}");
            assert!((p.normal + -q.normal).length() < 1e-12 * (1.0 + 1.0 / slope), "{ray:?}");
            hits += 1;
        }
    }
    hits
}

/// Law: a sphere and a torus written as polynomials have the same hits and normals as the shapes
/// `Sphere` and `Torus`. Oracle: those shapes.
#[test]
fn polynomials_of_spheres_and_tori_are_spheres_and_tori() {
    let mut draw = Draw::new(1970);
    let squares = [[2, 0, 0], [0, 2, 0], [0, 0, 2]].map(|powers| (1.0, powers));
    let sphere = surface(&[&squares[..], &[(-0.5625, [0; 3])]].concat(), 1.0);
    let kind = Sphere { center: Point::ORIGIN, radius: 0.75, inward: false };
    above!(agree(&*built(sphere), &built(kind), &mut draw), 3_000);
    let ring = surface(&quartic(0.75, 0.25), 1.5);
    above!(agree(&*built(ring), &built(torus(0.75, 0.25)), &mut draw), 3_000);
}

/// Law: if up to eight parallel planes are the zero set of one polynomial, a ray hits every one of them,
/// also where they are close together. Oracle: the planes from which the polynomial is made.
#[test]
fn every_one_of_eight_sheets_is_hit() {
    let mut draw = Draw::new(1971);
    for _ in 0..2_000 {
        let mut heights: Vec<f64> = (0..8).map(|_| draw.below(65) as f64 / 16.0 - 2.0).collect();
        heights.sort_by(f64::total_cmp);
        heights.dedup();
        let product = heights.iter().fold(vec![1.0], |p: Vec<f64>, h| {
            let at = |i: usize| p.get(i).copied().unwrap_or(0.0);
            (0..=p.len()).map(|i| if i > 0 { at(i - 1) } else { 0.0 } - h * at(i)).collect()
        });
        let terms: Vec<_> =
            product.iter().enumerate().map(|(i, c)| (*c, [0, i as u32, 0])).collect();
        let shape = built(surface(&terms, 3.0));
        let (x, z, steep) =
            (draw.between(-1.0, 1.0), draw.between(-1.0, 1.0), draw.between(1.0, 4.0));
        let ray = Ray::new(Point::new(x, -8.0, z), Vector::new(0.0, steep, 0.1 * steep * z));
        let found = ts(&*shape, &ray);
        let inside = |t: f64| ray.at(t).z().abs() < 3.0;
        let expected: Vec<f64> = heights.iter().map(|h| (h + 8.0) / steep).collect();
        assert!(expected.iter().all(|&t| inside(t)), "{expected:?} along {ray:?}");
        assert_eq!(found.len(), expected.len(), "{heights:?}: {found:?}");
        for (t, e) in found.iter().zip(&expected) {
            // planes may be 1/16 apart: each of the seven others makes the root more sensitive to
            // rounding
            assert!((t - e).abs() < 1e-6, "{heights:?}: {t} for {e}");
        }
    }
}

/// Law: a hit obeys the equation within its error bound, inside the box, and the normal is the
/// gradient. Oracle: the polynomial and its central differences.
#[test]
fn hits_obey_the_polynomial_and_normals_are_its_gradient() {
    let mut draw = Draw::new(1972);
    let mut hits = 0;
    for _ in 0..2_000 {
        let terms: Vec<(f64, [u32; 3])> = (0..12)
            .map(|_| {
                let powers = [0; 3].map(|_: u32| draw.below(4) as u32);
                (draw.between(-1.0, 1.0), powers)
            })
            .collect();
        let power = |x: f64, n: u32| (0..n).fold(1.0, |product, _| product * x);
        let f = |p: Point| -> f64 {
            let term = |(c, [i, j, k]): &(f64, [u32; 3])| {
                c * power(p.x(), *i) * power(p.y(), *j) * power(p.z(), *k)
            };
            terms.iter().map(term).sum()
        };
        let Ok(shape) = Kind::from(surface(&terms, 1.5)).build(&mut Context::default()) else {
            continue;
        };
        for _ in 0..5 {
            let away = draw.decades(0.5, 5.0);
            let origin = draw.point(away);
            let ray = Ray::new(origin, draw.point(1.5) - origin);
            for root in shape.roots(&ray, Span::LINE) {
                let surface = shape.surface(&ray, &root);
                let p = surface.point;
                (0..3).for_each(|i| near!(ray.at(root.t).along(i), 0.0, 1.5 + 8.0 * U * away));
                let slope = |v: Vector| (f(p + 1e-6 * v) - f(p + -1e-6 * v)) / 2e-6;
                let gradient = Vector::new(slope(Vector::X), slope(Vector::Y), slope(Vector::Z));
                let steep = gradient.length();
                if steep < 1e-2 {
                    continue; // next to a singular point
                }
                assert!(f(p).abs() <= surface.error * steep, "{terms:?} at {p:?}: {:e}", f(p));
                assert!(surface.error < 2000.0 * U * 100.0 / steep, "{:e}", surface.error);
                let expected = (1.0 / steep) * gradient;
                assert!((surface.normal + -expected).length() < 1e-6 / steep, "{terms:?} {p:?}");
                hits += 1;
            }
        }
    }
    assert!(hits > 3_000, "{hits}");
}

/// Law: the surface ends at the box, faces included. Oracle: the plane x = y in boxes that cut it.
#[test]
fn the_surface_ends_at_its_box() {
    let plane = [(1.0, [1, 0, 0]), (-1.0, [0, 1, 0])];
    let shape = built(surface(&plane, 1.0));
    for (height, expected) in [(0.0, 1), (0.999, 1), (1.001, 0), (-0.999, 1), (-1.001, 0)] {
        for z in [-1.0, 0.5, 1.0] {
            let ray = Ray::new(Point::new(-4.0, height, z), Vector::X);
            assert_eq!(ts(&*shape, &ray).len(), expected, "{height} {z}");
        }
    }
}

/// Law: f = 0 and −f = 0 are the same surface, to the bit, also where it meets a face of the box, or
/// only touches the ray. Oracle: worked by hand; and the symmetry.
#[test]
fn a_surface_does_not_depend_on_the_sign_of_its_polynomial() {
    let both = |terms: &[(f64, [u32; 3])], ray: &Ray| {
        let turned: Vec<_> = terms.iter().map(|&(c, powers)| (-c, powers)).collect();
        let [plus, minus] = [terms, &turned].map(|terms| ts(&*built(surface(terms, 1.0)), ray));
        assert_eq!(plus, minus, "{terms:?} {ray:?}");
        plus
    };
    let along_x = |x: f64| Ray::new(Point::new(x, 0.5, 0.25), Vector::X);
    let sheet = |x: f64| [(1.0, [1, 0, 0]), (-x, [0; 3])];
    for face in [-1.0, 1.0] {
        assert_eq!(both(&sheet(face), &along_x(-4.0)), [face + 4.0]);
    }
    let walls = [(1.0, [2, 0, 0]), (-1.0, [0; 3])]; // x² = 1: both faces of the box
    assert_eq!(both(&walls, &along_x(-4.0)), [3.0, 5.0]);
    let touched = [(1.0, [2, 0, 0]), (1.0, [0, 1, 0]), (-0.5, [0; 3])]; // x² + y = 1/2 from below
    assert_eq!(both(&touched, &along_x(-4.0)), [4.0]);
    let within = [(1.0, [0, 1, 0]), (-0.5, [0; 3])]; // y = 1/2: the ray lies in it
    assert_eq!(both(&within, &along_x(-4.0)), [0.0; 0]);
    let mut draw = Draw::new(1973);
    let mut hits = 0;
    for _ in 0..2_000 {
        let mut whole = || draw.below(5) as f64 - 2.0;
        let terms: Vec<_> =
            [[2, 0, 0], [1, 1, 0], [0, 0, 2], [0, 1, 0], [0; 3]].map(|p| (whole(), p)).into();
        let [x, y, z] = [whole(), whole(), whole()].map(|c| 0.5 * c);
        if terms.iter().all(|&(c, powers)| c == 0.0 || powers == [0; 3]) {
            continue;
        }
        let axis = [Vector::X, Vector::Y, Vector::Z][draw.below(3)];
        let ray = Ray::new(Point::new(x, y, z) - 4.0 * axis, axis);
        hits += both(&terms, &ray).len();
    }
    assert!(hits > 300, "{hits}");
}

/// Law: terms that define no surface are refused; the message names the field and what is needed.
#[test]
fn terms_without_a_surface_are_refused() {
    let text = |terms: &[(f64, [u32; 3])], half: f64| {
        let kind = Kind::from(surface(terms, half));
        kind.build(&mut Context::default()).expect_err("no surface").to_string()
    };
    let needed = "but a term with a power of x, y or z that is not 0 is needed";
    assert_eq!(text(&[], 1.0), format!("algebraic.terms: found no terms, {needed}"));
    let constant = format!("algebraic.terms: found a constant, {needed}");
    assert_eq!(text(&[(3.0, [0; 3])], 1.0), constant);
    let nothing = format!("algebraic.terms: found nothing but zero, {needed}");
    assert_eq!(text(&[(0.0, [1, 2, 3])], 1.0), nothing);
    assert_eq!(text(&[(1.5, [2, 0, 0]), (-1.5, [2, 0, 0])], 1.0), nothing);
    assert_eq!(text(&[(1.5, [2, 0, 0]), (1.0, [0; 3]), (-1.5, [2, 0, 0])], 1.0), constant);
    assert_eq!(
        text(&[(1.0, [1, 0, 0]), (f64::NAN, [1, 0, 0])], 1.0),
        "algebraic.terms[1].coefficient: found NaN, but a finite number is needed"
    );
    let many = |powers| {
        format!("algebraic.terms[0].powers: found {powers:?}, but a sum of at most 16 is needed")
    };
    assert_eq!(text(&[(1.0, [9, 8, 0])], 1.0), many([9, 8, 0]));
    assert_eq!(text(&[(1.0, [u32::MAX, 1, 0])], 1.0), many([u32::MAX, 1, 0]));
    assert!(text(&[(1.0, [1, 0, 0])], 0.0).starts_with("algebraic.max: found [0.0, 0.0, 0.0]"));
}

/// Law: the point of a hit is on the surface within its error bound, also where sheets coincide, cross
/// or end in a point. There the computed gradient is only rounding error. Oracle: the distance from the
/// sphere, the planes and the cone that the polynomials are made of.
#[test]
fn points_where_sheets_meet_are_on_the_surface() {
    type Distance = fn(Point) -> f64;
    let double_sphere = {
        let mut terms = vec![(1.0, [0; 3])];
        for i in 0..3 {
            let power = |n: u32, m: u32| {
                std::array::from_fn(|k| {
                    if k == i {
                        n
                    } else if k == (i + 1) % 3 {
                        m
                    } else {
                        0
                    }
                })
            };
            terms.extend([(1.0, power(4, 0)), (2.0, power(2, 2)), (-2.0, power(2, 0))]);
        }
        terms
    };
    let double_plane = vec![(1.0, [0, 0, 2]), (-0.6, [0, 0, 1]), (0.09, [0; 3])];
    let crossing = vec![(1.0, [1, 0, 1]), (-0.2, [1, 0, 0]), (-0.3, [0, 0, 1]), (0.06, [0; 3])];
    let cone = vec![
        (1.0, [2, 0, 0]),
        (-0.2, [1, 0, 0]),
        (0.01, [0; 3]),
        (1.0, [0, 2, 0]),
        (-1.0, [0, 0, 2]),
    ];
    let surfaces: [(_, Distance, Point); 4] = [
        (double_sphere, |p| (p.to_vector().length() - 1.0).abs(), Point::ORIGIN),
        (double_plane, |p| (p.z() - 0.3).abs(), Point::ORIGIN),
        (crossing, |p| (p.x() - 0.3).abs().min((p.z() - 0.2).abs()), Point::new(0.3, 0.0, 0.2)),
        (
            cone,
            |p| {
                let (x, y) = (p.x() - 0.1, p.y());
                ((x * x + y * y).sqrt() - p.z().abs()).abs()
            },
            Point::new(0.1, 0.0, 0.0),
        ),
    ];
    let mut draw = Draw::new(1961);
    for (which, (terms, distance, middle)) in surfaces.into_iter().enumerate() {
        let shape = built(surface(&terms, 2.0));
        let mut hits = 0;
        for _ in 0..2_000 {
            let spread = if which < 2 { 0.7 } else { draw.pick(&[0.0, 1e-9, 1e-6, 0.3]) };
            let target = match which {
                2 => middle + (draw.between(-1.0, 1.0) * Vector::Y + draw.vector(spread)),
                _ => middle + draw.vector(spread),
            };
            // from far away the position along the ray is rounded, and one correction step does not get
            // to a double root
            let far = draw.pick(&[3.0, 12.0]);
            let away = draw.decades(0.5, far) * draw.direction();
            let ray = Ray::new(target + away, -away);
            for hit in shape.roots(&ray, Span::LINE) {
                let Surface { point, error, .. } = shape.surface(&ray, &hit);
                let off = distance(point);
                assert!(
                    off <= error,
                    "{which}: {point:?} is off by {off:e}, not {error:e}: {ray:?}"
                );
                hits += 1;
            }
        }
        assert!(hits > 500, "{which}: {hits}");
    }
}
