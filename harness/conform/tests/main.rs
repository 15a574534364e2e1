//! Laws of questions and answers: what the probe answers, and how `conform` judges what programs answer.

#[macro_use]
#[path = "../../../tests/asserts.rs"]
mod asserts;
#[path = "../../../tests/properties.rs"]
mod properties;

mod conform;
mod probe;
