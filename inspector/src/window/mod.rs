//! The window around scene, picture and explanation: the arguments it starts with, its bars, file chooser, keys,
//! division and style, and the settings that are stored between runs.

pub mod arguments;
pub mod chooser;
pub mod keys;
pub mod panels;
pub mod splits;
pub mod stored_settings;
pub mod style;
