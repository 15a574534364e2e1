//! Laws of the rays in space.

mod orbit;
mod seen;
mod segments;
