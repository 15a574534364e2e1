//! The open cylinder about the y axis: a quadratic in x and z, each root filtered by y.

use super::{Beam, Found, Hit, disk::rim, quadratic};
use crate::{
    margin::{Gate, Verdict},
    real::{M, Real, V, nearest, real, sign},
};

/// `F(x) = (x² + z² − r²)/2`, so `F_r = −r`; roots do not depend on the rims.
pub(super) fn cylinder(y: [&Real; 2], r: &Real, beam: &Beam) -> Found {
    let (o, d) = (flat(&beam.o), flat(&beam.d));
    let (a, b) = (d.dot(&d), o.dot(&d));
    let power = o.dot(&o) - r * r;
    let across = &o.0[0] * &d.0[2] - &o.0[2] * &d.0[0];
    let discriminant = &a * r * r - &across * &across;
    let hits = quadratic(&a, &b, &power, &discriminant).into_iter().filter_map(|t| {
        let x = beam.at(&t);
        let within = *y[0] <= x.0[1] && x.0[1] <= *y[1];
        let hessian = M::diagonal([1.0, 0.0, 1.0]);
        within.then(|| Hit::new(t, flat(&x), nearest(&(r * r)), Some(hessian)))
    });
    let closest = sign(&a).is_gt().then(|| -&b / &a);
    Found { hits: hits.collect(), margin: margin(y, r, closest, beam) }
}

/// The number of roots changes only where the ray passes through a rim, starts on the wall, or
/// touches it between the rims.
fn margin(y: [&Real; 2], r: &Real, closest: Option<Real>, beam: &Beam) -> f64 {
    let rims = y.map(|y| through_rim(y, r, beam));
    rims[0].min(rims[1]).min(starts_on_wall(y, r, beam)).min(touches(y, r, closest, beam))
}

fn flat(v: &V) -> V {
    V([v.0[0].clone(), real(0.0), v.0[2].clone()])
}

/// The sign of `y − o_y`.
fn above(y: &Real, beam: &Beam) -> Gate {
    let reach = beam.o_shift + nearest(y).abs();
    Gate::new(&(y - &beam.o.0[1]), reach, 0.0)
}

/// The change that makes the ray meet the rim: the line has to meet the circle, in front of the origin.
fn through_rim(y: &Real, r: &Real, beam: &Beam) -> f64 {
    let up = V([real(0.0), real(1.0), real(0.0)]);
    let line = rim(&V([real(0.0), y.clone(), real(0.0)]), &up, r, beam).margin;
    let rise = Gate::new(&beam.d.0[1], beam.d_shift, 0.0);
    let ahead = Verdict::same_sign(&[above(y, beam), rise]);
    if ahead.holds { line } else { line.max(ahead.margin) }
}

/// The change that puts the origin on the wall: its distance from the axis, and its height.
fn starts_on_wall(y: [&Real; 2], r: &Real, beam: &Beam) -> f64 {
    let reach = beam.o_shift + nearest(r);
    let wall = Gate::new(&(flat(&beam.o).norm() - r), reach, 0.0).not_negative().margin;
    let between =
        Verdict::all([above(y[0], beam).not_positive(), above(y[1], beam).not_negative()]);
    if between.holds { wall } else { wall.max(between.margin) }
}

/// The change that makes the part of the ray between the rims touch the wall: the distance of its point
/// nearest to the axis, as for the sphere. (Its ends are at a rim or at the origin, where
/// [`through_rim`] and [`starts_on_wall`] apply.)
fn touches(y: [&Real; 2], r: &Real, closest: Option<Real>, beam: &Beam) -> f64 {
    let Some((start, end)) = between_rims(y, beam) else { return f64::INFINITY };
    let after_start = closest.unwrap_or_else(|| start.clone()).max(start);
    let t = end.map_or(after_start.clone(), |end| after_start.min(end));
    let distance = flat(&beam.at(&t)).norm();
    let drift = beam.d_shift / beam.d.len();
    let first = beam.o_shift + nearest(&t) * beam.d_shift + nearest(r);
    let second = 0.5 * drift * drift * nearest(&distance);
    Gate::new(&(distance - r), first, second).not_negative().margin
}

/// The span of t ≥ 0 between the rims; it has no end if the ray is horizontal.
fn between_rims(y: [&Real; 2], beam: &Beam) -> Option<(Real, Option<Real>)> {
    let (o, d) = (&beam.o.0[1], &beam.d.0[1]);
    if sign(d).is_eq() {
        return (y[0] <= o && o <= y[1]).then(|| (real(0.0), None));
    }
    let mut ends = y.map(|y| (y - o) / d);
    ends.sort();
    let [start, end] = ends;
    let start = start.max(real(0.0));
    (start <= end).then_some((start, Some(end)))
}
