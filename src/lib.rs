//! Groundtruth.

pub mod accel;
pub mod invalid;
pub mod kinds;
pub mod math;
pub mod shapes;
