//! The open end of a wall about the y axis: the base of a cone, the rim of a paraboloid.

use crate::math::{Ray, Vector};
use crate::shapes::border::{along, nears_level};
use crate::shapes::trimmed::Trim;

/// The points of a wall above or below the circle of a radius `r` at a height.
#[derive(Clone, Debug)]
pub struct Rim {
    pub y: f64,
    pub radius: f64,
    /// Whether the height of the wall is less than `r`: then y is rounded more than ρ.
    pub is_flat: bool,
    /// `dy/dρ` at the axis and at the rim, linear in between. Where it is not 0 at the axis, the
    /// wall has an apex there, which is an edge.
    pub slopes: [f64; 2],
    /// The least and the greatest height in the book's test.
    pub book_heights: [f64; 2],
}

impl Rim {
    /// `dy/dρ` at this distance from the axis.
    #[inline]
    fn slope(&self, rho: f64) -> f64 {
        let [first, last] = self.slopes;
        first + (last - first) * (rho / self.radius)
    }
}

impl Trim for Rim {
    /// By the height or, on a flat wall, by the distance from the axis.
    #[inline]
    fn has(&self, v: Vector) -> bool {
        match self.is_flat {
            true => v.x() * v.x() + v.z() * v.z() <= self.radius * self.radius,
            false => (v.y() - self.y) * self.slopes[1] <= 0.0,
        }
    }

    fn book_has(&self, v: Vector) -> bool {
        let [least, greatest] = self.book_heights;
        (least..=greatest).contains(&v.y())
    }

    /// Along the wall from the rim and from the apex.
    #[inline]
    fn distances(&self, v: Vector) -> [f64; 2] {
        let rho = v.across_y().length();
        let slope = self.slope(rho);
        let stretch = (1.0 + slope * slope).sqrt(); // of a step of ρ, along the wall
        let from_rim = match self.is_flat {
            true => self.radius - rho,
            false => (self.y - v.y()) / slope,
        };
        let has_apex = self.slopes[0] != 0.0;
        [stretch * from_rim, if has_apex { stretch * rho } else { f64::INFINITY }]
    }

    fn away(&self, v: Vector) -> [Vector; 2] {
        // from the axis to the point; a point on the axis belongs to each line of the wall
        let radial = v.across_y().unit().unwrap_or(Vector::X);
        let outward = along(radial + self.slope(v.across_y().length()) * Vector::Y);
        [-outward, outward]
    }

    #[inline]
    fn nears(&self, _: Vector, _size: f64, ray: &Ray, t: f64) -> bool {
        nears_level(ray, t, self.y)
    }

    fn wall(&self) -> Option<Vector> {
        Some(Vector::Y)
    }
}
