//! Judges pictures: [`verdict`] says whether a picture with noise agrees with ours, [`mistakes`] renders the pictures of
//! known mistakes.

pub mod mistakes;
pub mod sets;
pub mod verdict;
