//! Laws of the report.

#[macro_use]
extern crate testkit;

mod report;
