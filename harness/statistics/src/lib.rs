//! Statistics of tests: which number says so, and at what level.
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
//! | which values are far from the others? | [`outliers()`] |

pub mod chi_square;
pub mod correlation;
pub mod ks;
pub mod means;
mod outliers;
mod quantile;
pub mod significance;
pub mod slope;

pub use outliers::outliers;
pub use quantile::quantile;
