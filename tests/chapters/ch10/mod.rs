//! Chapter 10: depth of field.

mod blur;
mod rays;
