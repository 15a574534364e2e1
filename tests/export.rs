//! Scenes for other renderers: what is written restores our camera, transforms and radiances.

#[path = "export/function.rs"]
mod function;
#[path = "export/kinds.rs"]
mod kinds;
#[path = "export/parsed.rs"]
mod parsed;
#[path = "export/pov.rs"]
mod pov;
#[path = "export/refusals.rs"]
mod refusals;
