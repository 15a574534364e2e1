//! The open cone (Suffern, ch. 19): a slanted wall without a base.

use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::invalid::{Invalid, length};
use crate::kinds::Specification;
use crate::math::{Aabb, Point, Ray, Span, UNIT_ROUNDOFF, Vector};
use crate::shapes::{Candidate, Context, Shape, Surface, all_of, first_of, normal_along};

/// The points with `(h/r)² (x² + z²) = (h − y)²` and `0 ≤ y ≤ h`: the apex is at `(0, h, 0)`, the
/// circle of radius `r` in the plane `y = 0`. The normal points outward, or to the axis.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Cone {
    /// The height; positive.
    pub height: f64,
    /// The radius of the open base; positive.
    pub radius: f64,
    /// Whether the normal points to the axis.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub inward: bool,
}

/// A ray is along the wall if `|Q(d)|` is less than this part of the direction's square.
const ALONG_WALL: f64 = 1.0 / 16.0;

#[derive(Debug)]
struct Built {
    data: Cone,
    /// `r/h`.
    slope: f64,
}

impl Specification for Cone {
    type Built = Arc<dyn Shape>;
    type Context = Context;

    fn build(&self, _: &mut Context) -> Result<Arc<dyn Shape>, Invalid> {
        length("height", self.height)?;
        length("radius", self.radius)?;
        let slope = self.radius / self.height;
        Ok(Arc::new(Built { data: self.clone(), slope }))
    }

    fn scaled(&self, factor: f64) -> Self {
        Self { height: factor * self.height, radius: factor * self.radius, ..*self }
    }

    fn specimens() -> Vec<Self> {
        vec![
            Self { height: 2.0, radius: 1.0, inward: false },
            Self { height: 0.3, radius: 0.7, inward: true },
        ]
    }
}

impl Built {
    /// Where the line meets the half of the double cone below the apex, ascending; NaN for none.
    ///
    /// With y stretched by `r/h` the double cone is `Q(v) = x² + z² − y² = 0` about its apex. The
    /// quadratic is formed at a point `l` of the ray, and its discriminant `(d·l)² − Q(d) Q(l)` is
    /// `Q(l × d)`, which does not cancel. That point is the origin, but for a ray nearly along the
    /// wall the one nearest to the apex: elsewhere along it all three coefficients are small beside
    /// their terms. (An origin far away on the double cone, where Q alone is, is no such case: from
    /// there only rays along the wall meet it near the apex.)
    #[inline(always)] // a call would hand the roots over in memory, which stalls
    fn distances(&self, ray: &Ray) -> Option<[f64; 2]> {
        let stretched = |v: Vector| Vector::new(v.x(), self.slope * v.y(), v.z());
        let apex = Point::new(0.0, self.data.height, 0.0);
        let (w, d) = (stretched(ray.origin - apex), stretched(ray.direction));
        // Q is the first less the second, and the square of the length is their sum
        let squares = |v: Vector| (v.x() * v.x() + v.z() * v.z(), v.y() * v.y());
        let ((w_across, w_along), (d_across, d_along)) = (squares(w), squares(d));
        let a = d_across - d_along;
        let (shift, l, c) = if a.abs() >= ALONG_WALL * (d_across + d_along) {
            (0.0, w, w_across - w_along)
        } else {
            let shift = -w.dot(d) / (d_across + d_along);
            let l = w + shift * d;
            let (across, along) = squares(l);
            // not Q(w), though it differs along d only: all three coefficients must be of one line,
            // or a ray that leaves along the wall meets it again
            (shift, l, across - along)
        };
        let (across, along) = squares(l.cross(d));
        let discriminant = across - along;
        if discriminant.is_nan() || discriminant < 0.0 {
            return None;
        }
        let b = (l.x() * d.x() + l.z() * d.z()) - l.y() * d.y();
        // as in `math::quadratic`: its roots are q/a and c/q, but here not both are needed
        let q = -(b + discriminant.sqrt().copysign(b + 0.0)); // the same for both zeros
        if q == 0.0 {
            // through the apex: once, also where the whole line lies in the wall
            return (c == 0.0).then_some([shift, f64::NAN]);
        }
        if a < 0.0 {
            // steep: one root on each half, the later one below if the ray goes down
            let is_first = (d.y() < 0.0) == (q < 0.0);
            return Some([shift + if is_first { q / a } else { c / q }, f64::NAN]);
        }
        if l.y() * a > b * d.y() {
            return None; // in their middle, at −b/a, the ray is above the apex
        }
        let (first, second) = (shift + q / a, shift + c / q);
        if first == second {
            return Some([first, f64::NAN]); // a tangent touches once
        }
        Some(if first < second { [first, second] } else { [second, first] })
    }

    /// By the height, which says little of a flat cone, or by the radius, which says little of a
    /// steep one.
    fn is_above_base(&self, ray: &Ray, t: f64) -> bool {
        let (o, d) = (ray.origin, ray.direction);
        if self.data.height >= self.data.radius {
            return o.y() + t * d.y() >= 0.0;
        }
        let (x, z) = (o.x() + t * d.x(), o.z() + t * d.z());
        x * x + z * z <= self.data.radius * self.data.radius
    }
}

impl Shape for Built {
    fn hit(&self, ray: &Ray, span: Span) -> Option<Candidate> {
        first_of(self.distances(ray)?, span, |t| self.is_above_base(ray, t))
    }

    fn surface(&self, ray: &Ray, at: &Candidate) -> Surface {
        let Cone { height: h, radius: r, inward } = self.data;
        let raw = ray.at(at.t);
        let rho = raw.to_vector().across_y().length();
        // on the cone h − y = (h/r) ρ, and ((h/r)² x, h − y, (h/r)² z) is along this
        let normal = normal_along(Vector::new(h * raw.x(), r * rho, h * raw.z()), ray);
        // in the plane of axis and point the wall is a line through the apex
        let slant = Vector::new(h, r, 0.0).length();
        let off = (rho * h + (raw.y() - h) * r) / slant;
        let point = raw - off * normal;
        // rounding of the stretched coordinates, which are of the size of ρ, and of y itself
        let error = UNIT_ROUNDOFF * ((24.0 * rho * h + 8.0 * point.y().abs() * r) / slant);
        Surface::new(point, error, normal).turned(inward)
    }

    fn roots(&self, ray: &Ray, span: Span) -> Vec<Candidate> {
        all_of(self.distances(ray), span, |t| self.is_above_base(ray, t))
    }

    fn bounds(&self) -> Aabb {
        let r = self.data.radius;
        Aabb { min: Point::new(-r, 0.0, -r), max: Point::new(r, self.data.height, r) }
    }
}
