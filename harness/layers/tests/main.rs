//! Laws of the layers of a picture.

mod borders;
mod colors;
mod explained;
mod files;
mod named;
mod scenes;
