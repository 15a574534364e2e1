//! The open cylinder (Suffern, ch. 19), a wall without ends: the points with `x² + z² = r²` and
//! `y0 ≤ y ≤ y1`.
//!
//! A ray meets it where `a t² + 2 b t + c = 0` with `a = d_x² + d_z²`, `b = o_x d_x + o_z d_z` and
//! `c = o_x² + o_z² − r²` (the book's `b` is twice as large). Both roots are tested in turn: if the
//! near one is beyond an end, the far one may not be. The discriminant `b² − a c` is taken as
//! `a r² − (o_x d_z − o_z d_x)²`, which keeps its digits for far origins and thin cylinders
//! ([`circle_roots`]).

use crate::invalid::Invalid;
use crate::math::{
    Aabb, Coordinate, Length, Point, Ray, Span, UNIT_ROUNDOFF, Vector, circle_roots,
};
use crate::shapes::textbook::schoolbook_roots;
use crate::shapes::trimmed::{All, Carrier, Roots, Trim, Trimmed};
use crate::shapes::{Context, Made, Specification, Surface, made, normal_along};

/// The points with `x² + z² = radius²` and `y0 ≤ y ≤ y1`; the normal points outward, or to the
/// axis.
#[kind(PartialEq)]
pub struct OpenCylinder {
    /// The lower end.
    pub y0: Coordinate,
    /// The upper end, above `y0`.
    pub y1: Coordinate,
    /// The radius; positive.
    pub radius: Length,
    /// Whether the normal points to the axis: the book's concave open cylinder.
    #[optional]
    pub inward: bool,
}

impl Specification for OpenCylinder {
    fn make(&self, _: &mut Context) -> Made {
        let Self { y0, y1, radius: r, .. } = self.checked()?;
        let bounds = Aabb { min: Point::new(-r, y0, -r), max: Point::new(r, y1, r) };
        made(Trimmed::new(self.cylinder(), (Heights { y0, y1 }, All), self.size(), bounds))
    }
}

impl OpenCylinder {
    /// A copy whose numbers are fit for use.
    pub(in crate::shapes) fn checked(&self) -> Result<Self, Invalid> {
        let Self { y0, y1, .. } = *self;
        if y0 >= y1 {
            return Err(Invalid::field("y1", format!("found {y1}, but it must be above y0, {y0}")));
        }
        Ok(self.clone())
    }

    /// The largest number in its tests.
    pub(in crate::shapes) fn size(&self) -> f64 {
        self.radius.max(self.y0.abs()).max(self.y1.abs())
    }

    /// The cylinder without ends.
    pub(in crate::shapes) fn cylinder(&self) -> Cylinder {
        Cylinder { radius: self.radius, inward: self.inward }
    }
}

/// All points with `x² + z² = radius²`.
#[derive(Clone, Debug)]
pub struct Cylinder {
    radius: f64,
    inward: bool,
}

impl Carrier for Cylinder {
    const WHOLE: &'static str = "cylinder without ends";

    #[inline(always)] // as the roots it calls
    fn roots(&self, ray: &Ray, _: Span, _: &Aabb) -> impl Roots {
        let ([ox, _, oz], [dx, _, dz]) = (ray.origin.to_array(), ray.direction.to_array());
        circle_roots([ox, oz], [dx, dz], self.radius)
    }

    fn book_roots(&self, ray: &Ray, _: Span) -> impl IntoIterator<Item = f64> {
        let ([ox, _, oz], [dx, _, dz]) = (ray.origin.to_array(), ray.direction.to_array());
        let a = dx * dx + dz * dz;
        let b = 2.0 * (ox * dx + oz * dz);
        let c = ox * ox + oz * oz - self.radius * self.radius;
        schoolbook_roots(a, b, c).into_iter().flatten()
    }

    fn surface(&self, ray: &Ray, t: f64) -> Surface {
        let raw = ray.at(t);
        let flat_ray = Ray::new(ray.origin, ray.direction.across_y());
        let normal = normal_along(raw.to_vector().across_y(), &flat_ray);
        let r = self.radius * normal;
        let point = Point::new(r.x(), raw.y(), r.z());
        Surface::new(point, 12.0 * UNIT_ROUNDOFF * self.radius, normal).turned(self.inward)
    }
}

/// The points with `y0 ≤ y ≤ y1`; of the book's with `y0 < y < y1`.
#[derive(Clone, Debug)]
pub struct Heights {
    pub y0: f64,
    pub y1: f64,
}

impl Trim for Heights {
    fn book_has(&self, v: Vector) -> bool {
        self.y0 < v.y() && v.y() < self.y1
    }

    #[inline]
    fn distances(&self, v: Vector) -> [f64; 2] {
        [v.y() - self.y0, self.y1 - v.y()]
    }

    fn away(&self, _: Vector) -> [Vector; 2] {
        [Vector::Y, -Vector::Y]
    }
}
