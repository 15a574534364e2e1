//! The open cone (Suffern, ch. 19): a slanted wall without a base.

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::{Candidate, Context, Shape, Surface, all_of, first_of, normal_along};
use crate::invalid::{Invalid, positive};
use crate::kinds::Specification;
use crate::math::{Aabb, Point, Ray, Span, UNIT_ROUNDOFF, Vector, quadratic};

/// The points with `(h/r)² (x² + z²) = (h − y)²` and `0 ≤ y ≤ h`: the apex is at `(0, h, 0)`, the
/// circle of radius `r` in the plane `y = 0`. The normal points outward, or to the axis.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Cone {
    /// Positive.
    pub height: f64,
    /// Of the open base; positive.
    pub radius: f64,
    /// Whether the normal points to the axis.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub inward: bool,
}

impl Specification for Cone {
    type Built = Arc<dyn Shape>;
    type Context = Context;

    fn build(&self, _: &mut Context) -> Result<Arc<dyn Shape>, Invalid> {
        positive("height", self.height)?;
        positive("radius", self.radius)?;
        Ok(Arc::new(self.clone()))
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

impl Cone {
    /// Where the line meets the half of the double cone below the apex, ascending; NaN for none.
    ///
    /// With y stretched by `r/h` the double cone is `Q(v) = x² + z² − y² = 0` about its apex. The
    /// quadratic is formed at the point `l` of the ray nearest to the apex: its discriminant `(d·l)² −
    /// Q(d) Q(l)`, which is `Q(l × d)`, would cancel for rays nearly along the wall.
    fn distances(&self, ray: &Ray) -> Option<[f64; 2]> {
        let slope = self.radius / self.height;
        let stretched = |v: Vector| Vector::new(v.x(), slope * v.y(), v.z());
        let apex = Point::new(0.0, self.height, 0.0);
        let (w, d) = (stretched(ray.origin - apex), stretched(ray.direction));
        let shift = -w.dot(d) / d.length_squared();
        let l = w + shift * d;

        let q = |v: Vector| (v.x() * v.x() + v.z() * v.z()) - v.y() * v.y();
        let (a, c) = (q(d), q(l));
        let b = (l.x() * d.x() + l.z() * d.z()) - l.y() * d.y();
        let [near, far] = quadratic(a, b, c, q(l.cross(d)))?;
        if a < 0.0 {
            // steep: one root on each half, the later one below if the ray goes down
            let root = if d.y() < 0.0 { far } else { near };
            return Some([shift + root, f64::NAN]);
        }
        let below = l.y() + (0.5 * near + 0.5 * far) * d.y() <= 0.0;
        // a double root is one; where the ray lies in the wall, that is the apex
        let second = if near == far { f64::NAN } else { shift + far };
        below.then_some([shift + near, second])
    }

    /// Up the wall from the base, measured along the wall: its height alone says little of a flat
    /// cone, its radius little of a steep one. That is `(r − ρ) r + y h ≥ 0`, without the root in ρ.
    fn is_above_base(&self, p: Point) -> bool {
        let most = self.radius + p.y() * (self.height / self.radius);
        most >= 0.0 && p.x() * p.x() + p.z() * p.z() <= most * most
    }
}

impl Shape for Cone {
    fn hit(&self, ray: &Ray, span: Span) -> Option<Candidate> {
        first_of(self.distances(ray)?, span, |t| self.is_above_base(ray.at(t)))
    }

    fn surface(&self, ray: &Ray, at: &Candidate) -> Surface {
        let Self { height: h, radius: r, inward } = *self;
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
        all_of(self.distances(ray), span, |t| self.is_above_base(ray.at(t)))
    }

    fn bounds(&self) -> Aabb {
        let r = self.radius;
        Aabb { min: Point::new(-r, 0.0, -r), max: Point::new(r, self.height, r) }
    }
}
