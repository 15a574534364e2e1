//! Chapter 21: transforming objects.

mod beveled;
mod hard;
mod instances;
mod leaving;
mod seams;
mod stones;
