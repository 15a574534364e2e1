//! The open cone (Suffern, ch. 19), a slanted wall without a base: the points with
//! `(h/r)² (x² + z²) = (h − y)²` and `0 ≤ y ≤ h`.
//!
//! About the apex `(0, h, 0)` and with y stretched by `r/h` this is `Q(v) = x² + z² − y² = 0`. With
//! `w` and `d` the ray's origin and direction in these coordinates, a ray meets the double cone
//! where `a t² + 2 b t + c = 0` with `a = Q(d)`, `b = w_x d_x + w_z d_z − w_y d_y` and `c = Q(w)`:
//! the book's quadratic, divided by `(h/r)²`, its `B` halved. Three things differ from the book:
//!
//! - The discriminant `b² − a c` is taken as `Q(w × d)`, which does not cancel.
//! - A ray nearly along the wall has small `a`, `b` and `c` beside their terms. There `w` is
//!   replaced by the point of the ray nearest to the apex, and `t` is counted from it.
//! - A hit on the other half of the double cone, above the apex, is recognised by the signs of the
//!   coefficients, not by its rounded height.

use crate::math::{Aabb, Length, Point, Ray, Span, UNIT_ROUNDOFF, Vector};
use crate::shapes::plain::rim::Rim;
use crate::shapes::textbook::schoolbook_roots;
use crate::shapes::trimmed::{All, Carrier, Roots, Trimmed};
use crate::shapes::{Context, Made, Specification, Surface, made, normal_along};

/// The points with `(h/r)² (x² + z²) = (h − y)²` and `0 ≤ y ≤ h`: the apex is at `(0, h, 0)`, the
/// circle of radius `r` in the plane `y = 0`. The normal points outward, or to the axis.
#[kind(PartialEq)]
pub struct Cone {
    /// The height; positive.
    pub height: Length,
    /// The radius of the open base; positive.
    pub radius: Length,
    /// Whether the normal points to the axis.
    #[optional]
    pub inward: bool,
}

/// A ray is nearly along the wall if `|Q(d)|` is less than this part of `|d|²`.
const ALONG_WALL: f64 = 1.0 / 16.0;

/// The wall from the apex down, without an end.
#[derive(Clone, Debug)]
struct Wall {
    data: Cone,
    /// `r/h`.
    slope: f64,
}

impl Specification for Cone {
    fn make(&self, _: &mut Context) -> Made {
        let Self { height: h, radius: r, .. } = *self;
        let wall = Wall { data: self.clone(), slope: r / h };
        let rim =
            Rim { y: 0.0, radius: r, is_flat: h < r, slopes: [-h / r; 2], book_heights: [0.0, h] };
        let bounds = Aabb { min: Point::new(-r, 0.0, -r), max: Point::new(r, h, r) };
        made(Trimmed::new(wall, (rim, All), h.max(r), bounds))
    }
}

impl Carrier for Wall {
    const WHOLE: &'static str = "cone without end";

    /// On the half of the double cone below the apex. `l` is `w`, or the point nearest to the apex
    /// that replaces it.
    #[inline(always)] // a call would hand the roots over in memory, which stalls
    fn roots(&self, ray: &Ray, _: Span, _: &Aabb) -> impl Roots {
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
            // not Q(w) of the unrounded line: all three coefficients must be of the same rounded line,
            // or a ray that leaves along the wall meets it again
            (shift, l, across - along)
        };
        let (across, along) = squares(l.cross(d));
        // a steep line meets the double cone always: its discriminant is negative by rounding only
        let discriminant = across - along;
        let discriminant = if a < 0.0 { discriminant.max(0.0) } else { discriminant };
        if discriminant.is_nan() || discriminant < 0.0 {
            return None;
        }
        let b = (l.x() * d.x() + l.z() * d.z()) - l.y() * d.y();
        // as in `math::quadratic` the roots are q/a and c/q, but here one may suffice
        let q = -(b + discriminant.sqrt().copysign(b + 0.0)); // the same for both zeros
        if q == 0.0 {
            // through the apex: once, also where the whole line lies in the wall
            return (c == 0.0).then_some([shift, f64::NAN]);
        }
        if a < 0.0 {
            // a steep ray has a root on each half; going down, the later one is below the apex
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

    /// `(h/r)² (x² + z²) = (h − y)²`.
    fn book_roots(&self, ray: &Ray, _: Span) -> impl IntoIterator<Item = f64> {
        let ([ox, oy, oz], [dx, dy, dz]) = (ray.origin.to_array(), ray.direction.to_array());
        let (h, k) = (self.data.height, self.data.height / self.data.radius);
        let k2 = k * k;
        let a = k2 * (dx * dx + dz * dz) - dy * dy;
        let b = 2.0 * (k2 * (ox * dx + oz * dz) + dy * (h - oy));
        let c = k2 * (ox * ox + oz * oz) - (h - oy) * (h - oy);
        let mut roots = schoolbook_roots(a, b, c);
        // a < 0 turns their order around
        roots.iter_mut().for_each(|roots| roots.sort_by(f64::total_cmp));
        roots.into_iter().flatten()
    }

    fn surface(&self, ray: &Ray, t: f64) -> Surface {
        let Cone { height: h, radius: r, inward } = self.data;
        let raw = ray.at(t);
        let rho = raw.to_vector().across_y().length();
        // the gradient ((h/r)² x, h − y, (h/r)² z), with h − y = (h/r) ρ, divided by hρ/r²; the apex belongs to
        // each line of the wall, one of which is taken
        let radial = raw.to_vector().across_y().unit().unwrap_or(Vector::X);
        let normal = normal_along(h * radial + r * Vector::Y, ray);
        // the distance from the wall, which in the plane of axis and point is a line through the apex
        let slant = Vector::new(h, r, 0.0).length();
        let off = (rho * h + (raw.y() - h) * r) / slant;
        let point = raw - off * normal;
        // rounding of the stretched coordinates, which are of the size of ρ, and of y itself
        let error = UNIT_ROUNDOFF * ((24.0 * rho * h + 8.0 * point.y().abs() * r) / slant);
        Surface::new(point, error, normal).turned(inward)
    }
}
