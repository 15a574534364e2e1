//! Cameras (Suffern, ch. 3, 8, 9): from a point of the film to a ray.
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

/// A way to turn film into rays. Contract: `tests/contracts/camera.rs`.
pub trait Camera: Debug + Send + Sync {
    /// Origin and direction of the ray for a point of the view plane, in world units from its
    /// centre, x to the right and y up; in camera coordinates (u, v, w).
    fn ray(&self, film: [f64; 2]) -> (Point, Vector);
}

crate::kinds! {
    /// A camera as a scene file says it.
    Kind builds dyn Camera with ();
    ch03 orthographic::Orthographic,
    ch08 pinhole::Pinhole,
}
