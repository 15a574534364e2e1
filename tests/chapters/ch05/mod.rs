//! Chapter 5: sampling techniques.

mod draws;
mod independence;
mod patterns;
