//! The thin-lens camera (Suffern, ch. 10): depth of field.

use super::{Camera, Made, Specification, ViewPlane, made};
use crate::math::{Distance, Point, Positive, Vector, Width};

/// A pinhole camera with a lens instead of a point: points at the focal distance are sharp, all
/// others blurred.
#[kind(PartialEq)]
pub struct ThinLens {
    /// The distance from the lens to the view plane, the book's `d`, as for `pinhole`; positive.
    pub distance: Distance,
    /// The distance from the lens to the focal plane, the book's `f`; positive. Measured along −w,
    /// not along the ray.
    pub focal_distance: Distance,
    /// The radius `R` of the lens, not negative. A larger lens gives more blur; 0 gives the pinhole
    /// camera.
    pub lens_radius: Width,
    /// The magnification; positive.
    #[default(1.0)]
    pub zoom: Positive,
}

impl Specification for ThinLens {
    fn make(&self, _: &mut ViewPlane) -> Made {
        made(self.clone())
    }
}

impl Camera for ThinLens {
    /// From the point l of the lens through the point `(f/d) p` of the focal plane, where p is the
    /// point of the view plane: `(p − (d/f) l) − d w`. This is d/f times the book's direction, so
    /// that a lens of radius 0 gives the direction of the pinhole camera, bit for bit.
    fn ray(&self, [x, y]: [f64; 2], lens: [f64; 2]) -> Option<(Point, Vector)> {
        let (px, py) = (x / self.zoom, y / self.zoom);
        let [lx, ly] = lens.map(|l| self.lens_radius * l);
        let to_plane = self.distance / self.focal_distance;
        let direction = Vector::new(px - to_plane * lx, py - to_plane * ly, -self.distance);
        Some((Point::new(lx, ly, 0.0), direction))
    }

    fn has_lens(&self) -> bool {
        self.lens_radius > 0.0
    }

    /// As for the pinhole camera.
    fn project(&self, point: Point) -> Option<[f64; 2]> {
        let scale = self.zoom * self.distance / -point.z();
        (point.z() < 0.0).then(|| [scale * point.x(), scale * point.y()])
    }

    fn window_shift(&self, eye_shift: f64) -> f64 {
        self.zoom * eye_shift
    }
}
