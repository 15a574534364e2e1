//! The picture: the open scene that it is of, its settings, the background threads that render it, its view on the
//! screen, the layer that is shown in its place, and saving it.

pub mod chosen_layer;
pub mod developed;
pub mod display;
pub mod image_settings;
pub mod saving;
pub mod session;
pub mod tiles;
pub mod values;
pub mod view;
pub mod worker;
