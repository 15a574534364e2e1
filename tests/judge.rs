//! Laws of the judge of pictures: how two are compared, the known mistakes, and verdicts.

mod compare;
mod mistakes;
#[allow(dead_code)] // others compare texts
mod same_text;
mod verdict;
