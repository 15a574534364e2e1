//! The space view: the scene from an orbiting camera, with the rays of the selected sample over it.

pub mod backdrop;
pub mod camera;
pub mod filter;
pub mod paint;
pub mod view;
