//! The inspector: a picture, and for each pixel the tree of rays that made it.
//!
//! It holds no shading arithmetic: each number it shows comes from [`groundtruth::explain`]
//! or from the film. [`app::Inspector`] is the whole state and draws the window; everything slow
//! runs beside it in [`worker`].

pub mod app;
pub mod copying;
pub mod details;
pub mod explanation;
pub mod panels;
pub mod picture;
pub mod pixel;
pub mod samples;
pub mod switches;
pub mod trail;
pub mod tree;
pub mod view;
pub mod worker;
