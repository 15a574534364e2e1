//! Laws of the judge of pictures: the known mistakes, exercises and verdicts.

#[macro_use]
extern crate testkit;

mod exercise;
mod mistakes;
mod sets;
#[path = "../../pictures/tests/verbs.rs"]
mod verbs;
mod verdict;
