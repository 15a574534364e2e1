//! Files: images and meshes that a scene names are read, with their errors and limits; pictures are written; a file is
//! replaced whole or not at all; and text of others is made harmless for messages.

pub mod images;
pub mod meshes;
pub mod pictures;
pub mod printable;
pub mod replace;
