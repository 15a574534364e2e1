//! `groundtruth conform`: statuses, and programs that misbehave.

#[path = "../conform/tests/conform/altered.rs"]
#[allow(dead_code)] // the laws of the judge use the rest of it
mod altered;
mod processes;
mod silence;
mod statuses;
