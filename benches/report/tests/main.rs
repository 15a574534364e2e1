//! Laws of the report.

#[macro_use]
#[path = "../../../tests/asserts.rs"]
mod asserts;
#[path = "../../../tests/markup.rs"]
mod markup;

mod report;
