//! Chapter 4: antialiasing.

mod edges;
mod pixel;
mod variance;
