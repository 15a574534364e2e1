//! Laws of the program and the repository: commands, documents, layers, fuzz bodies.

#[macro_use]
extern crate testkit;

mod book;
mod cases;
mod cli;
mod compare;
mod conform;
mod conform_adapters;
mod docs;
mod fuzz;
mod grade;
mod kit;
mod laws;
mod merge;
mod probe;
mod scene_reference;
mod sets;
mod structure;
mod told;
