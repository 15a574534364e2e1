//! Pictures judged: false alarms, what is found, which cause is named, and what is said of all that.

#[path = "verdict/alarms.rs"]
mod alarms;
#[path = "verdict/cases.rs"]
mod cases;
#[path = "verdict/causes.rs"]
mod causes;
#[path = "verdict/commands.rs"]
mod commands;
#[path = "verdict/edges.rs"]
mod edges;
#[path = "verdict/pictures.rs"]
mod pictures;
#[path = "verdict/power.rs"]
mod power;
#[path = "verdict/rounding.rs"]
mod rounding;
#[path = "same_text.rs"]
#[allow(dead_code)] // others compare texts
mod same_text;
#[path = "verdict/sampling.rs"]
mod sampling;
#[path = "verdict/shared.rs"]
mod shared;
#[path = "verdict/statistic.rs"]
mod statistic;
#[path = "verdict/writers.rs"]
mod writers;
