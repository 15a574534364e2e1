//! Laws of questions and answers: what the probe answers, and how `conform` judges what programs answer.

#[macro_use]
extern crate testkit;

mod conform;
mod probe;
