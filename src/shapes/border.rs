//! Borders of parts: the ends of a wall, the rim of a disk, the edges of a triangle.
//!
//! Two parts with a common border round their tests differently. Two rules keep light from passing
//! between them. A hit belongs to a part also if it is beyond the border by no more than its
//! rounding ([`is_rounding`]). And a ray that leaves a hit near a border starts a little inside of
//! it ([`Border::moved_inside`]): there it is on the right side of the neighbouring part too, where
//! the parts meet at more than a degree.

use super::{Candidate, Shape};
use crate::math::{Normal, Point, Ray, Transform, UNIT_ROUNDOFF, Vector};

/// Where a point of a part is relative to the part's border, which is near.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Border {
    /// From the nearest point of the border; negative beyond it.
    distance: f64,
    /// Along the surface: `s` times this vector leads at least `s` farther inside, away from all
    /// borders nearby.
    inward: Vector,
    /// Points inside across the nearest part of the border: against the normal of the wall that
    /// meets it.
    across: Vector,
    /// Bound on the rounding of positions along the surface.
    rounding: f64,
}

/// Rays start this many roundings inside of a border: three error bounds off a wall of some ten
/// roundings, they are then still on the inner side of a wall that meets it at a degree.
const ROUNDINGS_INSIDE: f64 = 4096.0;

/// More than the rounding of a hit, relative to the numbers of which it is a sum; all of it
/// together is less than boxes are grown by.
const HIT: f64 = 12.0 * UNIT_ROUNDOFF;

/// A border at this part of a body's size is too far to matter: by far more than rounding.
const FAR: f64 = (1 << 16) as f64;

/// A hit that is farther beyond a border, in roundings of the part's own numbers, does not count:
/// boxes are grown by more.
const MAX_ROUNDINGS: f64 = 96.0;

/// A smaller cosine between ray and normal enlarges the rounding of a hit along the surface no
/// more.
const MIN_COSINE: f64 = 1.0 / (1 << 16) as f64;

impl Border {
    /// The border with parts at these distances, negative outside, if one is near. `inward` is
    /// called only then, for the unit vectors along the surface that lead away from each part.
    /// `size` is the largest number in the test.
    pub fn of<const PARTS: usize>(
        distances: [f64; PARTS],
        size: f64,
        inward: impl FnOnce() -> [Vector; PARTS],
    ) -> Option<Box<Self>> {
        if least(distances) > size / FAR {
            return None; // as nearly everywhere
        }
        Some(Box::new(Self::near(&distances, &inward(), size)))
    }

    #[cold]
    #[inline(never)]
    fn near(distances: &[f64], directions: &[Vector], size: f64) -> Self {
        let (inward, across) = (Vector::ZERO, Vector::ZERO);
        let mut border =
            Self { distance: f64::INFINITY, inward, across, rounding: UNIT_ROUNDOFF * size };
        let mut second = border;
        for (&distance, &inward) in distances.iter().zip(directions) {
            if distance < border.distance {
                (second.distance, second.inward) = (border.distance, border.inward);
                (border.distance, border.inward) = (distance, inward);
            } else if distance < second.distance {
                (second.distance, second.inward) = (distance, inward);
            }
        }
        border.across = border.inward;
        // in a corner away from both; two opposite ends are no corner
        let cosine = border.inward.dot(second.inward);
        if second.distance < size / FAR && cosine > -0.75 {
            border.inward = (1.0 / (1.0 + cosine)) * (border.inward + second.inward);
        }
        border
    }

    /// The same on a surface with this normal at the point, if the border's own plane differs by a
    /// small angle.
    pub(super) fn along(self, normal: Normal) -> Self {
        Self { inward: self.inward - self.inward.dot(normal) * normal, ..self }
    }

    /// The same, if another wall meets it there whose normal is `across`, on either side.
    pub fn cut_across(self, across: Vector) -> Self {
        Self { across: 1.0_f64.copysign(across.dot(self.inward)) * across, ..self }
    }

    /// The border of a triangle with the barycentric coordinates β and γ of the point. Away from
    /// all three edges is towards the centroid, whose distance from an edge is a third of the
    /// height above it.
    pub fn of_triangle(
        corners: [Point; 3],
        [beta, gamma]: [f64; 2],
        point: Point,
    ) -> Option<Box<Self>> {
        let weights = [1.0 - beta - gamma, beta, gamma];
        if least(weights) > 1.0 / FAR {
            return None; // as nearly everywhere
        }
        let [a, b, c] = corners;
        let (ab, ac) = (b - a, c - a);
        let area = ab.cross(ac).length(); // twice
        let heights = [c - b, ac, ab].map(|edge| area / edge.length());
        let distances = [0, 1, 2].map(|i| weights[i] * heights[i]);
        let to_centroid = (a - point + (b - point) + (c - point)) / 3.0;
        let size = corners.iter().fold(0.0_f64, |size, p| size.max(p.to_vector().max_abs()));
        Some(Box::new(Self {
            distance: least(distances),
            inward: to_centroid / (least(heights) / 3.0),
            across: Vector::ZERO,
            rounding: UNIT_ROUNDOFF * size,
        }))
    }

    /// The same outside of an instance whose inner coordinates are rounded by `rounding`.
    pub fn outside(self, transform: &Transform, rounding: f64) -> Self {
        let inward = transform.vector(self.inward);
        let stretch = inward.length() / self.inward.length();
        Self {
            distance: stretch * self.distance,
            inward: inward / stretch,
            across: self.across,
            rounding: stretch * (self.rounding + rounding),
        }
    }

    /// The same in a scene whose lengths are multiplied by `factor`.
    #[must_use]
    pub fn scaled(self, factor: f64) -> Self {
        Self { distance: factor * self.distance, rounding: factor * self.rounding, ..self }
    }

    /// The point itself; if it is near the border, the point is moved along the surface to where
    /// rays start.
    pub fn moved_inside(&self, point: Point) -> Point {
        let least = ROUNDINGS_INSIDE * self.rounding;
        if self.distance < least { point + (least - self.distance) * self.inward } else { point }
    }
}

/// Whether a point is so near a border with parts at these distances that its test may be wrong by
/// rounding. `size` is the largest number in the test.
pub fn nears<const PARTS: usize>(distances: [f64; PARTS], size: f64) -> bool {
    least(distances) >= -size / FAR
}

fn least<const PARTS: usize>(distances: [f64; PARTS]) -> f64 {
    distances.into_iter().fold(f64::INFINITY, f64::min)
}

/// The unit vector along `v`; zero where it has no direction.
pub fn along(v: Vector) -> Vector {
    v.unit().unwrap_or(Vector::ZERO)
}

/// Whether a hit at `t` that is beyond the border of its part is so by rounding only.
///
/// The part that is added by this is outside of the solid, if there is one. A ray that only touches
/// the edge must not meet it from the inside: a ray that comes out of the solid there, leaves it
/// across the wall that meets this one, too, and one that enters it, enters across both.
#[cold]
#[inline(never)]
pub fn is_rounding(shape: &dyn Shape, ray: &Ray, t: f64) -> bool {
    let surface = shape.surface(ray, &Candidate::at(t));
    let Some(border) = surface.border else { return false };
    let Border { distance, across, rounding: own, .. } = *border;
    let d = ray.direction;
    let magnitude = ray.origin.to_vector().abs() + (t * d).abs() + surface.point.to_vector().abs();
    let off = |v: Vector| HIT * magnitude.dot(v.abs());
    // a rounding across the surface moves the hit along the ray
    let slope = surface.normal.dot(d);
    let moved = across.dot(d).abs() / slope.abs().max(MIN_COSINE * d.length());
    let rounding = off(across) + off(surface.normal.into()) * moved; // NaN if squares overflow
    let beyond = -distance;
    beyond <= rounding && beyond <= MAX_ROUNDINGS * own && slope * across.dot(d) <= 0.0
}

/// Whether the ray crosses the level `y`, where a wall ends, at `t` or nearly. A level ray beyond
/// it does not, however the wall's point is rounded.
pub fn nears_level(ray: &Ray, t: f64, y: f64) -> bool {
    let (o, step) = (ray.origin.y(), t * ray.direction.y());
    ((o - y) + step).abs() <= MAX_ROUNDINGS * UNIT_ROUNDOFF * 2.0 * step.abs()
}
