//! Laws of scenes in other words: those of other renderers, and plain ones.

#[macro_use]
extern crate testkit;

mod describe;
mod export;
mod framing;
mod reference;
