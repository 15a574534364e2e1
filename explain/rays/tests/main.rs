//! The log of any tracer, and the laws that its rays are held to.

mod border;
mod laws;
mod light;
mod logged;
mod questions;
mod reading;
mod replay;
mod schema;
mod statistics;
mod writers;
