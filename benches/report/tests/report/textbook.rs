//! The textbook's formulas are implemented correctly: a comparison with a misprint would be worthless.

use exact::{backward_error, composites};
use groundtruth::math::{Point, Ray, Span, Vector};
use groundtruth::shapes::textbook::{EPSILON, quartic_roots};
use groundtruth::shapes::{Shape, Torus};
use oracle::Answer;
use oracle::hard::{Family, Kind, cases};

/// The tolerance; well above the errors of the formulas on ordinary rays.
const RIGHT: f64 = 1e-6;

/// The first hit by the book's routine.
fn first(book: &dyn Shape, ray: &Ray) -> Option<f64> {
    book.hit(ray, Span { min: EPSILON, ..Span::AHEAD }).map(|at| at.t)
}

/// The answers of a textbook routine to some rays.
#[derive(Default)]
struct Tally {
    hits: u32,
    misses: u32,
    /// First hits that the routine does not find.
    missed: u32,
}

impl Tally {
    /// Counts one ray, unless its margin is below `margin`, a root is near epsilon or ill-conditioned.
    fn ask(&mut self, book: &dyn Shape, ray: &oracle::Ray, answer: &Answer, margin: f64) {
        let near = answer.margin < margin || answer.roots.iter().any(|root| root.t < 0.002);
        if near || answer.roots.iter().any(|root| root.cond > 1e6) {
            return;
        }
        let found = first(book, &backward_error::ray(ray));
        match (found, answer.roots.first()) {
            (Some(t), Some(root)) if root.t_error(t) <= RIGHT * root.t => self.hits += 1,
            (None, None) => self.misses += 1,
            (found, Some(first)) if found.is_none_or(|t| t > first.t) => self.missed += 1,
            (found, root) => panic!("{found:?}, exactly {root:?} {book:?} {ray:?}"),
        }
    }
}

/// Law: on ordinary rays every textbook routine agrees with the exact answer, except that samples along a
/// ray may miss some pairs of roots of algebraic surfaces. Oracle: 512-bit arithmetic.
#[test]
fn textbook_forms_are_right_on_ordinary_rays() {
    for kind in Kind::ALL {
        let mut tally = Tally::default();
        for (shape, ray) in cases(kind, Family::Ordinary, 31, 300) {
            let kind = exact::our_shape(&shape).expect("it is valid");
            let book = backward_error::by_the_book(&kind).expect("it is valid");
            tally.ask(&*book, &ray, &oracle::intersect(&shape, &ray), RIGHT);
        }
        let Tally { hits, misses, missed } = tally;
        assert!(hits > 50 && misses > 20, "{kind:?}: {hits}, {misses}");
        let may_miss = if kind == Kind::Algebraic { 6 } else { 0 };
        assert!(missed <= may_miss, "{kind:?}: {missed} missed, {hits} hit");
    }
}

/// Law and oracle as above, for compounds and grids.
#[test]
fn compounds_and_grids_are_right_on_ordinary_rays() {
    for kind in composites::Kind::ALL {
        const COUNT: u32 = 200;
        let mut tally = Tally::default();
        for index in 0..COUNT {
            let case = kind.case(Family::Ordinary, 32, index as usize, None).expect("it is valid");
            let book = backward_error::by_the_book(&case.ours).expect("it is valid");
            // for parts that the ray passes by, the margin is not known more precisely
            tally.ask(&*book, &case.ray, &case.answer(0.0), 1e-11);
        }
        let Tally { hits, misses, missed } = tally;
        assert!(hits > 20 && misses > 10, "{kind:?}: {hits}, {misses}");
        // few cases have a margin below that
        assert!(10 * (hits + misses) >= 9 * COUNT, "{kind:?}: {hits} and {misses} of {COUNT}");
        assert_eq!(missed, 0, "{kind:?}: {hits} hit");
    }
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
