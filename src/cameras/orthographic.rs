//! The orthographic camera (Suffern, ch. 3): parallel rays.

use super::{Camera, Made, Specification, ViewPlane, made};
use crate::math::{Point, Positive, Vector};

/// Rays along −w from a plane through the eye.
#[kind(PartialEq)]
pub struct Orthographic {
    /// The magnification; positive.
    #[default(1.0)]
    pub zoom: Positive,
}

impl Specification for Orthographic {
    fn make(&self, _: &mut ViewPlane) -> Made {
        made(self.clone())
    }
}

impl Camera for Orthographic {
    fn ray(&self, [x, y]: [f64; 2], _: [f64; 2]) -> Option<(Point, Vector)> {
        Some((Point::new(x / self.zoom, y / self.zoom, 0.0), -Vector::Z))
    }

    /// Points in front of the plane through the eye.
    fn project(&self, point: Point) -> Option<[f64; 2]> {
        (point.z() < 0.0).then(|| [self.zoom * point.x(), self.zoom * point.y()])
    }

    fn window_shift(&self, eye_shift: f64) -> f64 {
        self.zoom * eye_shift
    }
}
