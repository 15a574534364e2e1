//! Our shapes beside the oracle's: the error of a hit, composites whose pieces the oracle intersects one by one, and
//! drawn cases.

pub mod backward_error;
pub mod composites;
mod same_shape;

pub use same_shape::{oracle_shape, our_shape, steps};
