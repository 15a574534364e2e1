//! The sphere (Suffern, ch. 3): the points `p` with `|p − c|² = r²`.
//!
//! With `f = o − c` a ray meets it where `d·d t² + 2 f·d t + f·f − r² = 0`. The book takes the
//! discriminant as `b² − 4ac`; here a quarter of it is `r² d·d − |f × d|²`, which keeps its digits
//! for far and for small spheres ([`perpendicular_roots`]).

use std::f64::consts::PI;

use crate::math::{
    Aabb, Frame, Length, Normal, Point, Ray, Span, UNIT_ROUNDOFF, Vector, maps, perpendicular_roots,
};
use crate::shapes::sampled::{ByArea, EvenSurface};
use crate::shapes::textbook::schoolbook_roots;
use crate::shapes::trimmed::{Carrier, Roots, Trimmed};
use crate::shapes::{
    Context, Made, SampledSurface, Sampling, Specification, Surface, made, normal_along,
};

/// All points `p` with `|p − center| = radius`; the normal points outward, or to the centre.
#[kind(PartialEq)]
pub struct Sphere {
    /// The centre.
    pub center: Point,
    /// The radius; positive.
    pub radius: Length,
    /// Whether the normal points to the centre: the book's concave sphere.
    #[optional]
    pub inward: bool,
}

impl Specification for Sphere {
    fn make(&self, _: &mut Context) -> Made {
        let sampler = |it: &Trimmed<Self>, sampling| -> Option<Box<dyn SampledSurface>> {
            Some(match sampling {
                Sampling::Area => Box::new(ByArea(it.carrier.clone())),
                Sampling::SolidAngle => Box::new(ByCone(it.carrier.clone())),
            })
        };
        made(Trimmed { sampler, ..Trimmed::whole(self.clone()) })
    }
}

impl Sphere {
    /// The surface where its outward normal is this.
    fn surface_along(&self, normal: Normal) -> Surface {
        let point = self.center + self.radius * normal;
        // roundings of the sum above, and of the next ray's f and f·f − r²
        let magnitude = point.to_vector().abs() + self.center.to_vector().abs();
        let error = 4.0 * UNIT_ROUNDOFF * magnitude.dot(Vector::from(normal).abs())
            + 8.0 * UNIT_ROUNDOFF * self.radius;
        Surface::new(point, error, normal).turned(self.inward)
    }

    /// Where the line meets the sphere, ascending.
    #[inline(always)] // as the roots it calls
    pub(in crate::shapes) fn distances(&self, ray: &Ray) -> Option<[f64; 2]> {
        perpendicular_roots(ray.origin - self.center, ray.direction, self.radius)
    }
}

impl Carrier for Sphere {
    const WHOLE: &'static str = "whole sphere";

    #[inline]
    fn center(&self) -> Point {
        self.center
    }

    #[inline]
    fn roots(&self, ray: &Ray, _: Span, _: &Aabb) -> impl Roots {
        self.distances(ray)
    }

    fn book_roots(&self, ray: &Ray, _: Span) -> impl IntoIterator<Item = f64> {
        let temp = ray.origin - self.center;
        let a = ray.direction.dot(ray.direction);
        let b = 2.0 * temp.dot(ray.direction);
        let c = temp.dot(temp) - self.radius * self.radius;
        schoolbook_roots(a, b, c).into_iter().flatten()
    }

    fn surface(&self, ray: &Ray, t: f64) -> Surface {
        self.surface_along(normal_along(ray.at(t) - self.center, ray))
    }

    fn bounds(&self) -> Aabb {
        let r = self.radius * Vector::new(1.0, 1.0, 1.0);
        Aabb { min: self.center - r, max: self.center + r }
    }
}

impl Sphere {
    /// Whether the sphere itself hides this point of it from `from`: not if it is on the
    /// silhouette, and not if `from` is inside.
    fn hides(&self, from: Point, at: &Surface) -> bool {
        let (way, out) = (from - at.point, at.point - self.center);
        way.dot(out) < -64.0 * UNIT_ROUNDOFF * way.length() * self.radius && self.is_outside(from)
    }

    /// Whether a point is outside by more than rounding, so that a point of the sphere is not.
    fn is_outside(&self, from: Point) -> bool {
        let magnitude = from.to_vector().max_abs() + self.center.to_vector().max_abs();
        from.distance(self.center) > self.radius + 64.0 * UNIT_ROUNDOFF * magnitude
    }
}

impl EvenSurface for Sphere {
    /// From outside only the near side is seen, also of a sphere that casts no shadow.
    fn is_hidden(&self, from: Point, at: &Surface) -> bool {
        self.hides(from, at)
    }

    fn area(&self) -> f64 {
        4.0 * PI * self.radius * self.radius
    }

    fn point(&self, u: [f64; 2]) -> Surface {
        let normal = Normal::new(maps::sphere(u)).unwrap_or(Normal::Z);
        self.surface_along(normal)
    }
}

/// A sphere sampled evenly by solid angle: from outside in the cone of directions that meet it;
/// from inside, where all of it is visible, by area.
#[derive(Debug)]
struct ByCone(Sphere);

impl ByCone {
    /// The axis of the cone, from `from` to the centre, and `1 − cosθ_max` of its half-angle;
    /// `None` inside.
    fn cone(&self, from: Point) -> Option<(Vector, f64)> {
        let axis = self.0.center - from;
        let sine = self.0.radius / axis.length();
        // 1 − cosθ = sin²θ/(1 + cosθ), without cancellation for a far sphere
        self.0.is_outside(from).then(|| {
            let cosine = ((1.0 - sine) * (1.0 + sine)).sqrt();
            (axis, sine * sine / (1.0 + cosine))
        })
    }
}

/// Points of the unit disk nearer to its rim are moved inward: on the silhouette itself rounding
/// would put them in front of the sphere or behind it.
const RIM: f64 = 1.0 - 1e-12;

impl SampledSurface for ByCone {
    /// The map from the square to the disk keeps ratios of areas, and so does
    /// `1 − cosθ = ρ² (1 − cosθ_max)` from the disk to the cone. With d the distance of the centre,
    /// the angle α at the centre between `from` and the point has `sin(α + θ) = (d/r) sinθ`; from
    /// it follows the normal, without a difference of long distances.
    fn sample(&self, from: Point, u: [f64; 2]) -> Option<(Surface, f64)> {
        let Some((axis, opening)) = self.cone(from) else {
            return self.0.sample_by_area(from, u);
        };
        let [mut x, mut y] = maps::disk(u);
        if x * x + y * y > RIM {
            (x, y) = (RIM * x, RIM * y);
        }
        let rho_squared = x * x + y * y;
        let cos_theta = 1.0 - rho_squared * opening;
        // sin(α + θ)/ρ, cos(α + θ) and sin(θ)/ρ
        let sine = ((1.0 + cos_theta) / (2.0 - opening)).sqrt();
        let cosine = (1.0 - rho_squared) * (2.0 - opening * (1.0 + rho_squared));
        let cosine = (cosine / (2.0 - opening)).sqrt();
        let sin_theta = (opening * (1.0 + cos_theta)).sqrt();
        let cos_alpha = cosine * cos_theta + rho_squared * sine * sin_theta;
        let sin_alpha = sine * cos_theta - cosine * sin_theta;
        let frame = Frame::around(Normal::new(axis)?);
        let normal = frame.to_world(Vector::new(sin_alpha * x, sin_alpha * y, -cos_alpha));
        let at = self.0.surface_along(Normal::new(normal)?);
        Some((at, 1.0 / (2.0 * PI * opening)))
    }

    fn pdf(&self, from: Point, at: &Surface) -> f64 {
        match self.cone(from) {
            Some(_) if self.0.hides(from, at) => 0.0,
            Some((_, opening)) => 1.0 / (2.0 * PI * opening),
            None => self.0.pdf_by_area(from, at),
        }
    }
}
