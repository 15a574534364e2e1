//! Chapter 1: ray tracer design and programming.

mod look_ups;
mod openness;
mod pieces;
mod shadow_path;
