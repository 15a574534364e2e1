//! Shared by the chapters' laws: how cases are generated, built and judged.

#[macro_use]
pub mod judge;

pub mod asked;
pub mod lamps;
pub mod optics;
pub mod replicas;
pub mod samples;
pub mod solids;
pub mod stage;
pub mod statistics;

pub use testkit::cases::*;
