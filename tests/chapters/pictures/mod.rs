//! Metamorphic laws on whole pictures: how a picture must change, or must not change, when its scene is
//! changed.

mod any_scene;
mod random_scenes;
mod recorded;
pub mod studio;
