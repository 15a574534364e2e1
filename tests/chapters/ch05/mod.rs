//! Chapter 5: sampling techniques.

mod convergence;
mod discrepancy;
mod draws;
mod independence;
mod path_keys;
pub mod patterns;
mod sequences;
