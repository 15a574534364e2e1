//! Exact answers for rays and shapes, in arbitrary precision.
//!
//! The oracle judges the library `groundtruth` and knows nothing of it: inputs and answers are
//! plain `f64`, taken as exact numbers; everything between is computed with 512 bits. It says where
//! a ray meets a shape ([`intersect`]), how much each answer depends on rounding ([`Root::cond`],
//! [`Answer::margin`]), and generates hard inputs ([`hard`]).
//!
//! A *relative change by ε* moves every input point and vector by at most ε times its length, in
//! any direction, each independently of the others; a radius, a height and the 3×3 part of a matrix
//! (Frobenius norm) are inputs of their own. Margins are lower bounds to first order, made safe by a
//! second-order term; conditions are exact derivatives.

mod angle;
mod answer;
pub mod hard;
mod margin;
mod polynomials;
mod real;
mod shape;
mod solid;
mod solve;
#[cfg(test)]
mod verified;

pub use answer::{Answer, Root, intersect, intersect_beyond};
pub use polynomials::{polynomial_roots, residual};
pub use shape::{Ray, Shape};
pub use solid::Solid;
pub use solve::condition;
