//! Chapter 19: ray-object intersections.

mod hard;
pub mod leaving;
mod parts;
mod quadrics;
mod shapes;
