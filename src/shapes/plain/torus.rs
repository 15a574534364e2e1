//! The torus (Suffern, ch. 19): the points with `(|p|² − a² − b²)² = 4a² (b² − y²)`, or, which is
//! the same with `ρ² = x² + z²`, `(|p|² + a² − b²)² = 4a² ρ²`.
//!
//! The book solves the quartic in `t` that the ray makes of it. Here the ray is measured in lengths
//! `s` from its point `m` nearest to the origin. So `d` is unit, `m·d = 0`, `|p|² = s² + m·m`, and
//! the quartic is
//!
//! `F(s) = (s² + k)² − 4a² (e s² + 2 h s + m_x² + m_z²)`
//!
//! with `k = m·m + a² − b²`, `e = d_x² + d_z²` and `h = m_x d_x + m_z d_z`. Its coefficients lose
//! the digits of a thin tube, so it is not solved; it only says where to search.
//! `F′/4 = s³ + p s + q` with `p = k − 2a² e` and `q = −2a² h` is a cubic without a square, and
//! between its roots `F` is monotone. In each such interval at whose ends `F` has different signs
//! there is one hit. Signs and hits are those of the tube function `G = (ρ − a)² + y² − b²`, which
//! keeps its digits: `F = G · ((ρ + a)² + y² − b²)`, and the second factor is positive for `b < a`.
//! Newton's method on `G`, kept in the interval, finds the hit.
//!
//! The idea of searching between the roots of a derivative: Yuksel, "High-Performance Polynomial
//! Root Finding for Graphics", HPG 2022.
//!
//! The book's own routine: `src/shapes/textbook/torus.rs`.

use arrayvec::ArrayVec;

use crate::invalid::Invalid;
use crate::math::{
    Aabb, Length, Normal, Point, Ray, Span, Tolerance, UNIT_ROUNDOFF, Vector, acos, bracketed_root,
    cbrt, sin_cos,
};
use crate::shapes::trimmed::{Carrier, Roots, Searched, Trimmed};
use crate::shapes::{Context, Made, Specification, Surface, made, textbook};

/// The points at `tube_radius` from the circle of `swept_radius` about the origin in the plane
/// y = 0; the normal points out of the tube.
#[kind(PartialEq)]
pub struct Torus {
    /// The radius of the circle in the middle of the tube, the book's `a`; positive.
    pub swept_radius: Length,
    /// The radius of the tube, the book's `b`: positive, and less than `swept_radius`.
    pub tube_radius: Length,
    /// Whether the normal points into the tube instead.
    #[optional]
    pub inward: bool,
}

impl Specification for Torus {
    fn make(&self, _: &mut Context) -> Made {
        self.check()?;
        made(Trimmed::whole(self.clone()))
    }
}

/// A ray, measured in lengths `s` from its point `m` nearest to the origin.
pub(in crate::shapes) struct Line {
    pub(in crate::shapes) m: Vector,
    /// The direction, unit.
    pub(in crate::shapes) d: Vector,
    /// The distance from the ray's origin to `m`, negative for `m` behind it.
    offset: f64,
    /// The length of the ray's direction.
    length: f64,
}

impl Line {
    /// `None` if the square of the direction's length is 0 or infinite.
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

/// A point inside the tube and one outside, as values of `s`, with one hit between them.
#[derive(Clone, Copy)]
struct Bracket {
    inside: f64,
    /// The tube function at `inside`; negative.
    depth: f64,
    outside: f64,
}

/// The roots of `s³ + p s + q = F′/4` where `F` has a minimum: the only one, or the least and the
/// greatest of three (Cardano; Viète). They are good to 1e-8, and to 1e-5 where they are close to
/// each other. That is enough, as `F` hardly changes there.
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
    let (sin, cos) = sin_cos(angle);
    minima.push(-h * (cos + 3.0_f64.sqrt() * sin)); // −2h cos(π/3 − angle)
    minima.push(2.0 * h * cos);
    minima
}

impl Torus {
    /// Whether the radii are those of a torus that does not meet itself.
    pub(in crate::shapes) fn check(&self) -> Result<(), Invalid> {
        let swept = self.swept_radius;
        let tube = self.tube_radius;
        if tube < swept {
            return Ok(());
        }
        let problem = format!("found {tube}, but it must be less than swept_radius, {swept}");
        Err(Invalid::field("tube_radius", problem))
    }

    /// The radius of a sphere about the origin that is a little larger than the torus.
    fn extent(&self) -> f64 {
        const SPARE: f64 = 1.0 + 1.0 / (1 << 20) as f64;
        SPARE * (self.swept_radius + self.tube_radius)
    }

    /// The tube function `G = (ρ − a)² + y² − b²` and `G′`.
    fn tube_function(&self, line: &Line, s: f64) -> [f64; 2] {
        let (a, b, p, d) = (self.swept_radius, self.tube_radius, line.at(s), line.d);
        let rho = from_axis(p);
        let rho_slope = (p.x() * d.x() + p.z() * d.z()) / rho;
        let value = (rho - a) * (rho - a) + p.y() * p.y() - b * b;
        [value, 2.0 * ((rho - a) * rho_slope + p.y() * d.y())]
    }

    /// A bracket for each hit of the line, ascending.
    fn brackets(&self, line: &Line) -> ArrayVec<Bracket, 4> {
        let (a, b, end) = (self.swept_radius, self.tube_radius, self.extent());
        let Line { m, d, .. } = line;
        let mut brackets = ArrayVec::new();
        let m_squared = m.length_squared();
        let is_near = m_squared < end * end; // false for NaN
        if !is_near {
            return brackets;
        }
        let k = m_squared + (a - b) * (a + b);
        let e = d.x() * d.x() + d.z() * d.z();
        let h = m.x() * d.x() + m.z() * d.z();
        let value = |s: f64| self.tube_function(line, s)[0];
        let minima = minima(k - 2.0 * a * a * e, -2.0 * a * a * h);
        let minima: ArrayVec<_, 2> = minima.into_iter().map(|s| (s, value(s))).collect();
        let mut add = |(inside, depth), outside| {
            brackets.push(Bracket { inside, depth, outside });
        };
        match minima[..] {
            [c] if c.1 < 0.0 => {
                add(c, -end);
                add(c, end);
            }
            [c, e] => match (c.1 < 0.0, e.1 < 0.0) {
                (true, false) => {
                    add(c, -end);
                    add(c, e.0);
                }
                (false, true) => {
                    add(e, c.0);
                    add(e, end);
                }
                (true, true) => {
                    add(c, -end);
                    let maximum = -(c.0 + e.0); // the sum of the cubic's three roots is 0
                    if value(maximum) >= 0.0 {
                        add(c, maximum);
                        add(e, maximum);
                    }
                    add(e, end);
                }
                (false, false) => {}
            },
            _ => {}
        }
        brackets
    }

    /// The hit of a bracket, by Newton's method. `G` is nearly `G(inside) + (s − inside)²` where it
    /// has a minimum, so it starts at the root of that.
    fn solve(&self, line: &Line, Bracket { inside, depth, outside }: Bracket) -> f64 {
        let size = self.extent();
        let tolerance = Tolerance {
            value: 2.0 * UNIT_ROUNDOFF * size * self.tube_radius,
            step: 2.0 * UNIT_ROUNDOFF * size,
        };
        let step = (-depth).sqrt().copysign(outside - inside);
        let g = |s: f64| self.tube_function(line, s);
        bracketed_root(g, [inside, outside], inside + step, tolerance)
    }
}

impl Carrier for Torus {
    const WHOLE: &'static str = "whole torus";

    fn roots(&self, ray: &Ray, span: Span, bounds: &Aabb) -> impl Roots {
        let line = if bounds.padded().may_meet(ray, span.min) { Line::new(ray) } else { None };
        let brackets = line.as_ref().map(|line| self.brackets(line)).unwrap_or_default();
        Searched(brackets.into_iter().filter_map(move |bracket| {
            let line = line.as_ref()?;
            let Bracket { inside, outside, .. } = bracket;
            let [first, last] = [inside.min(outside), inside.max(outside)];
            let is_beyond = line.t(last) <= span.min || line.t(first) >= span.max;
            (!is_beyond).then(|| line.t(self.solve(line, bracket)))
        }))
    }

    fn book_roots(&self, ray: &Ray, span: Span) -> impl IntoIterator<Item = f64> {
        textbook::torus_roots(ray, self.swept_radius, self.tube_radius, span)
    }

    /// The normal points away from the circle in the middle of the tube, and the point is `b` along
    /// it.
    fn surface(&self, ray: &Ray, t: f64) -> Surface {
        let raw = ray.at(t).to_vector();
        let rho = from_axis(raw);
        // a far hit may be rounded onto the axis: any direction from it will do
        let radial = raw.across_y().unit().unwrap_or(Vector::X);
        // in the plane of the axis and the point: raw − a radial would have roundings across that plane
        let from_middle = (rho - self.swept_radius) * radial + raw.y() * Vector::Y;
        let outward = Normal::new(from_middle).or_else(|| Normal::new(radial)).unwrap_or(Normal::Y);
        let point =
            Point::ORIGIN + (self.swept_radius * radial + self.tube_radius * Vector::from(outward));
        // roundings of the sums above, and of the next ray's m, p and ρ
        let error = 20.0 * UNIT_ROUNDOFF * (self.swept_radius + self.tube_radius);
        Surface::new(point, error, if self.inward { -outward } else { outward })
    }

    fn bounds(&self) -> Aabb {
        let (r, b) = (self.swept_radius + self.tube_radius, self.tube_radius);
        Aabb { min: Point::new(-r, -b, -r), max: Point::new(r, b, r) }
    }
}
