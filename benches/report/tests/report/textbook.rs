//! The textbook's formulas are implemented correctly: a comparison with a misprint would be worthless.

use exact::{backward_error, composites};
use groundtruth::math::{Pcg32, Point, Ray, Span, Vector};
use groundtruth::shapes::textbook::{EPSILON, quartic_roots};
use groundtruth::shapes::{
    self, Annulus, Cone, Disk, PartAnnulus, PartCylinder, PartSphere, PartTorus, Shape, Torus,
};
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

/// The first `t` at which a function changes its sign along a ray at a point for which `there` holds: by
/// small steps, then by bisection.
fn marched(ray: &Ray, f: impl Fn(Point) -> f64, there: impl Fn(Point) -> bool) -> Option<f64> {
    const STEPS: u32 = 20_000;
    let at = |i: u32| 20.0 * f64::from(i) / f64::from(STEPS);
    let value = |t: f64| f(ray.at(t));
    for i in 0..STEPS {
        let (mut low, mut high) = (at(i), at(i + 1));
        if (value(low) > 0.0) == (value(high) > 0.0) {
            continue;
        }
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if (value(low) > 0.0) == (value(middle) > 0.0) { low = middle } else { high = middle }
        }
        if low > EPSILON && there(ray.at(low)) {
            return Some(low);
        }
    }
    None
}

/// Rays from a shell around the origin towards its middle.
fn rays(count: usize) -> Vec<Ray> {
    let mut random = Pcg32::new(19, 0);
    let mut vector = |size: f64| {
        let mut x = || size * (2.0 * random.uniform() - 1.0);
        Vector::new(x(), x(), x())
    };
    let ray = |_| {
        let origin = Point::ORIGIN + 6.0 * vector(1.0).unit().expect("not zero");
        let target = Point::ORIGIN + vector(1.6);
        Ray::new(origin, (target - origin).unit().expect("elsewhere"))
    };
    (0..count).map(ray).collect()
}

/// Law: a routine's hit is the first sign change of the implicit function on the existing part. Oracle: the
/// function in small steps, and the part by signs of coordinates instead of angles. One ray in 200 may
/// differ: two sign changes within one step, or a border within rounding.
fn agrees(
    name: &str,
    kind: impl Into<shapes::Kind>,
    f: impl Fn(Point) -> f64,
    there: impl Fn(Point) -> bool,
) {
    let book = backward_error::by_the_book(&kind.into()).expect("it is valid");
    let (mut hits, mut misses, mut odd) = (0, 0, 0);
    for ray in rays(400) {
        match (first(&*book, &ray), marched(&ray, &f, &there)) {
            (Some(a), Some(b)) if (a - b).abs() < RIGHT => hits += 1,
            (None, None) => misses += 1,
            _ => odd += 1,
        }
    }
    assert!(odd <= 2, "{name}: {odd} differ of {hits} hits and {misses} misses");
    assert!(hits > 20 && misses > 20, "{name}: {hits} hits, {misses} misses");
}

const QUARTER: [f64; 2] = [0.0, 90.0];
const HALF: [f64; 2] = [0.0, 180.0];

/// Whether the azimuth is in [`QUARTER`].
fn in_quarter(p: Point) -> bool {
    p.x() >= 0.0 && p.z() >= 0.0
}

#[test]
fn tori_whole_and_in_part_are_where_their_function_changes_sign() {
    let (a, b) = (2.0, 0.5);
    let f = |p: Point| {
        let rho = (p.x() * p.x() + p.z() * p.z()).sqrt();
        (rho - a) * (rho - a) + p.y() * p.y() - b * b
    };
    agrees("torus", Torus { swept_radius: a, tube_radius: b, inward: false }, f, |_| true);
    let part =
        |phi, theta| PartTorus { swept_radius: a, tube_radius: b, phi, theta, inward: false };
    agrees("part torus", part(HALF, HALF), f, |p| p.x() >= 0.0 && p.y() >= 0.0);
    let is_outer = |p: Point| p.x() * p.x() + p.z() * p.z() >= a * a;
    agrees("outer half of a torus", part([0.0, 360.0], [270.0, 90.0]), f, is_outer);
}

#[test]
fn cones_are_where_their_function_changes_sign() {
    let (height, radius) = (2.0, 1.0);
    let f = |p: Point| {
        (p.x() * p.x() + p.z() * p.z()).sqrt() - radius * ((height - p.y()) / height).abs()
    };
    let cone = Cone { height, radius, inward: false };
    agrees("cone", cone, f, |p| (0.0..=height).contains(&p.y()));
}

#[test]
fn annuli_and_part_annuli_are_where_their_plane_is_crossed() {
    let center = Point::new(0.1, 0.3, -0.2);
    let (normal, inner_radius, outer_radius) = (Vector::Y, 0.6, 1.7);
    let whole = Annulus { center, normal, inner_radius, outer_radius };
    let f = |p: Point| p.y() - center.y();
    let ring = |p: Point| (0.6..=1.7).contains(&p.distance(center));
    agrees("annulus", whole, f, ring);
    let turned = |p: Point| Point::ORIGIN + (p - center);
    let part = PartAnnulus { center, normal, inner_radius, outer_radius, phi: QUARTER };
    agrees("part annulus", part, f, |p| ring(p) && in_quarter(turned(p)));
    let disk = Disk { center, normal, radius: 1.7 };
    agrees("disk", disk, f, |p| p.distance(center) <= 1.7);
}

#[test]
fn part_spheres_and_part_cylinders_are_where_their_function_changes_sign() {
    let center = Point::new(0.25, -0.125, 0.5);
    let sphere = PartSphere { center, radius: 1.5, phi: QUARTER, theta: QUARTER, inward: false };
    let moved = |p: Point| Point::ORIGIN + (p - center);
    let f = |p: Point| p.distance(center) - 1.5;
    agrees("part sphere", sphere, f, |p| in_quarter(moved(p)) && p.y() >= center.y());
    let cylinder = PartCylinder { y0: -0.5, y1: 1.0, radius: 1.25, phi: HALF, inward: false };
    let f = |p: Point| (p.x() * p.x() + p.z() * p.z()).sqrt() - 1.25;
    let there = |p: Point| p.x() >= 0.0 && (-0.5..=1.0).contains(&p.y());
    agrees("part cylinder", cylinder, f, there);
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
