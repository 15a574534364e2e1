//! The checkers checked: their numbers, what they find, and the rates of their false alarms.

#[macro_use]
#[path = "../../../tests/asserts.rs"]
mod asserts;

mod biased_samples;
mod laws;
mod many_seeds;
mod reference;
