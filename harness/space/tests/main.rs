//! Laws of the rays in space.

mod borders;
mod orbit;
mod section;
mod seen;
mod segments;
mod view;
mod why_not;
