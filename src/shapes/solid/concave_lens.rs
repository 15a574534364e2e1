//! The concave lens (Suffern, ch. 19): a disk with a spherical hollow of depth
//! `δ = (thickness − min_distance)/2` in each side.
//!
//! The radius `ρ` of the hollows' spheres follows from `ρ² = R² + (ρ − δ)²`, where R is that of the
//! rim: the book's `ρ = (δ² + R²)/2δ`. Its surface is a compound of two part spheres and an open
//! cylinder. The book takes [`PartSphere`](crate::shapes::PartSphere)s; for shallow hollows their
//! centres are so far away that digits are lost, so here they are [`SphericalCap`]s.

use std::sync::Arc;

use super::spherical_cap::SphericalCap;
use crate::invalid::{Invalid, shown};
use crate::kinds::Custom;
use crate::math::{Length, Point, UNIT_ROUNDOFF, atan2, to_degrees};
use crate::shapes::composite::assembly::{Materials, solid};
use crate::shapes::part::angles::full_turn;
use crate::shapes::{Context, Kind, Made, OpenCylinder, PartSphere, Specification};

/// A disk about the y axis with a spherical hollow in each side, as the parts `top`, `bottom` and
/// `wall`; normals point out of the glass.
#[kind(PartialEq)]
pub struct ConcaveLens {
    /// The radius of the rim; positive.
    pub radius: Length,
    /// The thickness at the rim; the lens reaches half of it above and below the plane y = 0. At
    /// most `min_distance + 2 radius`: no hollow is deeper than half a sphere.
    pub thickness: Length,
    /// From hollow to hollow, on the axis: positive and less than `thickness`.
    pub min_distance: Length,
    /// The names of materials of parts that have one of their own, as `{ wall = "red" }`.
    #[optional]
    pub materials: Materials,
}

impl ConcaveLens {
    fn checked(&self) -> Result<(), Invalid> {
        if self.min_distance >= self.thickness {
            let [found, most] = [self.min_distance, self.thickness].map(shown);
            let problem = format!("found {found}, but it must be less than the thickness, {most}");
            return Err(Invalid::field("min_distance", problem));
        }
        // as deep as the radius is a hemisphere, also where the thickness of one was rounded
        let rounding = (4.0 * UNIT_ROUNDOFF * self.thickness).min(1e-6 * self.radius);
        if 0.5 * (self.thickness - self.min_distance) > self.radius + rounding {
            let [found, most] = [self.thickness, self.min_distance + 2.0 * self.radius].map(shown);
            let problem = format!(
                "found {found}, but it must be at most {most}: hollows deeper than the radius would \
                 be wider inside than at the rim"
            );
            return Err(Invalid::field("thickness", problem));
        }
        Ok(())
    }

    /// Of each hollow.
    fn depth(&self) -> f64 {
        (0.5 * (self.thickness - self.min_distance)).min(self.radius)
    }

    /// A hollow as the book has it, a part of a sphere with the centre far above or below.
    fn zone(&self, mirrored: bool) -> Kind {
        let depth = self.depth();
        // `ρ² = radius² + (ρ − depth)²`
        let radius = (depth * depth + self.radius * self.radius) / (2.0 * depth);
        let omega = to_degrees(atan2(self.radius, radius - depth));
        let y = radius + 0.5 * self.min_distance;
        let (y, theta) = if mirrored { (-y, [0.0, omega]) } else { (y, [180.0 - omega, 180.0]) };
        let center = Point::new(0.0, y, 0.0);
        PartSphere { center, radius, phi: full_turn(), theta, inward: true }.into()
    }
}

impl Specification for ConcaveLens {
    fn make(&self, context: &mut Context) -> Made {
        self.checked()?;
        let half = 0.5 * self.thickness;
        let heights = [0.5 * self.min_distance, half];
        let by_the_book = context.textbook().is_some();
        let hollow = |mirrored| {
            if by_the_book {
                return self.zone(mirrored);
            }
            let cap = SphericalCap::new(heights, self.depth(), self.radius, mirrored);
            Kind::Custom(Custom(Arc::new(cap) as Arc<_>))
        };
        let wall = OpenCylinder { y0: -half, y1: half, radius: self.radius, inward: false };
        let parts = [("top", hollow(false)), ("bottom", hollow(true)), ("wall", wall.into())];
        solid(&parts, &self.materials, None, context)
    }
}
