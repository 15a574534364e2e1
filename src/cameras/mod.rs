//! Cameras (Suffern, ch. 3, 8–12): from a point of the film to a ray, and back.
//!
//! A [`Camera`] knows its own coordinates only: the eye at the origin, looking along −w, u to the
//! right and v up. [`Viewpoint`] puts it into the world.

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
pub use viewpoint::{Eye, View, Viewpoint};

/// The part of the plane of the film that the picture covers, about its centre, in world units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ViewPlane {
    /// From the left edge to the right one; positive.
    pub width: f64,
    /// From the lower edge to the upper one; positive.
    pub height: f64,
}

impl ViewPlane {
    /// Film coordinates as the book normalises them: from −1 to 1 across the picture.
    fn normalised(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [2.0 * x / self.width, 2.0 * y / self.height]
    }

    /// The film point of normalised coordinates.
    fn point(&self, [xn, yn]: [f64; 2]) -> [f64; 2] {
        [0.5 * xn * self.width, 0.5 * yn * self.height]
    }

    /// Whether the picture covers a point; its edges are part of it.
    fn contains(&self, [x, y]: [f64; 2]) -> bool {
        x.abs() <= 0.5 * self.width && y.abs() <= 0.5 * self.height
    }
}

/// A way to turn film into rays, and back. Contract: `tests/contracts/camera.rs`.
pub trait Camera: Debug + Send + Sync {
    /// Origin and direction of the ray for a point of the film, in world units from its centre, x
    /// to the right and y up; in camera coordinates (u, v, w). `None` where the camera sees nothing.
    ///
    /// `lens` is a point of the unit disk, for cameras that have one ([`Camera::has_lens`]).
    fn ray(&self, film: [f64; 2], lens: [f64; 2]) -> Option<(Point, Vector)>;

    /// Whether rays start all over a lens. If not, nothing is drawn for it.
    fn has_lens(&self) -> bool {
        false
    }

    /// Where on the film a point (in camera coordinates) is seen, through the centre of the lens, in
    /// the picture or beside it: the inverse of [`Camera::ray`]. `None` if no film could see it.
    fn project(&self, point: Point) -> Option<[f64; 2]>;

    /// By how much all film places move to the right when the eye moves to the left by `aside` and the
    /// window in space through which it looks stays where it is: the asymmetric frustum of a stereo
    /// pair (Suffern, ch. 12). 0 for cameras that look through no window.
    fn window_shift(&self, _aside: f64) -> f64 {
        0.0
    }
}

crate::kinds! {
    /// How the picture becomes rays.
    Kind builds dyn Camera with ViewPlane;
    ch03 orthographic::Orthographic,
    ch08 pinhole::Pinhole,
    ch10 thin_lens::ThinLens,
    ch11 fisheye::Fisheye,
    ch11 spherical_panorama::SphericalPanorama,
    ch11 cylindrical_panorama::CylindricalPanorama,
}
