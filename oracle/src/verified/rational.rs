//! Exact rational arithmetic: no rounding and no square roots, only signs.

use dashu_ratio::RBig;

use super::{everything, parts, sturm};
use crate::{
    Ray, Shape,
    hard::Kind,
    intersect,
    real::{nearest, real},
};

pub(super) type Q = RBig;
pub(super) type Q3 = [Q; 3];

pub(super) fn q(x: f64) -> Q {
    Q::try_from(x + 0.0).expect("inputs are finite")
}

fn dot(a: &Q3, b: &Q3) -> Q {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}

fn minus(a: &Q3, b: &Q3) -> Q3 {
    std::array::from_fn(|i| &a[i] - &b[i])
}

fn cross(a: &Q3, b: &Q3) -> Q3 {
    let part = |i: usize, j: usize| &a[i] * &b[j] - &a[j] * &b[i];
    [part(1, 2), part(2, 0), part(0, 1)]
}

pub(super) struct Line {
    pub(super) o: Q3,
    pub(super) d: Q3,
}

impl Line {
    fn new(ray: &Ray) -> Line {
        Line { o: ray.origin.map(q), d: ray.direction.map(q) }
    }

    pub(super) fn at(&self, t: &Q) -> Q3 {
        std::array::from_fn(|i| &self.o[i] + &self.d[i] * t)
    }

    /// Solves `A x = v` by Cramer's rule for origin and direction.
    fn moved_back(&self, matrix: &[[f64; 4]; 3]) -> Line {
        let m = matrix.map(|row| row.map(q));
        let column = |j: usize| -> Q3 { std::array::from_fn(|i| m[i][j].clone()) };
        let [a, b, c] = [column(0), column(1), column(2)];
        let det = dot(&a, &cross(&b, &c));
        let solve = |v: &Q3| {
            let minors = [dot(v, &cross(&b, &c)), dot(&a, &cross(v, &c)), dot(&a, &cross(&b, v))];
            minors.map(|minor| minor / &det)
        };
        Line { o: solve(&minus(&self.o, &column(3))), d: solve(&self.d) }
    }
}

/// A function that is 0 on the surface (or its plane, or the whole tube) and changes sign there.
pub(super) fn implicit(shape: &Shape, line: &Line, t: &Q) -> Q {
    let p = line.at(t);
    let plane = |c: &[f64; 3], n: &Q3| dot(&minus(&p, &c.map(q)), n);
    let square = |x: &Q| x * x;
    match shape {
        Shape::Plane { point: c, normal }
        | Shape::Disk { center: c, normal, .. }
        | Shape::Annulus { center: c, normal, .. } => plane(c, &normal.map(q)),
        Shape::PartAnnulus { center, .. } => &p[1] - q(center[1]),
        Shape::CutFace { .. } => p[1].clone(),
        Shape::Solid(_) => unreachable!("solids have laws of their own"),
        Shape::Sphere { center, radius } | Shape::PartSphere { center, radius, .. } => {
            let w = minus(&p, &center.map(q));
            dot(&w, &w) - square(&q(*radius))
        }
        Shape::Cuboid { min, max } => {
            (0..3).flat_map(|i| [q(min[i]) - &p[i], &p[i] - q(max[i])]).max().expect("six faces")
        }
        Shape::Triangle { vertices } => plane(&vertices[0], &normal(vertices)),
        Shape::Rectangle { corner, a, b } => plane(corner, &cross(&a.map(q), &b.map(q))),
        Shape::OpenCylinder { radius, .. } | Shape::PartCylinder { radius, .. } => {
            square(&p[0]) + square(&p[2]) - square(&q(*radius))
        }
        Shape::Cone { height, radius } => {
            let (h, r) = (q(*height), q(*radius));
            let down = (&h - &p[1]) * r;
            (square(&p[0]) + square(&p[2])) * square(&h) - square(&down)
        }
        Shape::Paraboloid { height, radius } => {
            (square(&p[0]) + square(&p[2])) * q(*height) - &p[1] * square(&q(*radius))
        }
        Shape::Torus { swept_radius, tube_radius }
        | Shape::PartTorus { swept_radius, tube_radius, .. } => {
            let (a, b) = (square(&q(*swept_radius)), square(&q(*tube_radius)));
            let sum = dot(&p, &p) + &a - b;
            square(&sum) - q(4.0) * a * (square(&p[0]) + square(&p[2]))
        }
        Shape::Algebraic { terms, .. } => terms.iter().fold(Q::ZERO, |sum, (c, powers)| {
            let factors = (0..3).flat_map(|i| vec![&p[i]; powers[i] as usize]);
            sum + factors.fold(q(*c), |product, x| product * x)
        }),
        Shape::Instance { matrix, of } => implicit(of, &line.moved_back(matrix), t),
    }
}

fn normal(vertices: &[[f64; 3]; 3]) -> Q3 {
    let [a, b, c] = vertices.map(|v| v.map(q));
    cross(&minus(&b, &a), &minus(&c, &a))
}

/// The number of roots with t > 0, from signs at rational points; a double root counts twice.
fn count(shape: &Shape, line: &Line) -> usize {
    let zero = Q::ZERO;
    match shape {
        Shape::Cuboid { min, max } => {
            let Some((start, end)) = span(line, &[0, 1, 2], min, max) else { return 0 };
            usize::from(start > zero) + usize::from(end > zero)
        }
        Shape::Sphere { .. } => {
            let a = dot(&line.d, &line.d);
            // F is a t² + …; its vertex from three values
            let [f0, f1, f2] = [0.0, 1.0, -1.0].map(|t| implicit(shape, line, &q(t)));
            let vertex = (&f2 - &f1) / (q(4.0) * a);
            convex(shape, line, &f0, zero, Some(vertex), None)
        }
        Shape::OpenCylinder { y0, y1, .. } => {
            let level = line.d[1] == zero;
            let (start, end) = if level {
                if line.o[1] < q(*y0) || line.o[1] > q(*y1) {
                    return 0;
                }
                (zero.clone(), None)
            } else {
                let slab = span(line, &[1], &[0.0, *y0, 0.0], &[0.0, *y1, 0.0]);
                let (start, end) = slab.expect("one slab is always crossed");
                (start.max(zero.clone()), Some(end))
            };
            if end.as_ref().is_some_and(|end| *end < start) {
                return 0;
            }
            let a = &line.d[0] * &line.d[0] + &line.d[2] * &line.d[2];
            let b = &line.o[0] * &line.d[0] + &line.o[2] * &line.d[2];
            let vertex = (a != zero).then(|| -b / a);
            let first = implicit(shape, line, &start);
            convex(shape, line, &first, start, vertex, end)
        }
        Shape::Torus { .. } => {
            sturm::count_positive(&sturm::interpolated(4, |t| implicit(shape, line, t)))
        }
        Shape::PartTorus { swept_radius, tube_radius, phi, theta } => {
            in_ranges([*swept_radius, *tube_radius], [*phi, *theta], line)
        }
        Shape::Algebraic { terms, min, max } => {
            let Some((start, end)) = span(line, &[0, 1, 2], min, max) else { return 0 };
            let degree = terms.iter().map(|(_, powers)| powers.iter().sum()).max();
            let degree: u32 = degree.unwrap_or(0);
            let polynomial = sturm::interpolated(degree as usize, |t| implicit(shape, line, t));
            if end < zero { 0 } else { sturm::count_between(&polynomial, &start.max(zero), &end) }
        }
        Shape::Instance { matrix, of } => count(of, &line.moved_back(matrix)),
        _ => flat_count(shape, line).unwrap_or_else(|| parts::count(shape, line)),
    }
}

/// The same for a shape that is a part of a plane; `None` for others.
fn flat_count(shape: &Shape, line: &Line) -> Option<usize> {
    let zero = Q::ZERO;
    let on_plane = |c: &[f64; 3], n: &Q3| {
        let slope = dot(&line.d, n);
        let t = (slope != zero).then(|| dot(&minus(&c.map(q), &line.o), n) / slope)?;
        (t > zero).then(|| line.at(&t))
    };
    let is_hit = match shape {
        Shape::Plane { point, normal } => on_plane(point, &normal.map(q)).is_some(),
        Shape::Disk { center, normal, radius } => {
            on_plane(center, &normal.map(q)).is_some_and(|p| {
                let w = minus(&p, &center.map(q));
                dot(&w, &w) <= q(*radius) * q(*radius)
            })
        }
        Shape::Rectangle { corner, a, b } => {
            let (a, b) = (a.map(q), b.map(q));
            on_plane(corner, &cross(&a, &b)).is_some_and(|p| {
                let x = minus(&p, &corner.map(q));
                [&a, &b].iter().all(|s| dot(&x, s) >= zero && dot(&x, s) <= dot(s, s))
            })
        }
        Shape::Triangle { vertices } => {
            let n = normal(vertices);
            on_plane(&vertices[0], &n).is_some_and(|p| {
                (0..3).all(|k| {
                    let (a, b) = (vertices[k].map(q), vertices[(k + 1) % 3].map(q));
                    dot(&cross(&minus(&b, &a), &minus(&p, &a)), &n) >= zero
                })
            })
        }
        Shape::Annulus { center, normal, inner, outer } => on_plane(center, &normal.map(q))
            .is_some_and(|p| {
                let w = minus(&p, &center.map(q));
                let square = dot(&w, &w);
                q(*inner) * q(*inner) <= square && square <= q(*outer) * q(*outer)
            }),
        Shape::PartAnnulus { center, inner, outer, phi } => {
            let up = [0.0, 1.0, 0.0].map(q);
            on_plane(center, &up).is_some_and(|p| {
                let w = minus(&p, &center.map(q));
                let square = dot(&w, &w);
                q(*inner) * q(*inner) <= square
                    && square <= q(*outer) * q(*outer)
                    && parts::in_wedge(phi, &w)
            })
        }
        Shape::CutFace { size, radius } => {
            let up = [0.0, 1.0, 0.0].map(q);
            on_plane(&[0.0; 3], &up).is_some_and(|p| {
                let half = q(*size) / q(2.0);
                let inside = |x: &Q| *x <= half && -x <= half;
                let square = &p[0] * &p[0] + &p[2] * &p[2];
                inside(&p[0]) && inside(&p[2]) && square >= q(*radius) * q(*radius)
            })
        }
        _ => return None,
    };
    Some(usize::from(is_hit))
}

/// The roots of the whole torus whose angles, by the arc tangent, are in the ranges. (Angles in `f64` are
/// too inexact for cases within 1e-9 of an end; these are left out.)
fn in_ranges([a, b]: [f64; 2], ranges: [[f64; 2]; 2], line: &Line) -> usize {
    let f64s = |v: &Q3| v.each_ref().map(|x| x.to_f64().value());
    let ray = Ray { origin: f64s(&line.o), direction: f64s(&line.d) };
    let whole = intersect(&Shape::Torus { swept_radius: a, tube_radius: b }, &ray);
    let inside = |root: &&crate::Root| {
        let [x, y, z]: [_; 3] =
            std::array::from_fn(|i| real(ray.origin[i]) + real(ray.direction[i]) * &root.exact_t);
        let k = (&x * &x + &z * &z).sqrt() - real(a);
        let angles = [x.atan2_unit(&z, 360), y.atan2_unit(&k, 360)];
        angles.iter().zip(&ranges).all(|(angle, [first, last])| {
            let degrees = nearest(angle);
            let turn = last - first + if last < first { 360.0 } else { 0.0 };
            turn >= 360.0 || (degrees - first).rem_euclid(360.0) <= turn
        })
    };
    whole.roots.iter().filter(inside).count()
}

/// The interval in which the line is between min and max on these axes.
fn span(line: &Line, axes: &[usize], min: &[f64; 3], max: &[f64; 3]) -> Option<(Q, Q)> {
    let mut span: Option<(Q, Q)> = None;
    for &i in axes {
        let (low, high) = (q(min[i]) - &line.o[i], q(max[i]) - &line.o[i]);
        if line.d[i] == Q::ZERO {
            if low > Q::ZERO || high < Q::ZERO {
                return None;
            }
            continue;
        }
        let (a, b) = (low / &line.d[i], high / &line.d[i]);
        let (a, b) = if a < b { (a, b) } else { (b, a) };
        span = Some(span.map_or((a.clone(), b.clone()), |(s, e)| (s.max(a), e.min(b))));
    }
    span.filter(|(start, end)| start <= end)
}

/// Roots of a convex function from `start` (value `first`) to `end` (or to infinity).
fn convex(
    shape: &Shape,
    line: &Line,
    first: &Q,
    start: Q,
    vertex: Option<Q>,
    end: Option<Q>,
) -> usize {
    let outside_first = *first > Q::ZERO;
    let Some(vertex) = vertex else { return 0 }; // constant along a generator
    let outside_last = end.as_ref().is_none_or(|end| implicit(shape, line, end) > Q::ZERO);
    if outside_first != outside_last {
        return 1;
    }
    let between = vertex > start && end.is_none_or(|end| vertex < end);
    let dips = outside_first && between && implicit(shape, line, &vertex) <= Q::ZERO;
    if dips { 2 } else { 0 }
}

/// The kinds whose function may be 0 without a change of sign.
const MAY_TOUCH: [Kind; 6] =
    [Kind::Cuboid, Kind::Cone, Kind::Algebraic, Kind::Torus, Kind::PartTorus, Kind::Instance];

/// Oracle: signs of the exact implicit function at about t ± 2⁻²⁰⁰ t.
#[test]
fn the_exact_function_changes_sign_at_every_root() {
    let mut seen = 0;
    for (kind, family, shape, ray) in everything(testkit::as_many(12, 30)) {
        let answer = intersect(&shape, &ray);
        if answer.margin == 0.0 && MAY_TOUCH.contains(&kind) {
            continue; // the function stays 0 along a face or edge, and touches 0 at a tangent
        }
        let line = Line::new(&ray);
        for (i, root) in answer.roots.iter().enumerate() {
            let next = answer.roots.get(i + 1).or(i.checked_sub(1).map(|j| &answer.roots[j]));
            if next.is_some_and(|next| next.exact_t == root.exact_t) {
                continue; // a double root touches and does not cross
            }
            let (mut rest, mut t, mut last) = (root.exact_t.clone(), Q::ZERO, 0.0);
            for _ in 0..4 {
                last = nearest(&rest);
                rest -= real(last);
                t += q(last);
            }
            let step = q(last.abs().max(root.t * 1e-60));
            let signs = [&t - &step, &t + &step].map(|t| implicit(&shape, &line, &t));
            assert!(
                (signs[0] < Q::ZERO) != (signs[1] < Q::ZERO),
                "{kind:?} {family:?}\n{shape:?}\n{ray:?}\nt = {}",
                root.t
            );
            assert_eq!(nearest(&root.exact_t), root.t);
            seen += 1;
        }
    }
    assert!(seen > 1500, "only {seen} roots");
}

/// Oracle: counts from signs of rational numbers. Where the margin is about 0, the oracle's rounded
/// square roots may decide differently; shapes without square roots are checked there, too.
#[test]
fn no_root_is_lost_and_none_invented() {
    for (kind, family, shape, ray) in everything(testkit::as_many(24, 60)) {
        let answer = intersect(&shape, &ray);
        let rounds = !matches!(
            shape,
            Shape::Plane { .. }
                | Shape::Cuboid { .. }
                | Shape::Triangle { .. }
                | Shape::Rectangle { .. }
                | Shape::Disk { .. }
        );
        if rounds && answer.margin < 1e-60 {
            continue;
        }
        if matches!(shape, Shape::PartTorus { .. }) && answer.margin < 1e-9 {
            continue;
        }
        let expected = count(&shape, &Line::new(&ray));
        assert_eq!(
            answer.roots.len(),
            expected,
            "{kind:?} {family:?} margin {:e}\n{shape:?}\n{ray:?}",
            answer.margin
        );
    }
}
