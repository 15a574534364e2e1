//! Verification as a library: pictures compared, golden images kept, statistics judged,
//! intersections held against exact answers and beside the textbook's.
//!
//! Each checker here is itself checked: it passes on the truth and fails on a planted error just
//! above the power its doc line states.

pub mod against;
pub mod compare;
pub mod golden;
pub mod review;
pub mod statistics;
pub mod textbook;

// what goldens are made of
mod error;
mod view;

#[cfg(test)]
mod controls;

pub use error::GoldenError;
pub use view::View;
