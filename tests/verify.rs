//! The checkers checked: known-bad scenes that a comparison must reject, and the rates of false alarms.

mod bad_scenes;
mod biased_samples;
mod many_seeds;
