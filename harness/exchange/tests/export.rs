//! Scenes for other renderers: what is written restores our camera, transforms and radiances.

mod cameras;
mod exposure;
mod fixtures;
mod kinds;
mod mitsuba;
mod mitsuba_surfaces;
mod pov;
mod pov_glass;
mod pov_shapes;
mod said;
mod texts;
mod words;
