//! Programs under questions: what `conform` and `laws` have in common.
//!
//! A [`Program`] is a [`Subject`]: it gets questions in lines of JSON, and each gets a [`Reply`]. Cases are drawn
//! ([`Draw`]) and made smaller ([`smallest()`]); a panic of a judge costs one case ([`guarded()`]).

mod draw;
mod guarded;
mod invocation;
mod junit;
mod language;
pub mod lines;
mod numbers;
mod program;
mod smaller;
mod subject;

pub use draw::Draw;
pub use guarded::guarded;
pub use invocation::Invocation;
pub use junit::{JunitCase, Result as JunitResult, junit};
pub use language::Language;
pub use numbers::{nan_in, number, numbers, triple};
pub use program::{Limits, MOST_FAULTS, Program, WINDOW};
pub use smaller::{simpler, smallest, weight};
pub use subject::{Asking, Fault, Reply, Stop, Subject};
