//! The checkers checked: known-bad scenes that a comparison must reject, and the rates of false alarms.

#[path = "verify/bad_scenes.rs"]
mod bad_scenes;
#[path = "verify/biased_samples.rs"]
mod biased_samples;
#[path = "verify/many_seeds.rs"]
mod many_seeds;
