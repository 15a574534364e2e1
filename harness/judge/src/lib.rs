//! Judges pictures: [`verdict`] says whether a picture with noise agrees with ours, [`mistakes`] renders the pictures of
//! known mistakes, [`exercise`] has a class look for them.

pub mod exercise;
pub mod mistakes;
pub mod sets;
pub mod verdict;
