//! Cameras (Suffern, ch. 3, 8–12): from a point of the film to a ray, and back.
//!
//! A [`Camera`] uses camera coordinates: the eye at the origin, the view direction −w, u to the
//! right and v up. [`Viewpoint`] transforms it to the world.

mod cylindrical_panorama;
mod fisheye;
mod orthographic;
mod pinhole;
mod spherical_panorama;
mod thin_lens;

// shared by the kinds
mod stereo;
mod viewpoint;

use std::fmt::Debug;

use crate::math::{Point, Vector};

pub use stereo::{Side, Stereo, Viewing};
pub use viewpoint::{Eye, Handedness, View, Viewpoint};

/// The size of the view plane (the film), whose centre is on the view direction, in world units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ViewPlane {
    /// The width; positive.
    pub width: f64,
    /// The height; positive.
    pub height: f64,
}

impl ViewPlane {
    /// The book's normalised film coordinates: from −1 to 1 across the picture.
    fn normalised(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [2.0 * x / self.width, 2.0 * y / self.height]
    }

    /// The film point of normalised coordinates.
    fn point(&self, [xn, yn]: [f64; 2]) -> [f64; 2] {
        [0.5 * xn * self.width, 0.5 * yn * self.height]
    }

    /// Whether a film point is in the picture, including its edges.
    fn contains(&self, [x, y]: [f64; 2]) -> bool {
        x.abs() <= 0.5 * self.width && y.abs() <= 0.5 * self.height
    }
}

/// A map from film points to rays, and back. Contract: `tests/contracts/camera.rs`.
pub trait Camera: Debug + Send + Sync {
    /// Origin and direction, in camera coordinates (u, v, w), of the ray through a film point (from
    /// the centre, x to the right, y up, in world units). `None` where the picture is black.
    ///
    /// `lens` is a point of the unit disk, for cameras that have one ([`Camera::has_lens`]).
    fn ray(&self, film: [f64; 2], lens: [f64; 2]) -> Option<(Point, Vector)>;

    /// Whether rays start at sample points of a lens.
    fn has_lens(&self) -> bool {
        false
    }

    /// The film point of a point in camera coordinates, through the centre of the lens: the inverse
    /// of [`Camera::ray`]. It may be outside the picture. `None` if no ray goes through the point.
    fn project(&self, point: Point) -> Option<[f64; 2]>;

    /// The shift of film points to the right if the eye moves to the left by `eye_shift` and its
    /// view plane stays fixed in space: the asymmetric frustum of a stereo pair (Suffern, ch. 12).
    /// 0 for cameras without a view plane.
    fn window_shift(&self, _eye_shift: f64) -> f64 {
        0.0
    }
}

crate::kinds! {
    /// The projection: the ray of each film point.
    Kind builds dyn Camera with ViewPlane;
    ch03 orthographic::Orthographic,
    ch08 pinhole::Pinhole,
    ch10 thin_lens::ThinLens,
    ch11 fisheye::Fisheye,
    ch11 spherical_panorama::SphericalPanorama,
    ch11 cylindrical_panorama::CylindricalPanorama,
}
