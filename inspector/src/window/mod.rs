//! The window around scene, picture and explanation: the arguments it starts with, its bars, list of scenes,
//! file chooser, keys and style, and the settings that are stored between runs.

pub mod arguments;
pub mod chooser;
pub mod frame;
pub mod keys;
pub mod panels;
pub mod picker;
pub mod picture_pane;
pub mod saved;
pub mod scene_panel;
pub mod stored_settings;
pub mod style;
pub mod thumbnails;
