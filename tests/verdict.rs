//! Pictures judged: false alarms, what is found, and what is said of both.

#[path = "verdict/pictures.rs"]
mod pictures;
#[path = "verdict/rates.rs"]
mod rates;
