//! Laws of scenes in other words: those of other renderers, and plain ones.

#[macro_use]
#[path = "../../../tests/asserts.rs"]
mod asserts;

mod describe;
mod export;
mod framing;
mod reference;
