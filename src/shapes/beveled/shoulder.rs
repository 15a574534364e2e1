//! The round edge of a cylinder's top: the upper half of the points at one distance from a disk,
//! beside the disk. A quarter of a torus, but where the edge is rounder than the disk is wide, of
//! one that meets itself: its quartic has roots on surfaces that are not there.
//!
//! The distance from a disk, which is convex, is a convex function along a line. So a line meets
//! the surface at most twice, once on each side of where it comes nearest to the disk.

use arrayvec::ArrayVec;

use crate::math::{Aabb, Point, Ray, Span, Tolerance, UNIT_ROUNDOFF, Vector, bracketed_root};
use crate::shapes::plain::torus::{Line, from_axis};
use crate::shapes::{Candidate, Shape, Surface, normal_along};

/// The points at `distance` from the disk of radius `disk` about the origin in the plane y = 0, above
/// the plane and not above the disk. With a disk of radius 0 this is a hemisphere.
#[derive(Debug)]
pub(in crate::shapes) struct Shoulder {
    pub(in crate::shapes) disk: f64,
    pub(in crate::shapes) distance: f64,
}

impl Shoulder {
    /// From the origin to outside of everything, with a little to spare.
    fn reach(&self) -> f64 {
        const SPARE: f64 = 1.0 + 1.0 / (1 << 20) as f64;
        SPARE * (self.disk + self.distance)
    }

    /// The square of the distance from the disk, half its slope along the line, and half the slope
    /// of that.
    fn squared(&self, line: &Line, s: f64) -> [f64; 3] {
        let (p, d) = (line.at(s), line.d);
        let (rho, y) = (from_axis(p), p.y());
        let beside = rho - self.disk;
        if beside <= 0.0 {
            return [y * y, y * d.y(), d.y() * d.y()];
        }
        let slope = (p.x() * d.x() + p.z() * d.z()) / rho;
        let across = d.x() * d.x() + d.z() * d.z();
        let share = beside / rho; // ρ'' = (across − ρ'²)/ρ
        let bend = slope * slope * (1.0 - share) + across * share;
        [beside * beside + y * y, beside * slope + y * d.y(), bend + d.y() * d.y()]
    }

    /// Both places where the line is at the distance, ascending.
    fn crossings(&self, line: &Line) -> ArrayVec<f64, 2> {
        let (end, size) = (self.reach(), self.disk + self.distance);
        let mut crossings = ArrayVec::new();
        let slope = |s: f64| self.squared(line, s)[1];
        // what is nearest to the disk beyond its reach is farther off than the distance
        if !(line.m.length_squared() < end * end && slope(-end) < 0.0 && slope(end) > 0.0) {
            return crossings;
        }
        // there the square of the distance is stationary, its second slope at most 2, so a step δ
        // beside it costs δ², which may be some of the rounding of the square, 2 u size distance:
        // half of the digits are enough, but of a thin edge, that is of its chords, not of the disk
        let step = 0.1 * (UNIT_ROUNDOFF * size * self.distance).sqrt();
        let coarse = Tolerance { value: 0.0, step };
        let slopes = |s: f64| {
            let [_, slope, bend] = self.squared(line, s);
            [slope, bend]
        };
        let nearest = bracketed_root(slopes, [-end, end], 0.0, coarse);
        let power = |s: f64| {
            let [square, slope, _] = self.squared(line, s);
            [square - self.distance * self.distance, 2.0 * slope]
        };
        let [depth, _] = power(nearest);
        if depth < 0.0 {
            let fine = Tolerance {
                value: 2.0 * UNIT_ROUNDOFF * size * self.distance,
                step: 2.0 * UNIT_ROUNDOFF * size,
            };
            let step = (-depth).sqrt();
            for (outside, start) in [(-end, nearest - step), (end, nearest + step)] {
                crossings.push(bracketed_root(power, [nearest, outside], start, fine));
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
            let here = from_axis(p) >= self.disk && p.y() >= 0.0;
            (span.contains(t) && here).then(|| Candidate::at(t))
        })
    }
}

impl Shape for Shoulder {
    fn hit(&self, ray: &Ray, span: Span) -> Option<Candidate> {
        self.hits(ray, span).next()
    }

    /// The normal is from the disk's border.
    fn surface(&self, ray: &Ray, at: &Candidate) -> Surface {
        let raw = ray.at(at.t).to_vector();
        let border = self.disk * raw.across_y().unit().unwrap_or(Vector::ZERO);
        let normal = normal_along(raw - border, ray);
        let point = Point::ORIGIN + (border + self.distance * normal);
        // as for the torus
        let error = 20.0 * UNIT_ROUNDOFF * (self.disk + self.distance);
        Surface::new(point, error, normal)
    }

    fn roots(&self, ray: &Ray, span: Span) -> Vec<Candidate> {
        self.hits(ray, span).collect()
    }

    fn bounds(&self) -> Aabb {
        let r = self.disk + self.distance;
        Aabb { min: Point::new(-r, 0.0, -r), max: Point::new(r, self.distance, r) }
    }
}
