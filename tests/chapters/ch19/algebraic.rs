//! Algebraic surfaces: zero sets of polynomials that the user gives.

use groundtruth::shapes::{Algebraic, Term};

use crate::prelude::*;

fn surface(terms: &[(f64, [u32; 3])], half: f64) -> Algebraic {
    let terms = terms.iter().map(|&(coefficient, powers)| Term { coefficient, powers }).collect();
    let corner = Point::new(half, half, half);
    Algebraic { terms, min: corner.scaled(-1.0), max: corner }
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
        let shape = shape_of(surface(&terms, 3.0));
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

/// Law: f = 0 and −f = 0 are the same surface, to the bit, also where it meets a face of the box, or
/// only touches the ray. Oracle: worked by hand; and the symmetry.
#[test]
fn a_surface_does_not_depend_on_the_sign_of_its_polynomial() {
    let both = |terms: &[(f64, [u32; 3])], ray: &Ray| {
        let turned: Vec<_> = terms.iter().map(|&(c, powers)| (-c, powers)).collect();
        let [plus, minus] = [terms, &turned].map(|terms| ts(&*shape_of(surface(terms, 1.0)), ray));
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
        let shape = shape_of(surface(&terms, 2.0));
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
