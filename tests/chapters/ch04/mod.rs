//! Chapter 4: antialiasing.

mod edges;
mod filters;
mod pixel;
mod sinusoid;
mod variance;
