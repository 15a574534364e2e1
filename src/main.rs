//! Groundtruth.
fn main() {}
