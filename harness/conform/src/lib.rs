//! Whether another program is right: it is asked the questions of the probe, and its answers are judged.
//!
//! [`suite::all`] are the families of questions; [`run()`] asks a [`ask::Subject`], which is an [`ask::Program`] or the library
//! itself ([`Ours`]), and writes a [`Card`]. Judges are exact answers (of the oracle), our own answers with a measured
//! condition, and laws that need neither ([`laws`]).

pub mod card;
pub mod cases;
mod chapters;
pub mod family;
mod handed;
mod intersections;
mod judgement;
mod known;
pub mod laws;
pub mod mistakes;
pub mod probe;
mod questions;
mod radiance;
mod run;
mod scenes;
mod shrink;
mod subject;
pub mod suite;
mod values;

pub use card::{Card, Row, Status};
pub use judgement::{Judgement, Profile, Wrong};
pub use known::{KnownError, KnownFailures};
pub use probe::ours;
pub use run::{CASES, MOST_CASES, NoAnswer, Options, run};
pub use subject::Ours;
pub use values::{Rules, WHOLE};
