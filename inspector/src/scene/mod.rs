//! The scene: choosing it from the gallery, opening it from a file, reading it again when the file
//! changes, and switching its lights and objects on and off.

pub mod opening;
pub mod picker;
pub mod reload;
pub mod source;
pub mod switches;
pub mod thumbnails;
pub mod waiting;
pub mod watch;
