//! Laws of the program and the repository: commands, documents, layers, fuzz bodies.

#[macro_use]
#[path = "../../tests/asserts.rs"]
mod asserts;
#[path = "../../tests/properties.rs"]
mod properties;

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
mod same_text;
mod scene_reference;
mod sets;
mod structure;
mod told;
mod verify;
