//! The laws of lobes, lights and maps: right ones keep them, and mistakes break them.

#[macro_use]
extern crate testkit;

mod around;
mod cells;
mod chance;
mod claimed;
mod counted;
mod extreme;
mod fields;
mod kinds;
mod lamps;
mod mistakes;
mod named;
mod own;
mod protocol;
mod right;
mod rough;
mod smaller;
mod squares;
