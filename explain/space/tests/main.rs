//! Laws of the rays in space.

#[macro_use]
extern crate testkit;

mod borders;
mod drawing;
mod goldens;
mod incidence;
mod orbit;
mod reasons;
mod section;
mod seen;
mod segments;
mod shadow;
mod support;
mod view;
mod wholes;
mod why_not;
mod words;
