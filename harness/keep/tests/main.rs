//! Laws of what is kept of a pixel.

mod counted;
mod kept_shadows;
mod page;
mod reduced;
