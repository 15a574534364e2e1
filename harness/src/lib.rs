//! The harness of Groundtruth: what judges the tracer, and what others ask it.
//!
//! [`compare`] holds two pictures against each other, [`verify`] holds what checks pictures, statistics and
//! intersections, [`mistakes`] renders the pictures of known mistakes, [`report`] measures what to choose, [`sums`] adds
//! replicas exactly, [`probe`] answers questions in JSON, [`mod@reference`] says what a scene file can say. The binary
//! `groundtruth` is the command line of all of it.

pub mod compare;
pub mod conform;
mod html;
pub mod mistakes;
pub mod probe;
pub mod reference;
pub mod report;
pub mod sums;
pub mod verify;
