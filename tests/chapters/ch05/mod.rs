//! Chapter 5: sampling techniques.

mod convergence;
mod discrepancy;
mod draws;
mod independence;
pub mod patterns;
mod sequences;
