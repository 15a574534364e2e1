//! Chapter 19: ray-object intersections.

mod hard;
mod inward;
pub mod leaving;
mod parts;
mod quadrics;
mod shapes;
