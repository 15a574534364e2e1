//! Verification as a library: pictures compared, golden images kept, statistics judged,
//! intersections held against exact answers.
//!
//! Each checker here is itself checked: it passes on correct data and fails on an error just above the
//! one that its doc line says it finds.
//!
//! Which test for which question:
//!
//! | question | test |
//! | --- | --- |
//! | do samples fall into cells as a density says? | [`chi_square::goodness_of_fit`] |
//! | are two properties independent? | [`chi_square::independence`] |
//! | do numbers follow a continuous distribution? | [`ks::uniform`] of its F |
//! | are two numbers correlated? | [`correlation::pearson`] |
//! | is a mean, such as a pixel's over replicas, what it should be? | [`means::one_sample`] |
//! | do two renderers' means agree? | [`means::two_samples`] |
//! | how fast does an error fall? | [`slope::power_law`] |
//! | at what level, if there are many tests? | [`significance::sidak`] |
//! | how uncertain is a counted rate? | [`significance::proportion`] |

pub mod backward_error;
pub mod chi_square;
pub mod compare;
pub mod composites;
pub mod correlation;
pub mod golden;
pub mod ks;
pub mod means;
mod quantile;
pub mod review;
pub mod significance;
pub mod slope;

mod draw;
// parts of goldens
mod error;
mod view;

// for the tests beside the checkers
#[cfg(test)]
#[path = "../../../tests/verify/biased_samples.rs"]
mod biased_samples;
#[cfg(test)]
#[path = "../../../tests/verify/judge.rs"]
pub(crate) mod judge;

pub use draw::Draw;
pub use error::GoldenError;
pub use quantile::quantile;
pub use view::View;
