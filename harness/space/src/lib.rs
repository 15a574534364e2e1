//! The rays of a pixel in space.
//!
//! [`segments`] turns a recorded tree into straight pieces between points of the world, [`Orbit`] is the camera
//! from which they are looked at, [`Backdrop`] is the scene seen from it, and [`Visibility`] says which pieces
//! a surface hides. Nothing here is tessellated: every shape is seen by the tracer's own rays.

mod backdrop;
mod extent;
mod orbit;
mod segments;
mod visibility;

pub use backdrop::Backdrop;
pub use extent::{of_hits, of_scene, of_segments};
pub use orbit::{Orbit, Sight};
pub use segments::{End, Segment, segments};
pub use visibility::Visibility;
