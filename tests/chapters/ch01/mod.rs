//! Chapter 1: ray tracer design and programming.

mod openness;
mod pieces;
mod shadow_path;
