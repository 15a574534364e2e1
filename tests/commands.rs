//! Laws of the program and the repository: commands, goldens, exact sums, the report, documents, layers, fuzz bodies.

mod cli;
mod docs;
mod fuzz;
mod report;
mod structure;
mod sums;
mod verify;
