//! Chapter 5: sampling techniques.

mod convergence;
mod discrepancy;
mod draws;
pub mod patterns;
mod sequences;
