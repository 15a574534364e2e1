//! Chapter 2: some essential mathematics.
//!
//! | of the book | what is held | by the law |
//! | --- | --- | --- |

mod angles;
mod frames;
mod powers;
mod random;
mod roots;
pub mod statistics;
mod transforms;
mod vectors;
