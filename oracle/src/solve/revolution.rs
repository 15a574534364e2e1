//! Parts of quadrics of revolution about a vertical axis: a quadratic, each root filtered by height and
//! azimuth; and a convex function along the ray, which is negative inside.

use super::{
    Beam, Found, Hit,
    border::{Curve, approach, quarters},
    quadratic,
    quadric::{Quadric, Whole, origin, with_height},
};
use crate::{
    angle::{Wedge, degree, sin_cos},
    margin::{Gate, Verdict},
    real::{M, Real, V, magnitude, nearest, real, sign},
};

/// A height `y` at which the part ends, its border's distance `rho` from the axis, and how far a relative
/// change moves the border and the height.
struct Level {
    y: Real,
    rho: Real,
    reach: f64,
}

struct Part<'a> {
    whole: Whole<'a>,
    center: V,
    /// The lower and the upper end; `None` for an end that is a point or does not exist.
    levels: [Option<Level>; 2],
    wedge: Wedge,
    /// The borders along meridians: those of the two ends of the wedge.
    meridians: Vec<Curve>,
    /// How far a relative change moves the surface.
    own: f64,
    /// The relative change that makes the ends of a range meet.
    order: f64,
}

pub(super) fn part_sphere(
    c: &V,
    r: &Real,
    phi: &[Real; 2],
    theta: &[Real; 2],
    beam: &Beam,
) -> Found {
    let own = c.len() + nearest(r);
    let ends = theta.each_ref().map(sin_cos);
    let level = |i: usize| {
        let (s, c) = &ends[i];
        let turn = magnitude(&(&theta[i] * degree()));
        let shrinks = sign(&theta[i]).is_eq() || theta[i] == real(180.0);
        let reach = own + nearest(r) * turn;
        (!shrinks).then(|| Level { y: r * c, rho: r * s, reach })
    };
    let wedge = Wedge::new(phi);
    let up = V([real(0.0), r.clone(), real(0.0)]);
    let params = ends.each_ref().map(|(s, c)| quarters(nearest(s), nearest(c)).abs());
    let meridian = |i: usize| {
        let reach = own + wedge.turns[i] * nearest(r);
        Curve::arc(&origin(), [&up, &(&wedge.ends[i] * r)], params, reach)
    };
    let meridians = if wedge.all { Vec::new() } else { vec![meridian(0), meridian(1)] };
    let levels = [level(1), level(0)];
    let order = nearest(&((&theta[1] - &theta[0]) / (&theta[1] + &theta[0]))).min(wedge.order);
    let whole = Whole::Sphere { r };
    Part { whole, center: c.clone(), levels, wedge, meridians, own, order }.solve(beam)
}

pub(super) fn part_cylinder(y: [&Real; 2], r: &Real, phi: &[Real; 2], beam: &Beam) -> Found {
    let own = nearest(r);
    let wedge = Wedge::new(phi);
    let meridian = |i: usize| {
        let ends = y.map(|y| with_height(&(&wedge.ends[i] * r), y));
        let tall = magnitude(y[0]).max(magnitude(y[1]));
        Curve::line(&ends[0], &ends[1], own + tall + wedge.turns[i] * nearest(r))
    };
    let meridians = if wedge.all { Vec::new() } else { vec![meridian(0), meridian(1)] };
    let level = |y: &Real| Some(Level { y: y.clone(), rho: r.clone(), reach: own + magnitude(y) });
    let levels = y.map(level);
    let (whole, order) = (Whole::Cylinder { r }, wedge.order);
    Part { whole, center: origin(), levels, wedge, meridians, own, order }.solve(beam)
}

pub(super) fn cone(h: &Real, r: &Real, beam: &Beam) -> Found {
    let base = Level { y: real(0.0), rho: r.clone(), reach: nearest(r) };
    // moving either end of the slanted wall moves the wall by at most this along its normal
    let own = 1.01 * nearest(&(h * r / (h * h + r * r).sqrt()));
    whole_turn(Whole::Cone { r, h }, [Some(base), None], own).solve(beam)
}

pub(super) fn paraboloid(h: &Real, r: &Real, beam: &Beam) -> Found {
    let rim = Level { y: h.clone(), rho: r.clone(), reach: nearest(r) + nearest(h) };
    whole_turn(Whole::Paraboloid { r, h }, [None, Some(rim)], 0.0).solve(beam)
}

pub(super) fn dish(h: &Real, r: &Real, beam: &Beam) -> Found {
    let rim = Level { y: h.clone(), rho: r.clone(), reach: nearest(r) + nearest(h) };
    whole_turn(Whole::Dish { r, h }, [None, Some(rim)], 0.0).solve(beam)
}

fn whole_turn(whole: Whole, levels: [Option<Level>; 2], own: f64) -> Part {
    let wedge = Wedge::new(&[real(0.0), real(360.0)]);
    let order = f64::INFINITY;
    Part { whole, center: origin(), levels, wedge, meridians: Vec::new(), own, order }
}

impl Part<'_> {
    fn solve(self, beam: &Beam) -> Found {
        let local = Beam {
            o: &beam.o - &self.center,
            d: beam.d.clone(),
            o_shift: beam.o_shift,
            d_shift: beam.d_shift,
        };
        let Quadric { square, linear, constant } = self.whole.quadric();
        let times = |v: &V| V(std::array::from_fn(|i| &square.0[i] * &v.0[i]));
        let (so, sd) = (times(&local.o), times(&local.d));
        let half = real(0.5);
        let a = &half * sd.dot(&local.d);
        let b = &half * (sd.dot(&local.o) + linear.dot(&local.d));
        let c = &half * so.dot(&local.o) + linear.dot(&local.o) + constant;
        let discriminant = &b * &b - &a * &c;
        let roots = if sign(&a).is_eq() && sign(&b).is_ne() {
            vec![-(&c / (real(2.0) * &b))]
        } else {
            quadratic(&a, &b, &c, &discriminant)
        };
        let terms = magnitude(&(&b * &b)) + magnitude(&(&a * &c));
        let double = magnitude(&discriminant) <= 1e-120 * terms;
        let hessian = M(std::array::from_fn(|i| {
            let mut row = origin();
            row.0[i] = square.0[i].clone();
            row
        }));
        let hits = roots.into_iter().filter_map(|t| {
            let p = local.at(&t);
            let gradient = &times(&p) + &linear;
            let at_apex = sign(&gradient.norm()).is_eq();
            let gradient = if at_apex { V([real(0.0), real(1.0), real(0.0)]) } else { gradient };
            let inputs = gradient.len() * self.center.len() + self.whole.inputs(&p);
            let hessian = Some(hessian.clone());
            self.holds(&p, 0.0).holds.then(|| Hit::new(t, gradient, inputs, hessian))
        });
        // also at an apex, which every steep ray through it hits
        let margin = if double { 0.0 } else { self.margin(&local) };
        Found { hits: hits.collect(), margin }
    }

    /// Whether a point of the surface that moves by `reach·ε` belongs to the part. The other half of a
    /// double cone does not.
    fn holds(&self, p: &V, reach: f64) -> Verdict {
        let y = &p.0[1];
        let above = |y0: &Real, own: f64| Gate::new(&(y - y0), reach + own, 0.0);
        let mut all = vec![self.wedge.holds(p, reach + self.center.len())];
        let [low, high] = &self.levels;
        all.extend(low.as_ref().map(|low| above(&low.y, low.reach).not_negative()));
        all.extend(high.as_ref().map(|high| above(&high.y, high.reach).not_positive()));
        if let Whole::Cone { h, .. } = self.whole {
            all.push(above(h, nearest(h)).not_positive());
        }
        Verdict::all(all)
    }

    /// The number of roots changes only where the ray passes through a border, starts on the surface,
    /// or touches it between borders.
    fn margin(&self, local: &Beam) -> f64 {
        let mut margin = self.order;
        for curve in &self.meridians {
            margin = margin.min(approach(curve, local));
        }
        for level in self.levels.iter().flatten() {
            margin = margin.min(self.through(level, local));
        }
        let start = self.whole.excess(&local.o, local.o_shift, self.own, 0.0).not_negative().margin;
        let within = self.holds(&local.o, local.o_shift);
        margin = margin.min(if within.holds { start } else { start.max(within.margin) });
        for (from, to) in self.spans(local) {
            margin = margin.min(self.touches(local, from, to));
        }
        margin
    }

    /// The change that makes the ray meet the border at a level: the whole circle, or an arc of it.
    fn through(&self, level: &Level, local: &Beam) -> f64 {
        let [from, to] = &self.wedge.ends;
        if self.wedge.all {
            let axes = [V([real(0.0), real(0.0), real(1.0)]), V([real(1.0), real(0.0), real(0.0)])];
            let axes = axes.each_ref().map(|axis| axis * &level.rho);
            let center = with_height(&origin(), &level.y);
            return approach(&Curve::circle(&center, [&axes[0], &axes[1]], level.reach), local);
        }
        // axes rotated so that the range begins at the first one
        let ahead = V([from.0[2].clone(), real(0.0), -&from.0[0]]);
        let param = quarters(nearest(&to.dot(&ahead)), nearest(&to.dot(from)));
        let param = if param < 0.0 { param + 4.0 } else { param };
        let axes = [from, &ahead].map(|axis| axis * &level.rho);
        let center = with_height(&origin(), &level.y);
        approach(&Curve::arc(&center, [&axes[0], &axes[1]], [0.0, param], level.reach), local)
    }

    /// The spans of `t ≥ 0` in which the ray is between the levels and in the wedge.
    fn spans(&self, local: &Beam) -> Vec<(Real, Option<Real>)> {
        let mut ends = vec![real(0.0)];
        let mut crossing = |value: Real, slope: Real| {
            if sign(&slope).is_ne() {
                ends.push(-value / slope);
            }
        };
        for level in self.levels.iter().flatten() {
            crossing(&local.o.0[1] - &level.y, local.d.0[1].clone());
        }
        if !self.wedge.all {
            let [values, slopes] = [self.wedge.sides(&local.o), self.wedge.sides(&local.d)];
            values.into_iter().zip(slopes).for_each(|(value, slope)| crossing(value, slope));
        }
        ends.retain(|t| sign(t).is_ge());
        ends.sort();
        let last = ends.last().expect("it has the origin").clone();
        let beyond = real(2.0) * &last + real(1.0);
        let mut spans: Vec<_> = ends
            .windows(2)
            .map(|pair| (pair[0].clone(), Some(pair[1].clone())))
            .filter(|(from, to)| to.as_ref() != Some(from))
            .collect();
        spans.push((last, None));
        spans.retain(|(from, to)| {
            let to = to.as_ref().unwrap_or(&beyond);
            self.between(&local.at(&((from + to) / real(2.0))))
        });
        spans
    }

    fn between(&self, p: &V) -> bool {
        let [low, high] = &self.levels;
        low.as_ref().is_none_or(|low| low.y <= p.0[1])
            && high.as_ref().is_none_or(|high| p.0[1] <= high.y)
            && self.wedge.holds(p, 0.0).holds
    }

    /// The relative change that makes the ray touch the surface within a span.
    fn touches(&self, local: &Beam, from: Real, to: Option<Real>) -> f64 {
        let after =
            self.whole.closest(&local.o, &local.d).unwrap_or_else(|| from.clone()).max(from);
        let t = to.map_or(after.clone(), |to| after.min(to));
        let p = local.at(&t);
        let drift = local.d_shift / local.d.len();
        let bend = 0.5 * drift * drift * (p.len() + self.own);
        let reach = local.o_shift + nearest(&t) * local.d_shift;
        self.whole.excess(&p, reach, self.own, bend).not_negative().margin
    }
}
