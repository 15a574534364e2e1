//! Chapter 3: bare-bones ray tracing.

mod film;
mod hits;
mod picture;
