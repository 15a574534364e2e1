//! Laws of what is kept of a pixel.

#[macro_use]
#[path = "../../../tests/asserts.rs"]
mod asserts;
#[path = "../../../tests/markup.rs"]
mod markup;

mod counted;
mod kept_shadows;
mod page;
mod reduced;
