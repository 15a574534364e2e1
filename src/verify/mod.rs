//! Verification as a library: pictures compared, golden images kept, statistics judged.
//!
//! Each checker here is itself checked: it passes on the truth and fails on a planted error just
//! above the power its doc line states.

pub mod compare;
pub mod golden;
pub mod review;
pub mod statistics;

// what goldens are made of
mod error;
mod view;

#[cfg(test)]
mod controls;

pub use error::GoldenError;
pub use view::View;
