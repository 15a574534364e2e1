//! The checkers checked: their numbers, what they find, and the rates of their false alarms.

#[macro_use]
extern crate testkit;

mod biased_samples;
mod laws;
mod reference;
