//! Laws of what is kept of a pixel.

mod kept_shadows;
mod page;
mod reduced;
