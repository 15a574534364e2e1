//! The explanation of the selected pixel: the sum of its samples, the tree of rays of one sample,
//! the details of one ray, and commands that reproduce it outside the window.

pub mod copying;
pub mod details;
pub mod pixel;
pub mod samples;
pub mod selection;
pub mod trail;
pub mod tree;
