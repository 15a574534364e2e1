//! Whether another program is right: it is asked the questions of the probe, and its answers are judged.
//!
//! [`suite::all`] are the families of questions; [`run()`] asks a [`Subject`], which is a [`Program`] or the library
//! itself ([`Ours`]), and writes a [`Card`]. Judges are exact answers (of the oracle), our own answers with a measured
//! condition, and laws that need neither ([`laws`]).

pub mod card;
pub mod cases;
mod chapters;
pub mod family;
mod guarded;
mod handed;
mod intersections;
mod invocation;
mod judgement;
mod known;
mod language;
pub mod laws;
pub mod lines;
pub mod mistakes;
pub mod probe;
mod program;
mod questions;
mod radiance;
mod run;
mod scenes;
mod shrink;
mod subject;
pub mod suite;
mod values;

pub use card::{Card, Row, Status};
pub use invocation::Invocation;
pub use judgement::{Judgement, Profile, Wrong, number, numbers, triple};
pub use known::{KnownError, KnownFailures};
pub use language::Language;
pub use program::{Limits, Program};
pub use run::{CASES, MOST_CASES, NoAnswer, Options, run};
pub use scenes::first_difference;
pub use shrink::{simpler, weight};
pub use subject::{Fault, Ours, Reply, Stop, Subject, ours};
