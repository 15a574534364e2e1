//! Laws of what is kept of a pixel.

#[macro_use]
#[path = "../../../tests/asserts.rs"]
mod asserts;

mod counted;
mod kept_shadows;
mod page;
mod reduced;
