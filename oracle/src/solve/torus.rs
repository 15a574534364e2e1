//! The torus, whole or within ranges of angles: the book's quartic, solved between the roots of its
//! derivatives.

use std::array::from_fn;

use super::{Beam, Found, Hit, polynomial::Polynomial};
use crate::{
    margin::smallest,
    real::{M, Real, V, magnitude, nearest, real, sign},
};

/// The margins are local estimates, which are not valid for changes larger than this.
const MAX: f64 = 1e-3;

/// A range of angles: the ends in degrees.
type Range<'a> = [&'a Real; 2];

/// An end of a range, with its sine and cosine.
struct End<'a> {
    degrees: &'a Real,
    sin: Real,
    cos: Real,
}

/// A point in coordinates of the torus: `k = ρ − a`, and the distance `q` from the tube's centre line.
struct TubePoint {
    p: V,
    rho: Real,
    k: Real,
    q: Real,
}

impl TubePoint {
    /// The unit vector away from the axis. On the axis, which only a tube with `b ≥ a` meets, it is +z.
    fn out(&self) -> V {
        let [x, _, z] = &self.p.0;
        let level = V([x.clone(), real(0.0), z.clone()]);
        level.unit().unwrap_or_else(|| V([0.0, 0.0, 1.0].map(real)))
    }
}

struct Torus<'a> {
    a: &'a Real,
    b: &'a Real,
    /// Azimuth and angle around the tube.
    part: Option<[[End<'a>; 2]; 2]>,
    beam: &'a Beam,
}

/// `F(x) = ((ρ − a)² + y² − b²)/2`, so `F_a = −(ρ − a)` and `F_b = −b`.
pub(super) fn torus(a: &Real, b: &Real, part: Option<[Range<'_>; 2]>, beam: &Beam) -> Found {
    let end = |degrees| {
        let (sin, cos) = Real::sin_cos_unit(degrees, 360);
        End { degrees, sin, cos }
    };
    let part = part.map(|ranges| ranges.map(|range| range.map(end)));
    let torus = Torus { a, b, part, beam };
    let closest = -beam.o.dot(&beam.d) / beam.d.dot(&beam.d);
    let away = beam.at(&closest).norm();
    let reach = real(2.0) * (away + a + b) / beam.d.norm();
    let levels = torus.quartic().levels(&(&closest - &reach), &(&closest + &reach));
    let margin = torus.margin(&levels);
    let hits = levels.into_iter().next().unwrap_or_default();
    let hits = hits.into_iter().filter(|t| {
        let point = torus.tube_point(t);
        torus.is_on_tube(&point) && torus.out_of_range(&point, |_| (0.0, 0.0)) == 0.0
    });
    Found { hits: hits.map(|t| torus.hit(t)).collect(), margin }
}

impl Torus<'_> {
    /// `(|p|² + a² − b²)² − 4 a² ρ²`.
    fn quartic(&self) -> Polynomial {
        let line: [Polynomial; 3] =
            from_fn(|i| Polynomial(vec![self.beam.o.0[i].clone(), self.beam.d.0[i].clone()]));
        let [x, y, z] = line.each_ref().map(|l| l.times(l));
        let flat = x.plus(&z);
        let own = self.a * self.a - self.b * self.b;
        let sum = flat.plus(&y).plus(&Polynomial::constant(own));
        let factor = Polynomial::constant(real(-4.0) * self.a * self.a);
        sum.times(&sum).plus(&flat.times(&factor))
    }

    fn tube_point(&self, t: &Real) -> TubePoint {
        let p = self.beam.at(t);
        let rho = (&p.0[0] * &p.0[0] + &p.0[2] * &p.0[2]).sqrt();
        let k = &rho - self.a;
        let q = (&k * &k + &p.0[1] * &p.0[1]).sqrt();
        TubePoint { p, rho, k, q }
    }

    /// The quartic is `((ρ − a)² + y² − b²)((ρ + a)² + y² − b²)`. If `b > a`, the second factor has roots,
    /// too; they belong to the tube on the other side of the axis.
    fn is_on_tube(&self, point: &TubePoint) -> bool {
        let beyond = &point.rho + self.a;
        let other = (&beyond * &beyond + &point.p.0[1] * &point.p.0[1]).sqrt();
        magnitude(&(&point.q - self.b)) <= magnitude(&(other - self.b))
    }

    fn hit(&self, t: Real) -> Hit {
        let point = self.tube_point(&t);
        let out = point.out();
        let TubePoint { p, rho, k, .. } = point;
        let around = V([out.0[2].clone(), real(0.0), -&out.0[0]]);
        let gradient = V([&k * &out.0[0], p.0[1].clone(), &k * &out.0[2]]);
        let bend = if sign(&rho).is_gt() { &k / &rho } else { real(0.0) };
        let outer = |v: &V, i: usize, j: usize| &v.0[i] * &v.0[j];
        let hessian = M(from_fn(|i| {
            V(from_fn(|j| {
                let up = if i == 1 && j == 1 { 1.0 } else { 0.0 };
                outer(&out, i, j) + &bend * outer(&around, i, j) + real(up)
            }))
        }));
        let inputs = magnitude(&(&k * self.a)) + magnitude(&(self.b * self.b));
        Hit::new(t, gradient, inputs, Some(hessian))
    }

    /// The number of roots changes only where the ray starts on the surface or touches it. It touches the
    /// surface where the distance from the tube and its slope are 0. This is tested at the stationary
    /// points of the quartic, and where higher derivatives vanish, as three or four roots may meet there.
    /// The roots of a part also change where one passes an end of a range.
    fn margin(&self, levels: &[Vec<Real>]) -> f64 {
        let ahead = |level: usize| {
            let points = levels.get(level).into_iter().flatten();
            points.filter(|t| sign(t).is_gt())
        };
        let start = self.touch(&real(0.0), false);
        let stationary = ahead(1).map(|t| self.touch(t, false));
        let higher = (2..levels.len()).flat_map(ahead).map(|t| self.touch(t, true));
        let ends = ahead(0).map(|t| self.at_ends(t));
        let widths = self.part.iter().flatten().map(|range| {
            let [first, last] = range.each_ref().map(|end| end.degrees);
            let turn = nearest(&(last - first)).rem_euclid(360.0);
            let own = magnitude(first) + magnitude(last);
            turn.min(360.0 - turn) / own
        });
        let widths = widths.filter(|margin| *margin > 0.0); // a full turn may grow
        stationary.chain(higher).chain(ends).chain(widths).chain([start]).fold(MAX, f64::min)
    }

    /// The change that puts the point at `t` on the surface and, if `sloped`, makes the ray tangent there.
    fn touch(&self, t: &Real, sloped: bool) -> f64 {
        let point = self.tube_point(t);
        let [q, k, a, b] = [&point.q, &point.k, self.a, self.b].map(nearest);
        if q == 0.0 || nearest(&point.rho) == 0.0 {
            return smallest(b, self.moves(t) + a + b, 0.0);
        }
        let moves = self.moves(t);
        let first = moves + (k / q).abs() * a + b;
        let bend = 1.0 / q + 1.0 / nearest(&point.rho);
        let reach = moves + a;
        let distance = smallest(magnitude(&(&point.q - self.b)), first, bend * reach * reach);
        let distance = distance.max(self.out_of_range(&point, |_| (moves, 0.0)));
        if !sloped {
            return distance;
        }
        let [x, y, z] = point.p.0.each_ref();
        let [dx, dy, dz] = self.beam.d.0.each_ref();
        let slope = (&point.k * (x * dx + z * dz) / &point.rho + y * dy) / &point.q;
        let turn = self.beam.d_shift + self.beam.d.len() * bend * reach;
        distance.max(smallest(magnitude(&slope), turn, turn * bend * reach))
    }

    /// How far the point at `t` may move.
    fn moves(&self, t: &Real) -> f64 {
        self.beam.o_shift + magnitude(t) * self.beam.d_shift
    }

    /// The change that moves a root to an end of a range. The root stays on the surface: where the ray
    /// moves by δ, the root moves by `δ − d (n·δ)/(n·d)`, and across an end with normal m by
    /// `(m − n (m·d)/(n·d))·δ`.
    fn at_ends(&self, t: &Real) -> f64 {
        let point = self.tube_point(t);
        let hit = self.hit(t.clone());
        let moves = self.moves(t);
        let (size, slope) = (hit.gradient.len(), nearest(&hit.gradient.dot(&self.beam.d)));
        if slope == 0.0 {
            return 0.0; // a double root
        }
        let along = (size * moves + hit.inputs) / slope.abs() * self.beam.d.len();
        let bend = 1.0 / nearest(self.b) + 1.0 / nearest(&point.rho);
        let moved = |m: &V| {
            let ratio = nearest(&(m.dot(&self.beam.d) / hit.gradient.dot(&self.beam.d)));
            let across = (m - &(&hit.gradient * &real(ratio))).len();
            let second = ratio.abs() * size * bend * (moves + along) * (moves + along);
            (across * moves + ratio.abs() * hit.inputs, second)
        };
        let outside = self.out_of_range(&point, moved);
        if outside > 0.0 {
            return outside;
        }
        let ends = self.ends(&point, moved);
        ends.iter().flatten().map(|end| end.0).fold(f64::INFINITY, f64::min)
    }

    /// 0 for a point in both ranges; else the change that moves it there.
    fn out_of_range(&self, point: &TubePoint, moves: impl Fn(&V) -> (f64, f64)) -> f64 {
        let part = self.part.iter().flatten();
        let outside = part.zip(self.ends(point, moves)).map(|(range, ends)| {
            let [after, before] = ends.map(|end| end.1);
            let turn = range[1].degrees - range[0].degrees;
            let turn = if sign(&turn).is_lt() { turn + real(360.0) } else { turn };
            let inside = if turn >= real(360.0) {
                true
            } else if turn > real(180.0) {
                after || !before || ends.iter().any(|end| end.0 == 0.0)
            } else {
                (after || ends[0].0 == 0.0) && (!before || ends[1].0 == 0.0)
            };
            if inside { 0.0 } else { ends[0].0.min(ends[1].0).max(f64::MIN_POSITIVE) }
        });
        outside.fold(0.0, f64::max)
    }

    /// For each end of each range: the change that moves the point there, and whether the point is at an
    /// angle of 0° to 180° after this end. `moves` gives how far the point moves in a direction, to first
    /// and second order.
    fn ends(&self, point: &TubePoint, moves: impl Fn(&V) -> (f64, f64)) -> Vec<[(f64, bool); 2]> {
        let zero = || real(0.0);
        let out = point.out();
        let z = V([zero(), zero(), real(1.0)]);
        let x = V([real(1.0), zero(), zero()]);
        let y = V([zero(), real(1.0), zero()]);
        let around_axis = ([&point.p.0[2], &point.p.0[0]], &point.rho, [&z, &x], 0.0);
        let around_tube = ([&point.k, &point.p.0[1]], &point.q, [&out, &y], nearest(self.a));
        let part = self.part.iter().flatten().zip([around_axis, around_tube]);
        let ends = part.map(|(range, ([cos, sin], radius, axes, a))| {
            range.each_ref().map(|End { degrees, sin: end_sin, cos: end_cos }| {
                let off = end_cos * sin - end_sin * cos;
                let along = end_cos * cos + end_sin * sin;
                let radius = nearest(radius);
                let distance = if sign(&along).is_gt() { magnitude(&off) } else { radius };
                let (first, second) = moves(&(&(axes[1] * end_cos) - &(axes[0] * end_sin)));
                let own = radius * nearest(degrees).abs().to_radians() + magnitude(end_sin) * a;
                (smallest(distance, first + own, second), sign(&off).is_gt())
            })
        });
        ends.collect()
    }
}
