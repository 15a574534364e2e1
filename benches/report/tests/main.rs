//! Laws of the report.

#[macro_use]
#[path = "../../../tests/asserts.rs"]
mod asserts;

mod report;
