//! Whether the lobes, lights and maps of a program are what they claim to be: no answer of ours is needed.
//!
//! A program lists its [subjects](Description) with the ranges of their parameters and what it claims of them. It then
//! answers two or three questions about each: the value and the density in directions, and samples for random numbers.
//! The [laws](Law::of) of each kind hold these answers against each other.

mod asked;
mod card;
mod case;
pub mod cells;
mod description;
mod domain;
mod laws;
mod light;
mod lobe;
mod map;
mod measured;
mod naming;
mod run;
mod setting;
mod smaller;

pub use card::{junit, page, told};
pub use description::{Claims, Description, Index, Kind, SamplingClaim, Sides, Values};
pub use domain::Domain;
pub use laws::{Breach, Law};
pub use run::{
    Broken, CASES, ClaimsCard, ClaimsOptions, LawStatus, MOST_CASES, SubjectRow, listed, openpbr,
    run,
};
pub use setting::Setting;
