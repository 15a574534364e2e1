//! The checkers checked: what they find, and the rates of their false alarms.

#[macro_use]
#[path = "../../../tests/asserts.rs"]
mod asserts;

mod biased_samples;
mod chi_square;
mod correlation;
mod definition;
mod judge;
mod ks;
mod many_seeds;
mod means;
mod outliers;
mod quantile;
mod significance;
mod slope;
