//! The inspector: a picture, and for each pixel the tree of rays that made it.
//!
//! It holds no shading arithmetic: what it shows of light comes from [`explain`], the film, layers and the
//! judge; only the plots of samples are drawn here. [`app::Inspector`] is the whole state and draws the window; what is slow
//! runs beside it in [`picture::worker`]; what a desktop and a page in a browser do differently is in [`platform`].
//!
//! Data go down, actions come up: [`app`] lends its parts to the bars and panels, which return each
//! [`action::Action`] that a user asks for, and `app` performs it. Which module may name which is a
//! table of ARCHITECTURE.md.

pub mod action;
pub mod app;
pub mod comparison;
pub mod explanation;
pub mod picture;
pub mod platform;
pub mod scene;
pub mod space;
pub mod splits;
pub mod start;
pub mod window;
