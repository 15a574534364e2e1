//! Chapter 19: ray-object intersections.
//!
//! | of the book | what is held | by the law |
//! | --- | --- | --- |

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
mod shadow_parts;
mod shapes;
mod textbook;
mod textbook_shadows;
mod torus;
mod torus_parts;
