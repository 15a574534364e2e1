//! Chapter 2: some essential mathematics.

mod angles;
mod frames;
mod powers;
mod random;
mod roots;
pub mod statistics;
mod transforms;
mod vectors;
