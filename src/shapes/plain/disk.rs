//! The disk (Suffern, ch. 19): the points `p` of the plane through `c` with the normal `n` for
//! which `|p − c|² ≤ r²`.
//!
//! A ray meets the plane at `t = (c − o)·n / d·n`, and then the point is tested, as in the book,
//! whose own test has `<` for `≤`.

use std::f64::consts::PI;

use crate::math::{Frame, Length, Point, Vector, maps};
use crate::shapes::plain::annulus::Radii;
use crate::shapes::plain::plane::PlaneThrough;
use crate::shapes::sampled::{ByArea, EvenSurface};
use crate::shapes::trimmed::{All, Trimmed};
use crate::shapes::{Context, Made, Sampling, Specification, Surface, made};

/// The points of a plane within `radius` of `center`.
#[kind(PartialEq)]
pub struct Disk {
    /// The centre.
    pub center: Point,
    /// Perpendicular to the disk; not zero, need not be unit.
    pub normal: Vector,
    /// The radius; positive.
    pub radius: Length,
}

type DiskShape = Trimmed<PlaneThrough, Radii>;

impl Specification for Disk {
    fn make(&self, _: &mut Context) -> Made {
        let plane = PlaneThrough::checked(self.center, self.normal)?;
        let radii = Radii::within(self.radius);
        let (size, bounds) = (radii.size(self.center), plane.bounds_within(self.radius));
        let sampler = |disk: &DiskShape, sampling| {
            (sampling == Sampling::Area).then(|| Box::new(ByArea(disk.clone())) as _)
        };
        let disk = Trimmed::new(plane, (radii, All), size, bounds);
        made(Trimmed { sampler, ..disk })
    }
}

impl EvenSurface for DiskShape {
    fn area(&self) -> f64 {
        let radius = self.trims.0.outer;
        PI * radius * radius
    }

    fn point(&self, u: [f64; 2]) -> Surface {
        let [x, y] = maps::disk(u);
        let (PlaneThrough { anchor, normal, .. }, (radii, _)) = (&self.carrier, &self.trims);
        let from_center = Frame::around(*normal).to_world(Vector::new(x, y, 0.0));
        Surface::flat(*anchor + radii.outer * from_center, *anchor, *normal)
    }
}
