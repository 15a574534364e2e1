//! Readers of the files that a scene names: images and meshes, with their errors and limits.

pub mod images;
pub mod meshes;
