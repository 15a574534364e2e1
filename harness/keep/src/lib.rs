//! What one keeps of an explained pixel: a test.

mod reduced;
mod test;

pub use reduced::{Irreducible, Kept, ReducedScene};
