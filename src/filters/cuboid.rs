//! The box filter (Suffern, ch. 4): the mean over the pixel.

use super::{Filter, Made, Specification, made};

/// 1 within the pixel, 0 outside.
#[kind(PartialEq)]
#[schemars(rename = "BoxFilter")]
pub struct Box {}

impl Specification for Box {
    fn make(&self, (): &mut ()) -> Made {
        made(self.clone())
    }
}

impl Filter for Box {
    fn draw(&self, u: f64) -> (f64, f64) {
        (u, 1.0)
    }

    fn value(&self, x: f64) -> f64 {
        if x.abs() <= 0.5 { 1.0 } else { 0.0 }
    }

    fn radius(&self) -> f64 {
        0.5
    }
}
