//! Groundtruth.
