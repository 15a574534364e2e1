//! The inspector: a picture, and for each pixel the tree of rays that made it.
//!
//! It holds no shading arithmetic: each number it shows comes from [`groundtruth::explain`]
//! or from the film. [`app::Inspector`] is the whole state and draws the window; everything slow
//! runs beside it in [`picture::worker`].
//!
//! Pictures are compared by [`pictures::compare`].
//!
//! Five folders hold the rest: [`scene`], [`picture`] and [`explanation`] for the three parts of
//! the window, [`comparison`] for another program's picture held against ours, and [`window`] for
//! what is around them.

pub mod app;
pub mod comparison;
pub mod explanation;
pub mod picture;
pub mod scene;
pub mod window;
