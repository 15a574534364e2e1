//! Cameras (Suffern, ch. 3, 8–12): from a point of the film to a ray, and back.
//!
//! A [`Camera`] knows its own coordinates only: the eye at the origin, looking along −w, u to the
//! right and v up. [`Viewpoint`] puts it into the world.

mod orthographic;
mod pinhole;

// shared by the kinds
mod viewpoint;

use std::fmt::Debug;

use crate::math::{Point, Vector};

pub use viewpoint::{View, Viewpoint};

/// The part of the plane of the film that the picture covers, about its centre, in world units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ViewPlane {
    /// From the left edge to the right one; positive.
    pub width: f64,
    /// From the lower edge to the upper one; positive.
    pub height: f64,
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

    /// Where on the film a point (in camera coordinates) is seen, through the centre of the lens;
    /// `None` if it is out of view.
    fn project(&self, point: Point) -> Option<[f64; 2]>;
}

crate::kinds! {
    /// A camera as a scene file says it.
    Kind builds dyn Camera with ViewPlane;
    ch03 orthographic::Orthographic,
    ch08 pinhole::Pinhole,
}
