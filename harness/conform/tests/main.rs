//! Laws of questions and answers: what the probe answers, and how `conform` judges what programs answer.

mod conform;
mod probe;
