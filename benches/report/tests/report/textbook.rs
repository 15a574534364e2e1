//! The textbook's formulas are implemented correctly: a comparison with a misprint would be worthless.

use exact::backward_error;
use groundtruth::math::{Point, Ray, Span, Vector};
use groundtruth::shapes::textbook::{EPSILON, quartic_roots};
use groundtruth::shapes::{Shape, Torus};

/// The tolerance; well above the errors of the formulas on ordinary rays.
const RIGHT: f64 = 1e-6;

/// The first hit by the book's routine.
fn first(book: &dyn Shape, ray: &Ray) -> Option<f64> {
    book.hit(ray, Span { min: EPSILON, ..Span::AHEAD }).map(|at| at.t)
}

/// Law: the solver finds the known roots of quartics. Oracle: quartics made from their roots, and a torus.
#[test]
fn quartics_have_their_roots() {
    let check = |coefficients: [f64; 5], expected: &[f64]| {
        let mut roots = quartic_roots(coefficients);
        roots.sort_by(f64::total_cmp);
        let near = |(a, b): (&f64, &f64)| (a - b).abs() < RIGHT;
        let same = roots.len() == expected.len() && roots.iter().zip(expected).all(near);
        assert!(same, "{coefficients:?}: {roots:?}, not {expected:?}");
    };
    check([24.0, -50.0, 35.0, -10.0, 1.0], &[1.0, 2.0, 3.0, 4.0]);
    check([30.0, -61.0, 41.0, -11.0, 1.0], &[1.0, 2.0, 3.0, 5.0]);
    check([4.0, 0.0, -5.0, 0.0, 1.0], &[-2.0, -1.0, 1.0, 2.0]);
    check([-1.0, 0.0, 0.0, 0.0, 1.0], &[-1.0, 1.0]);
    check([2.0, 0.0, 0.0, 0.0, 2.0], &[]);
    // the torus (2, ½) along its equator, from (−5, 0, 0)
    let torus = Torus { swept_radius: 2.0, tube_radius: 0.5, inward: false };
    let torus = backward_error::by_the_book(&torus.into()).expect("it is valid");
    let along_x = Ray::new(Point::new(-5.0, 0.0, 0.0), Vector::X);
    let t = first(&*torus, &along_x).expect("a hit");
    assert!((t - 2.5).abs() < RIGHT, "t is {t}, not 2.5");
    assert_eq!(first(&*torus, &Ray::new(Point::new(0.0, -5.0, 0.0), Vector::Y)), None);
}
