//! Metamorphic laws on whole pictures: what must not change, or must change in a known way, when a
//! scene is changed.

mod any_scene;
mod lights;
mod random_scenes;
mod recorded;
mod same_bits;
pub mod studio;
