//! Chapter 19: ray-object intersections.

mod algebraic;
mod bounding;
mod compound_parts;
pub mod compounds;
mod edges;
mod hard;
mod hard_compounds;
mod inward;
pub mod leaving;
mod light_at_edges;
mod parts;
mod polynomials;
mod quadrics;
mod shapes;
mod textbook;
mod torus;
mod torus_parts;
