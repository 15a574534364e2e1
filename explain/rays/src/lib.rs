//! The rays of any ray tracer: the log that a program writes of them, and laws that need no scene.
//!
//! [`Log`] is what was written down; [`Traced`] is the same with each ray beside the one that sent it, the conventions of
//! the program found, and the precision of its numbers. A [`RayLaw`] holds rays to each other; a [`RayVerdict`] is what
//! all of them found.

mod conventions;
mod json;
mod language;
mod laws;
mod log;
mod logged;
mod page;
mod placing;
mod precision;
mod recorded;
mod replay;
mod scene;
mod text;
mod traced;
mod verdict;
mod written;

pub use conventions::Conventions;
pub use language::WRITERS;
pub use laws::{BrokenRay, LAWS, LawReport, RayLaw};
pub use log::{
    Damaged, FIELDS, Factors, Field, Head, Id, Log, LogError, MAX_RAYS, Named, Precision, Purpose,
    Ray, read,
};
pub use logged::{Logged, LoggedValue, RayPlace, size};
pub use recorded::Recorded;
pub use scene::{empty_scene, inline_scene, world_of};
pub use text::laws_text;
pub use traced::Traced;
pub use verdict::{Outcome, PixelVerdict, RayVerdict};
pub use written::log_of;
