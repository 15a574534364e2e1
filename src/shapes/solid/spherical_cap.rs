//! The spherical cap: a hollow of the concave lens, given by its rim and its depth.
//!
//! The less deep a cap is, the farther off is its sphere's centre, and with it go the digits of
//! everything that is measured from there. Here, all is measured from the cap's middle, and the
//! sphere is known by its curvature, which goes to 0 as it becomes flat.

use crate::math::{Aabb, Point, Ray, Span, UNIT_ROUNDOFF, Vector, quadratic};
use crate::shapes::{Candidate, Shape, Surface, all_of, first_of, normal_along};

/// The part of a sphere about a point of the y axis that is nearer to a level plane than its rim,
/// which is a circle of radius `radius`; the normal points to the centre.
#[derive(Debug)]
pub(in crate::shapes) struct SphericalCap {
    /// The distances of the middle and of the rim from the plane y = 0, ascending.
    heights: [f64; 2],
    radius: f64,
    /// Whether both are below that plane.
    mirrored: bool,
    /// One over the radius of the sphere.
    curvature: f64,
    /// `(sin ω, cos ω)` for the angle ω under which radius and depth are seen from the centre.
    rim: [f64; 2],
}

impl SphericalCap {
    /// With the rim `depth` farther from y = 0 than the middle: at most `radius`.
    pub(in crate::shapes) fn new(
        heights: [f64; 2],
        depth: f64,
        radius: f64,
        mirrored: bool,
    ) -> Self {
        // a sphere of radius ρ with `ρ² = radius² + (ρ − depth)²`
        let squares = depth * depth + radius * radius;
        let curvature = 2.0 * depth / squares;
        let rim = [curvature * radius, (radius - depth) * (radius + depth) / squares];
        Self { heights, radius, mirrored, curvature, rim }
    }

    /// As if the middle were at the origin and the centre above it.
    #[inline(always)] // as the roots
    fn upright(&self, p: Point) -> Vector {
        self.unmirrored(p.to_vector()) - self.heights[0] * Vector::Y
    }

    fn unmirrored(&self, v: Vector) -> Vector {
        if self.mirrored { Vector::new(v.x(), -v.y(), v.z()) } else { v }
    }

    /// The sphere is `κ p² = 2 p_y`, so it is met at `κ d² t² + 2 (κ o·d − d_y) t + κ o² − 2 o_y = 0`.
    /// The discriminant is taken without the parts of `κ² (o·d)² − κ² d² o²` and of `d²` that cancel.
    #[inline(always)] // as the roots it calls
    fn distances(&self, ray: &Ray) -> Option<[f64; 2]> {
        let (o, d) = (self.upright(ray.origin), self.unmirrored(ray.direction));
        let k = self.curvature;
        let (level_o, level_d) = (o.across_y(), d.across_y());
        let rise = o.y() * level_d.length_squared() - d.y() * level_o.dot(level_d);
        let across = k * o.cross(d);
        let discriminant = d.y() * d.y() + (2.0 * k * rise - across.length_squared());
        let c = k * o.length_squared() - 2.0 * o.y();
        quadratic(k * d.length_squared(), k * o.dot(d) - d.y(), c, discriminant)
    }

    /// The sine of the angle beyond the rim, from differences to the rim itself: neither the height,
    /// which says little of a flat cap, nor the distance from the axis, which says little of a
    /// hemisphere.
    fn has(&self, ray: &Ray) -> impl Fn(f64) -> bool {
        |t| {
            let p = self.unmirrored(ray.at(t).to_vector());
            let [sin, cos] = self.rim;
            let beyond = [p.across_y().length() - self.radius, p.y() - self.heights[1]];
            beyond[0] * cos + beyond[1] * sin <= 0.0
        }
    }
}

impl Shape for SphericalCap {
    fn hit(&self, ray: &Ray, span: Span) -> Option<Candidate> {
        first_of(self.distances(ray)?, span, self.has(ray))
    }

    fn surface(&self, ray: &Ray, at: &Candidate) -> Surface {
        // F = p_y − κ p²/2 and its gradient, a unit vector on the sphere
        let gradient = |p: Vector| Vector::Y - self.curvature * p;
        let mut p = self.upright(ray.at(at.t));
        for _ in 0..2 {
            // Newton's steps: the origin may be far away
            let (value, slope) = (p.y() - 0.5 * self.curvature * p.length_squared(), gradient(p));
            p = p - (value / slope.length_squared()) * slope;
        }
        let normal = normal_along(self.unmirrored(gradient(p)), ray);
        let point = Point::ORIGIN + self.unmirrored(p + self.heights[0] * Vector::Y);
        // a next ray's hits are measured from the middle
        let magnitude = point.to_vector().abs().dot(Vector::from(normal).abs());
        let error = UNIT_ROUNDOFF * (16.0 * p.length() + 4.0 * magnitude);
        Surface::new(point, error, normal)
    }

    fn roots(&self, ray: &Ray, span: Span) -> Vec<Candidate> {
        all_of(self.distances(ray), span, self.has(ray))
    }

    fn bounds(&self) -> Aabb {
        let (r, [middle, rim]) = (self.radius, self.heights);
        let [low, high] = if self.mirrored { [-rim, -middle] } else { [middle, rim] };
        Aabb { min: Point::new(-r, low, -r), max: Point::new(r, high, r) }
    }
}
