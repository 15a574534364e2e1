//! The spherical cap, a hollow of the concave lens: about its lowest point the points with
//! `κ p·p = 2 p_y` inside of its rim.
//!
//! Here `κ = 1/ρ = 2δ/(δ² + R²)` is the curvature of a cap of depth δ and rim radius R. A ray meets
//! the sphere where `a t² + 2 b t + c = 0` with `a = κ d·d`, `b = κ o·d − d_y` and
//! `c = κ o·o − 2 o_y`. A shallow cap has a far centre; unlike the sphere's own equation this one
//! does not contain it, and is right for κ = 0, a plane. The discriminant `b² − a c` is taken as
//! `d_y² + 2κ (o_y |d_⊥|² − d_y o_⊥·d_⊥) − |κ o × d|²`, where `_⊥` is the part across the y axis:
//! the other terms cancel.

use crate::math::{Aabb, Point, Ray, Span, UNIT_ROUNDOFF, Vector, quadratic};
use crate::shapes::border::{Border, along};
use crate::shapes::trimmed::Roots;
use crate::shapes::{Candidate, Shape, Surface, normal_along};

/// The part of a sphere about a point of the y axis that is nearer to a level plane than its rim,
/// which is a circle of radius `radius`; the normal points to the centre.
#[derive(Debug)]
pub(in crate::shapes) struct SphericalCap {
    /// The distances of the lowest point and of the rim from the plane y = 0, ascending.
    heights: [f64; 2],
    radius: f64,
    /// Whether the cap is below that plane.
    mirrored: bool,
    /// κ.
    curvature: f64,
    /// `(sin ω, cos ω)` for the angle ω at the centre between the axis and the rim.
    rim: [f64; 2],
}

impl SphericalCap {
    /// The rim is `depth` farther from y = 0 than the lowest point; `depth` is at most `radius`.
    pub(in crate::shapes) fn new(
        heights: [f64; 2],
        depth: f64,
        radius: f64,
        mirrored: bool,
    ) -> Self {
        let squares = depth * depth + radius * radius;
        let curvature = 2.0 * depth / squares;
        let rim = [curvature * radius, (radius - depth) * (radius + depth) / squares];
        Self { heights, radius, mirrored, curvature, rim }
    }

    /// The point in coordinates with the lowest point at the origin and the centre above it.
    #[inline(always)] // as the roots
    fn upright(&self, p: Point) -> Vector {
        self.unmirrored(p.to_vector()) - self.heights[0] * Vector::Y
    }

    fn unmirrored(&self, v: Vector) -> Vector {
        if self.mirrored { Vector::new(v.x(), -v.y(), v.z()) } else { v }
    }

    /// Where the line meets the sphere, ascending.
    #[inline(always)] // as the roots it calls
    fn distances(&self, ray: &Ray) -> Option<[f64; 2]> {
        let (o, d) = (self.upright(ray.origin), self.unmirrored(ray.direction));
        let k = self.curvature;
        let (level_o, level_d) = (o.across_y(), d.across_y());
        let rise = o.y() * level_d.length_squared() - d.y() * level_o.dot(level_d);
        let across = k * o.cross(d);
        let discriminant = d.y() * d.y() + (2.0 * k * rise - across.length_squared());
        let a = k * d.length_squared();
        let b = k * o.dot(d) - d.y();
        let c = k * o.length_squared() - 2.0 * o.y();
        quadratic(a, b, c, discriminant)
    }

    /// Whether a point of the sphere is inside of the rim: it is beyond by the sine of an angle at
    /// the centre. The height alone would be rounded for a flat cap, and the distance from the axis
    /// for a hemisphere.
    fn has(&self, ray: &Ray) -> impl Fn(f64) -> bool {
        |t| {
            let p = self.unmirrored(ray.at(t).to_vector());
            let [sin, cos] = self.rim;
            let beyond = [p.across_y().length() - self.radius, p.y() - self.heights[1]];
            beyond[0] * cos + beyond[1] * sin <= 0.0
        }
    }

    /// The rim, from which the surface leads inward and down.
    fn border(&self, point: Point) -> Option<Box<Border>> {
        let p = self.unmirrored(point.to_vector());
        let [sin, cos] = self.rim;
        let beyond = [p.across_y().length() - self.radius, p.y() - self.heights[1]];
        let distance = -(beyond[0] * cos + beyond[1] * sin);
        Border::of([distance], self.radius + self.heights[1], || {
            [-self.unmirrored(cos * along(p.across_y()) + sin * Vector::Y)]
        })
    }
}

impl Shape for SphericalCap {
    fn hit(&self, ray: &Ray, span: Span) -> Option<Candidate> {
        self.distances(ray).first(span, self.has(ray))
    }

    fn surface(&self, ray: &Ray, at: &Candidate) -> Surface {
        // F = p_y − κ p²/2 and its gradient, a unit vector on the sphere
        let gradient = |p: Vector| Vector::Y - self.curvature * p;
        let mut p = self.upright(ray.at(at.t));
        for _ in 0..2 {
            // Newton's method; two steps, as the ray's origin may be far away
            let (value, slope) = (p.y() - 0.5 * self.curvature * p.length_squared(), gradient(p));
            p = p - (value / slope.length_squared()) * slope;
        }
        let normal = normal_along(self.unmirrored(gradient(p)), ray);
        let point = Point::ORIGIN + self.unmirrored(p + self.heights[0] * Vector::Y);
        // roundings of p, and of the next ray's origin
        let magnitude = point.to_vector().abs().dot(Vector::from(normal).abs());
        let error = UNIT_ROUNDOFF * (16.0 * p.length() + 4.0 * magnitude);
        Surface::new(point, error, normal).within(self.border(point))
    }

    fn roots(&self, ray: &Ray, span: Span) -> Vec<Candidate> {
        self.distances(ray).all(span, self.has(ray))
    }

    fn bounds(&self) -> Aabb {
        let (r, [middle, rim]) = (self.radius, self.heights);
        let [low, high] = if self.mirrored { [-rim, -middle] } else { [middle, rim] };
        Aabb { min: Point::new(-r, low, -r), max: Point::new(r, high, r) }
    }
}
