//! Chapter 19: ray-object intersections.

pub mod compounds;
mod hard;
pub mod leaving;
mod parts;
mod shapes;
