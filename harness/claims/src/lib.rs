//! Whether the lobes of a program are what they claim to be: no answer of ours is needed.
//!
//! A program lists its [lobes](Description) with the ranges of their parameters and what it claims of them. It then
//! answers two questions about each: the value and the density in directions, and samples for random numbers. The
//! [laws](LAWS) hold these answers against each other.

mod card;
mod case;
pub mod cells;
mod description;
mod language;
mod laws;
mod lobe;
mod naming;
mod run;

pub use card::{junit, page, text};
pub use description::{Claims, Description, Index, Sides, Values};
pub use language::Language;
pub use laws::{Breach, LAWS, Law};
pub use lobe::Trouble;
pub use run::{Broken, Card, Options, Row, Status, listed, run};
