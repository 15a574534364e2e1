//! Groundtruth.

pub mod accel;
pub mod invalid;
pub mod kinds;
pub mod math;
pub mod mesh_file;
pub mod shapes;
