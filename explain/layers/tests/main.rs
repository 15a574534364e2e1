//! Laws of the layers of a picture.

#[macro_use]
#[path = "../../../tests/asserts.rs"]
mod asserts;

mod borders;
mod colors;
mod explained;
mod files;
mod named;
mod scenes;
