//! Pictures judged: false alarms, what is found, which cause is named, and what is said of all that.

mod alarms;
mod borders;
mod cases;
mod causes;
mod edges;
#[path = "../../pictures/tests/sums/header.rs"]
mod header;
mod intervals;
pub mod noise;
pub mod pictures;
mod pool;
mod power;
mod progress;
mod rounding;
mod sampling;
mod shared;
mod statistic;
mod told;
mod writers;
