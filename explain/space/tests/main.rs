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
mod support;
mod view;
mod why_not;
mod words;
