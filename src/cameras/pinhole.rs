//! The pinhole camera (Suffern, ch. 8 and 9): perspective.

use super::{Camera, Made, Specification, ViewPlane, made};
use crate::math::{Distance, Point, Positive, Vector};

/// Rays from the eye through a view plane at `distance`.
#[kind(PartialEq)]
pub struct Pinhole {
    /// The distance from the eye to the view plane, the book's `d`, in the unit of `pixel_size`;
    /// positive. A larger distance gives a narrower field of view: 38 degrees for 480 pixels of
    /// side 1 at distance 700.
    pub distance: Distance,
    /// The magnification; positive.
    #[default(1.0)]
    pub zoom: Positive,
}

impl Specification for Pinhole {
    fn make(&self, _: &mut ViewPlane) -> Made {
        made(self.clone())
    }
}

impl Camera for Pinhole {
    fn ray(&self, [x, y]: [f64; 2], _: [f64; 2]) -> Option<(Point, Vector)> {
        Some((Point::ORIGIN, Vector::new(x / self.zoom, y / self.zoom, -self.distance)))
    }

    /// By similar triangles: `x' = d x / depth`.
    fn project(&self, point: Point) -> Option<[f64; 2]> {
        let scale = self.zoom * self.distance / -point.z();
        (point.z() < 0.0).then(|| [scale * point.x(), scale * point.y()])
    }

    fn window_shift(&self, eye_shift: f64) -> f64 {
        self.zoom * eye_shift
    }
}
