//! Chapter 1: ray tracer design and programming.
//!
//! | of the book | what is held | by the law |
//! | --- | --- | --- |

mod look_ups;
mod openness;
mod pieces;
mod shadow_path;
