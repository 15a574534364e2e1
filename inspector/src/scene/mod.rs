//! The scene: building it from the gallery or a file, its fields, reading it again when the file changes, and switching its lights
//! and objects on and off.

pub mod fields;
pub mod numbers;
pub mod reload;
pub mod source;
pub mod switches;
pub mod waiting;
pub mod watch;
