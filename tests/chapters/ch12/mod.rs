//! Chapter 12: stereoscopy.

mod geometry;
mod pictures;
