//! The torus (Suffern, ch. 19).
//!
//! The book forms the quartic `F(t) = 0` and solves it. Its coefficients lose the digits of a thin
//! tube or a far origin, so here the quartic only says *where to look*. With the ray's parameter `s`
//! counted from its point nearest to the torus's centre and in lengths, `F'` is a cubic without a
//! square: `s³ + p s + q`. Between its roots `F` is monotone, and the sign of `F` is that of the
//! distance from the tube, `√(ρ−a)² + y² − b` with `ρ = √(x²+z²)`, which loses nothing. A change of
//! sign is a hit; Newton's method on the distance's square finds it (for the idea: Yuksel,
//! "High-Performance Polynomial Root Finding for Graphics", HPG 2022).

use std::sync::Arc;

use arrayvec::ArrayVec;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::invalid::{Invalid, length};
use crate::kinds::Specification;
use crate::math::{
    Aabb, Normal, Point, Ray, Span, Tolerance, UNIT_ROUNDOFF, Vector, acos, bracketed_root, cbrt,
    cos,
};
use crate::shapes::{Candidate, Context, Shape, Surface};

/// The points at `tube_radius` from the circle of `swept_radius` about the origin in the plane
/// y = 0; the normal points out of the tube.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Torus {
    /// The radius of the circle in the middle of the tube, the book's `a`; positive.
    pub swept_radius: f64,
    /// The radius of the tube, the book's `b`: positive, and less than `swept_radius`.
    pub tube_radius: f64,
    /// Whether the normal points into the tube instead.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub inward: bool,
}

impl Specification for Torus {
    type Built = Arc<dyn Shape>;
    type Context = Context;

    fn build(&self, _: &mut Context) -> Result<Arc<dyn Shape>, Invalid> {
        self.check()?;
        Ok(Arc::new(self.clone()))
    }

    fn scaled(&self, factor: f64) -> Self {
        let [swept_radius, tube_radius] = [self.swept_radius, self.tube_radius].map(|r| factor * r);
        Self { swept_radius, tube_radius, ..*self }
    }

    fn specimens() -> Vec<Self> {
        vec![
            Self { swept_radius: 2.0, tube_radius: 0.5, inward: false },
            Self { swept_radius: 1.0, tube_radius: 0.9, inward: false },
            Self { swept_radius: 1.5, tube_radius: 0.125, inward: false },
        ]
    }
}

/// A ray about its point `m` nearest to the origin.
pub(in crate::shapes) struct Line {
    pub(in crate::shapes) m: Vector,
    /// Unit.
    pub(in crate::shapes) d: Vector,
    /// From the ray's origin to `m`.
    offset: f64,
    /// Of the ray's direction.
    length: f64,
}

impl Line {
    /// `None` for directions so short or long that their squares leave the range of numbers.
    pub(in crate::shapes) fn new(ray: &Ray) -> Option<Self> {
        let length = ray.direction.length();
        if !(length > 0.0 && length.is_finite()) {
            return None;
        }
        let d = ray.direction / length;
        let o = ray.origin.to_vector();
        let offset = -o.dot(d);
        Some(Self { m: o + offset * d, d, offset, length })
    }

    pub(in crate::shapes) fn at(&self, s: f64) -> Vector {
        self.m + s * self.d
    }

    /// The ray's parameter; ascends with `s`.
    pub(in crate::shapes) fn t(&self, s: f64) -> f64 {
        (self.offset + s) / self.length
    }
}

/// The distance from the axis.
pub(in crate::shapes) fn from_axis(p: Vector) -> f64 {
    (p.x() * p.x() + p.z() * p.z()).sqrt()
}

/// One place inside the tube and one outside, with one hit between them.
type Bracket = [f64; 2];

/// The roots of `s³ + p s + q` that are minima of its integral: one, or the least and the greatest
/// of three (Cardano; Viète). Good to some 1e-8, and where they are close to each other 1e-5: what
/// is asked there is stationary.
fn minima(p: f64, q: f64) -> ArrayVec<f64, 2> {
    let (third, half) = (p / 3.0, 0.5 * q);
    let discriminant = half * half + third * third * third;
    let mut minima = ArrayVec::new();
    if discriminant >= 0.0 {
        let u = cbrt(half.abs() + discriminant.sqrt());
        let size = if u == 0.0 { 0.0 } else { u - third / u };
        minima.push(if half > 0.0 { -size } else { size });
        return minima;
    }
    let h = (-third).sqrt();
    let angle = acos((-half / (h * h * h)).clamp(-1.0, 1.0)) / 3.0;
    minima.push(-2.0 * h * cos(std::f64::consts::FRAC_PI_3 - angle));
    minima.push(2.0 * h * cos(angle));
    minima
}

impl Torus {
    /// Whether the radii are those of a torus that does not meet itself.
    pub(in crate::shapes) fn check(&self) -> Result<(), Invalid> {
        let swept = length("swept_radius", self.swept_radius)?;
        let tube = length("tube_radius", self.tube_radius)?;
        if tube < swept {
            return Ok(());
        }
        let problem = format!("found {tube}, but it must be less than swept_radius, {swept}");
        Err(Invalid::field("tube_radius", problem))
    }

    /// From the origin to outside of everything, with a little to spare.
    fn reach(&self) -> f64 {
        const SPARE: f64 = 1.0 + 1.0 / (1 << 20) as f64;
        SPARE * (self.swept_radius + self.tube_radius)
    }

    /// The square of the distance from the middle of the tube, less that of its radius; and half
    /// its slope along the line.
    fn power(&self, line: &Line, s: f64) -> [f64; 2] {
        let p = line.at(s);
        let rho = from_axis(p);
        let k = rho - self.swept_radius;
        let power = k * k + p.y() * p.y() - self.tube_radius * self.tube_radius;
        let slope = (p.x() * line.d.x() + p.z() * line.d.z()) / rho;
        [power, 2.0 * (k * slope + p.y() * line.d.y())]
    }

    /// A bracket for each hit of the line, ascending.
    fn brackets(&self, line: &Line) -> ArrayVec<Bracket, 4> {
        let (a, b, end) = (self.swept_radius, self.tube_radius, self.reach());
        let Line { m, d, .. } = line;
        let mut brackets = ArrayVec::new();
        let from_center = m.length_squared();
        let near = from_center < end * end; // also false for NaN
        if !near {
            return brackets;
        }
        let across = d.x() * d.x() + d.z() * d.z();
        let p = from_center + (a - b) * (a + b) - 2.0 * a * a * across;
        let q = -2.0 * a * a * (m.x() * d.x() + m.z() * d.z());
        let minima = minima(p, q);
        let inside = |s: f64| self.power(line, s)[0] < 0.0;
        match minima[..] {
            [c] if inside(c) => brackets.extend([[c, -end], [c, end]]),
            [c, e] => match (inside(c), inside(e)) {
                (true, false) => brackets.extend([[c, -end], [c, e]]),
                (false, true) => brackets.extend([[e, c], [e, end]]),
                (true, true) => {
                    brackets.push([c, -end]);
                    let maximum = -(c + e); // the three roots of the cubic have the sum 0
                    if !inside(maximum) {
                        brackets.extend([[c, maximum], [e, maximum]]);
                    }
                    brackets.push([e, end]);
                }
                (false, false) => {}
            },
            _ => {}
        }
        brackets
    }

    /// The hit of a bracket: Newton's method from where the parabola of the tube's power, as at the
    /// place inside, is zero.
    fn solve(&self, line: &Line, [inside, outside]: Bracket) -> f64 {
        let size = self.reach();
        let tolerance = Tolerance {
            value: 2.0 * UNIT_ROUNDOFF * size * self.tube_radius,
            step: 2.0 * UNIT_ROUNDOFF * size,
        };
        let step = (-self.power(line, inside)[0]).sqrt().copysign(outside - inside);
        bracketed_root(|s| self.power(line, s), [inside, outside], inside + step, tolerance)
    }

    /// The hits inside the span whose points are wanted, ascending. Those are in this box.
    pub(in crate::shapes) fn hits(
        &self,
        ray: &Ray,
        span: Span,
        bounds: &Aabb,
        wanted: impl Fn(Vector) -> bool,
    ) -> impl Iterator<Item = Candidate> {
        let line = if bounds.may_meet(ray, span.min) { Line::new(ray) } else { None };
        let brackets = line.as_ref().map(|line| self.brackets(line)).unwrap_or_default();
        brackets.into_iter().filter_map(move |bracket| {
            let line = line.as_ref()?;
            let [first, last] = [bracket[0].min(bracket[1]), bracket[0].max(bracket[1])];
            if line.t(last) <= span.min || line.t(first) >= span.max {
                return None;
            }
            let s = self.solve(line, bracket);
            let t = line.t(s);
            (span.contains(t) && wanted(line.at(s))).then(|| Candidate::at(t))
        })
    }

    /// The normal is from the middle of the tube, and the point at the tube's radius along it.
    pub(in crate::shapes) fn surface_at(&self, ray: &Ray, at: &Candidate) -> Surface {
        let raw = ray.at(at.t).to_vector();
        let rho = from_axis(raw);
        // from so far away that the place is rounded onto the axis, some place of the tube will do
        let radial = raw.across_y().unit().unwrap_or(Vector::X);
        // in the plane of the axis and the place: raw - swept_radius * radial has roundings across
        // it, and is nothing else if the place is rounded onto the middle of the tube
        let from_middle = (rho - self.swept_radius) * radial + raw.y() * Vector::Y;
        let outward = Normal::new(from_middle).or_else(|| Normal::new(radial)).unwrap_or(Normal::Y);
        let point =
            Point::ORIGIN + (self.swept_radius * radial + self.tube_radius * Vector::from(outward));
        // the sums above, and those of the next ray: its nearest point, a point of it, and the
        // distance of that from the axis
        let error = 20.0 * UNIT_ROUNDOFF * (self.swept_radius + self.tube_radius);
        Surface::new(point, error, if self.inward { -outward } else { outward })
    }
}

impl Shape for Torus {
    fn hit(&self, ray: &Ray, span: Span) -> Option<Candidate> {
        self.hits(ray, span, &self.bounds().padded(), |_| true).next()
    }

    fn surface(&self, ray: &Ray, at: &Candidate) -> Surface {
        self.surface_at(ray, at)
    }

    fn roots(&self, ray: &Ray, span: Span) -> Vec<Candidate> {
        self.hits(ray, span, &self.bounds().padded(), |_| true).collect()
    }

    fn bounds(&self) -> Aabb {
        let (r, b) = (self.swept_radius + self.tube_radius, self.tube_radius);
        Aabb { min: Point::new(-r, -b, -r), max: Point::new(r, b, r) }
    }
}
