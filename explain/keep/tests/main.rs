//! Laws of what is kept of a pixel.

#[macro_use]
extern crate testkit;

mod counted;
mod kept_shadows;
mod page;
mod reduced;
