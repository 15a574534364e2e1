//! The rays of a pixel in space.
//!
//! [`segments`] turns a recorded tree into straight pieces between points of the world, [`Orbit`] is the camera
//! from which they are looked at, and [`Backdrop`] is the scene seen from it, which says what of them a surface hides. A [`Section`] is the plane of incidence of a hit as a [`Drawing`]. Nothing here is tessellated:
//! every shape is seen by the tracer's own rays. [`svg_of_rays`] and [`obj()`] are the rays for pages and for
//! modelling programs. [`why_not`] says why a ray does not hit an object.

mod approach;
mod backdrop;
mod drawing;
mod extent;
mod hits;
mod obj;
mod orbit;
mod section;
mod segments;
mod view;
pub mod why_not;

pub use approach::{Approach, Beside};
pub use backdrop::Backdrop;
pub use drawing::{Drawing, Label, Role, Stroke, arrowhead, ink};
pub use extent::{of_hits, of_scene};
pub use obj::obj;
pub use orbit::{Orbit, Sight};
pub use section::{Curve, RayAngle, Refraction, Section, SectionPlane, Window, outlines};
pub use segments::{End, Segment, segments};
pub use view::{hiding, orbit_of, svg_of_rays};
