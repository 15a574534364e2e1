//! Laws of the report.

mod report;
