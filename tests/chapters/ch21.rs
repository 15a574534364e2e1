//! Chapter 21: transforming objects.

mod beveled;
mod bevels;
mod hard;
mod hard_stones;
mod instances;
mod leaving;
mod local;
mod nested;
mod seams;
mod stones;
