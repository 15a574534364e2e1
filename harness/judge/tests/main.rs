//! Laws of the judge of pictures: the known mistakes, and verdicts.

mod mistakes;
mod sets;
mod verdict;
