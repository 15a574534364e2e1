//! Chapter 19: ray-object intersections.

mod algebraic;
mod hard;
pub mod leaving;
mod polynomials;
mod shapes;
mod torus;
mod torus_parts;
