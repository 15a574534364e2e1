//! Laws of the layers of a picture.

#[macro_use]
extern crate testkit;

mod borders;
mod explained;
mod files;
mod named;
mod scenes;
