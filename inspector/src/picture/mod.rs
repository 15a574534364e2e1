//! The picture: the open scene that it is of, its settings, the background threads that render it, its view on the
//! screen, and saving it.

pub mod display;
pub mod image_settings;
pub mod saving;
pub mod session;
pub mod tiles;
pub mod view;
pub mod worker;
