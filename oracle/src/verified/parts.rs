//! The number of roots of parts, from the signs of the exact quadratic at the ends of the spans in which
//! the ray is inside the part's planes. Sines and cosines are checked by addition theorems and closed forms.

use super::rational::{Line, Q, Q3, implicit, q};
use crate::{
    Shape,
    angle::sin_cos,
    real::{Real, magnitude, nearest, real},
};

/// The number to about 300 bits, as a fraction.
fn fraction(x: &Real) -> Q {
    let (mut rest, mut sum) = (x.clone(), Q::ZERO);
    for _ in 0..6 {
        let part = nearest(&rest);
        rest -= real(part);
        sum += q(part);
    }
    sum
}

/// `a·p + b ≥ 0`.
type Side = (Q3, Q);

fn side_of(gate: &Side, p: &Q3) -> Q {
    let (a, b) = gate;
    &a[0] * &p[0] + &a[1] * &p[1] + &a[2] * &p[2] + b
}

/// The planes through the axis at the ends of a range; whether both must hold; whether it is a full turn.
fn wedge(phi: &[f64; 2]) -> ([Q3; 2], bool, bool) {
    let [a, b] = phi.map(|phi| {
        let (s, c) = sin_cos(&real(phi));
        [fraction(&s), fraction(&c)]
    });
    let mut width = q(phi[1]) - q(phi[0]);
    while width < Q::ZERO {
        width += q(360.0);
    }
    let after = [a[1].clone(), Q::ZERO, -&a[0]];
    let before = [-&b[1], Q::ZERO, b[0].clone()];
    ([after, before], width <= q(180.0), width >= q(360.0))
}

pub(super) fn in_wedge(phi: &[f64; 2], w: &Q3) -> bool {
    let (planes, both, all) = wedge(phi);
    let [a, b] = planes.map(|plane| side_of(&(plane, Q::ZERO), w) >= Q::ZERO);
    all || if both { a && b } else { a || b }
}

/// The half-spaces above and below, the range of azimuths, and its centre.
fn filters(shape: &Shape) -> (Vec<Side>, Option<[f64; 2]>, [f64; 3]) {
    let above = |y: Q| ([Q::ZERO, q(1.0), Q::ZERO], -y);
    let below = |y: Q| ([Q::ZERO, q(-1.0), Q::ZERO], y);
    match shape {
        Shape::Cone { height, .. } => (vec![above(Q::ZERO), below(q(*height))], None, [0.0; 3]),
        Shape::Paraboloid { height, .. } => (vec![below(q(*height))], None, [0.0; 3]),
        Shape::PartCylinder { y0, y1, phi, .. } => {
            (vec![above(q(*y0)), below(q(*y1))], Some(*phi), [0.0; 3])
        }
        Shape::PartSphere { center, radius, phi, theta } => {
            let [top, bottom] =
                theta.map(|theta| q(center[1]) + q(*radius) * fraction(&sin_cos(&real(theta)).1));
            // at a pole the plane touches the sphere; with rounding it could cut the pole off
            let mut sides = Vec::new();
            sides.extend((theta[1] < 180.0).then(|| above(bottom)));
            sides.extend((theta[0] > 0.0).then(|| below(top)));
            (sides, Some(*phi), *center)
        }
        _ => unreachable!("not a part of a quadric"),
    }
}

pub(super) fn count(shape: &Shape, line: &Line) -> usize {
    let (sides, phi, center) = filters(shape);
    let center = center.map(q);
    let relative = |t: &Q| -> Q3 {
        let p = line.at(t);
        std::array::from_fn(|i| &p[i] - &center[i])
    };
    let inside = |t: &Q| {
        sides.iter().all(|side| side_of(side, &line.at(t)) >= Q::ZERO)
            && phi.is_none_or(|phi| in_wedge(&phi, &relative(t)))
    };
    let mut ends = vec![Q::ZERO];
    let mut cross = |at_0: Q, at_1: Q| {
        if at_0 != at_1 {
            ends.push(&at_0 / (&at_0 - at_1));
        }
    };
    let [zero, one] = [q(0.0), q(1.0)];
    for side in &sides {
        cross(side_of(side, &line.at(&zero)), side_of(side, &line.at(&one)));
    }
    if let Some(phi) = phi {
        for plane in wedge(&phi).0 {
            let side = (plane, Q::ZERO);
            cross(side_of(&side, &relative(&zero)), side_of(&side, &relative(&one)));
        }
    }
    ends.retain(|t| *t >= zero);
    ends.sort();
    ends.dedup();
    let after_last = ends.last().map(|last| last + &one);
    let spans = ends.iter().zip(ends.iter().skip(1).map(Some).chain([None]));
    let counts = spans.map(|(from, to)| {
        let middle = (from + to.or(after_last.as_ref()).unwrap_or(&one)) / q(2.0);
        if inside(&middle) { roots(shape, line, from, to) } else { 0 }
    });
    counts.sum()
}

/// Roots of the quadratic in a span, by its signs at both ends and at its vertex.
fn roots(shape: &Shape, line: &Line, from: &Q, to: Option<&Q>) -> usize {
    let f = |t: &Q| implicit(shape, line, t);
    let [f0, f1, f2] = [0.0, 1.0, -1.0].map(|t| f(&q(t)));
    let b = (&f1 - &f2) / q(2.0);
    let a = (&f1 + &f2) / q(2.0) - &f0;
    let positive = |x: &Q| *x > Q::ZERO;
    let first = positive(&f(from));
    let last = match to {
        Some(to) => positive(&f(to)),
        None if a != Q::ZERO => positive(&a),
        None => {
            if b == Q::ZERO {
                first
            } else {
                positive(&b)
            }
        }
    };
    if first != last {
        return 1;
    }
    if a == Q::ZERO {
        return 0;
    }
    let vertex = -b / (q(2.0) * a);
    let between = vertex > *from && to.is_none_or(|to| vertex < *to);
    if between && positive(&f(&vertex)) != first { 2 } else { 0 }
}

/// Oracle: 30°, 45° and 36° in closed form, `s² + c² = 1`, and the addition theorem.
#[test]
fn sines_and_cosines_obey_the_addition_theorem() {
    let close = |x: Real, y: Real| {
        let apart = magnitude(&(&x - &y));
        assert!(apart < 1e-145, "{x} and {y} are {apart:e} apart");
    };
    let at = |degrees: f64| sin_cos(&real(degrees));
    close(at(30.0).0, real(0.5));
    close(at(45.0).0, real(0.5).sqrt());
    close(at(36.0).1, (real(1.0) + real(5.0).sqrt()) / real(4.0));
    assert_eq!(at(90.0), (real(1.0), real(0.0)));
    assert_eq!(at(-180.0).1, real(-1.0));
    assert_eq!(at(270.0), (real(-1.0), real(0.0)));
    for (a, b) in [(1.0, 2.5), (17.0, 100.25), (200.0, 155.5), (1e-9, 359.0), (-12.5, 77.0)] {
        let ((s, c), (u, v)) = (at(a), at(b));
        let (sum_s, sum_c) = sin_cos(&(real(a) + real(b)));
        close(&s * &s + &c * &c, real(1.0));
        close(sum_s, &s * &v + &c * &u);
        close(sum_c, c * v - s * u);
    }
}
