//! Laws of the judge of pictures: the known mistakes, exercises and verdicts.

#[macro_use]
#[path = "../../../tests/asserts.rs"]
mod asserts;

mod exercise;
mod mistakes;
mod sets;
#[path = "../../pictures/tests/verbs.rs"]
mod verbs;
mod verdict;
