//! The round edge of a cylinder's top: with `ρ = √(x² + z²)` the points with `(ρ − a)² + y² = b²`,
//! `ρ ≥ a` and `y ≥ 0`.
//!
//! This is a quarter of a torus (Suffern, ch. 21). But where `b > a` the torus meets itself, and
//! its quartic has roots on its inner sheet. So what is solved here is `D(s) = b²`, where
//! `D = max(ρ − a, 0)² + y²` is the squared distance from a disk of radius `a`. A disk is convex,
//! so `D` is a convex function along a line: it has one minimum, the root of `D′`, and is `b²` at
//! most once on each side of it.

use arrayvec::ArrayVec;

use crate::math::{Aabb, Point, Ray, Span, Tolerance, UNIT_ROUNDOFF, Vector, bracketed_root};
use crate::shapes::border::{Border, along, is_rounding};
use crate::shapes::plain::torus::{Line, from_axis};
use crate::shapes::{Candidate, Shape, Surface, normal_along};

/// The points at the distance `b` from the disk of radius `a` about the origin in the plane y = 0,
/// above the plane and not above the disk: for `a = 0` a hemisphere.
#[derive(Debug)]
pub(in crate::shapes) struct Shoulder {
    pub(in crate::shapes) a: f64,
    pub(in crate::shapes) b: f64,
}

impl Shoulder {
    /// The radius of a sphere about the origin that is a little larger than the surface.
    fn extent(&self) -> f64 {
        const SPARE: f64 = 1.0 + 1.0 / (1 << 20) as f64;
        SPARE * (self.a + self.b)
    }

    /// `D`, `D′/2` and `D″/2`.
    fn distance_squared(&self, line: &Line, s: f64) -> [f64; 3] {
        let (p, d) = (line.at(s), line.d);
        let (rho, y) = (from_axis(p), p.y());
        let k = rho - self.a;
        if k <= 0.0 {
            return [y * y, y * d.y(), d.y() * d.y()];
        }
        let rho_slope = (p.x() * d.x() + p.z() * d.z()) / rho;
        let across = d.x() * d.x() + d.z() * d.z();
        // (k ρ′)′ = ρ′² + k ρ″ with ρ″ = (across − ρ′²)/ρ
        let share = k / rho;
        let bend = rho_slope * rho_slope * (1.0 - share) + across * share;
        [k * k + y * y, k * rho_slope + y * d.y(), bend + d.y() * d.y()]
    }

    /// Where the line is at the distance `b` from the disk, ascending.
    fn crossings(&self, line: &Line) -> ArrayVec<f64, 2> {
        let (end, size) = (self.extent(), self.a + self.b);
        let mut crossings = ArrayVec::new();
        let slope = |s: f64| self.distance_squared(line, s)[1];
        // points beyond ±end are farther from the disk than b
        if !(line.m.length_squared() < end * end && slope(-end) < 0.0 && slope(end) > 0.0) {
            return crossings;
        }
        // D″ ≤ 2, so a step δ beside the minimum costs δ² of D, whose rounding is 2 u size b; the factor
        // 0.1 keeps δ small beside the chords of a thin edge
        let step = 0.1 * (UNIT_ROUNDOFF * size * self.b).sqrt();
        let slopes = |s: f64| {
            let [_, slope, bend] = self.distance_squared(line, s);
            [slope, bend]
        };
        let nearest = bracketed_root(slopes, [-end, end], 0.0, Tolerance { value: 0.0, step });
        let f = |s: f64| {
            let [square, slope, _] = self.distance_squared(line, s);
            [square - self.b * self.b, 2.0 * slope]
        };
        let [least, _] = f(nearest);
        if least < 0.0 {
            let fine = Tolerance {
                value: 2.0 * UNIT_ROUNDOFF * size * self.b,
                step: 2.0 * UNIT_ROUNDOFF * size,
            };
            let step = (-least).sqrt();
            for (outside, start) in [(-end, nearest - step), (end, nearest + step)] {
                crossings.push(bracketed_root(f, [nearest, outside], start, fine));
            }
        }
        crossings
    }

    fn hits(&self, ray: &Ray, span: Span) -> impl Iterator<Item = Candidate> {
        let meets = self.bounds().padded().may_meet(ray, span.min);
        let line = if meets { Line::new(ray) } else { None };
        let crossings = line.as_ref().map(|line| self.crossings(line)).unwrap_or_default();
        crossings.into_iter().filter_map(move |s| {
            let line = line.as_ref()?;
            let (t, p) = (line.t(s), line.at(s));
            let is_on_edge = || from_axis(p) >= self.a && p.y() >= 0.0 || is_rounding(self, ray, t);
            (span.contains(t) && is_on_edge()).then(|| Candidate::at(t))
        })
    }
}

impl Shape for Shoulder {
    fn hit(&self, ray: &Ray, span: Span) -> Option<Candidate> {
        self.hits(ray, span).next()
    }

    /// The normal points away from the nearest point of the disk's border.
    fn surface(&self, ray: &Ray, at: &Candidate) -> Surface {
        let raw = ray.at(at.t).to_vector();
        let border = self.a * raw.across_y().unit().unwrap_or(Vector::ZERO);
        let normal = normal_along(raw - border, ray);
        let point = Point::ORIGIN + (border + self.b * normal);
        // as the torus
        let error = 20.0 * UNIT_ROUNDOFF * (self.a + self.b);
        let from_disk = from_axis(point.to_vector()) - self.a;
        let border = Border::of([from_disk, point.y()], self.a + self.b, || {
            [along(point.to_vector().across_y()), Vector::Y]
        });
        Surface::new(point, error, normal).within(border)
    }

    fn roots(&self, ray: &Ray, span: Span) -> Vec<Candidate> {
        self.hits(ray, span).collect()
    }

    fn bounds(&self) -> Aabb {
        let r = self.a + self.b;
        Aabb { min: Point::new(-r, 0.0, -r), max: Point::new(r, self.b, r) }
    }
}
