//! Metamorphic laws on whole pictures: what must not change, or must change in a known way, when a
//! scene is changed.

mod lights;
mod recorded;
mod same_bits;
pub mod studio;
