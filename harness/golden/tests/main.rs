//! Laws of the golden images: how they are kept and compared, and known-bad scenes that a comparison must reject.

#[macro_use]
extern crate testkit;

mod bad_scenes;
mod compare;
mod controls;
mod counted;
mod goldens;
mod review;
