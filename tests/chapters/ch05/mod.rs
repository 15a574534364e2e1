//! Chapter 5: sampling techniques.
//!
//! | of the book | what is held | by the law |
//! | --- | --- | --- |

mod convergence;
mod discrepancy;
mod draws;
mod independence;
mod path_keys;
pub mod patterns;
mod sequences;
