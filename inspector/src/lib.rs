//! The inspector: a picture, and for each pixel the tree of rays that made it.
//!
//! It holds no shading arithmetic: each number it shows comes from [`groundtruth::explain`]
//! or from the film. [`app::Inspector`] is the whole state and draws the window; everything slow
//! runs beside it in [`worker`].

pub mod app;
pub mod arguments;
pub mod copying;
pub mod details;
pub mod explanation;
pub mod image_settings;
pub mod kept;
pub mod keys;
pub mod opening;
pub mod panels;
pub mod picture;
pub mod pixel;
pub mod reread;
pub mod samples;
pub mod saving;
pub mod scene_picker;
pub mod splits;
pub mod style;
pub mod switches;
pub mod thumbnails;
pub mod trail;
pub mod tree;
pub mod view;
pub mod watch;
pub mod worker;
