//! Groundtruth.

pub mod mesh_file;
