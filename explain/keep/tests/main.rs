//! Laws of what is kept of a pixel.

#[macro_use]
extern crate testkit;

mod kept_shadows;
mod page;
mod reduced;
