//! Scenes for other renderers: what is written restores our camera, transforms and radiances.

mod borders;
mod fixtures;
mod function;
mod kinds;
mod mitsuba;
mod mitsuba_camera;
mod mitsuba_surfaces;
mod pov;
mod pov_camera;
mod pov_glass;
mod pov_shapes;
mod refused;
mod said;
mod texts;
mod words;
