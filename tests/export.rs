//! Scenes for other renderers: what is written restores our camera, transforms and radiances.

#[path = "export/function.rs"]
mod function;
#[path = "export/kinds.rs"]
mod kinds;
#[path = "export/mitsuba.rs"]
mod mitsuba;
#[path = "export/mitsuba_camera.rs"]
mod mitsuba_camera;
#[path = "export/mitsuba_surfaces.rs"]
mod mitsuba_surfaces;
#[path = "export/parsed.rs"]
mod parsed;
#[path = "export/pov.rs"]
mod pov;
#[path = "export/pov_camera.rs"]
mod pov_camera;
#[path = "export/pov_glass.rs"]
mod pov_glass;
#[path = "export/pov_shapes.rs"]
mod pov_shapes;
#[path = "export/refusals.rs"]
mod refusals;
#[path = "export/xml.rs"]
mod xml;
