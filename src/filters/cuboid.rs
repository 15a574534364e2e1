//! The box filter (Suffern, ch. 4): the mean over the pixel.

use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{Filter, Specification};
use crate::invalid::Invalid;

/// 1 within the pixel, 0 outside.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "BoxFilter")]
pub struct Box {}

impl Specification for Box {
    fn build(&self, (): &mut ()) -> Result<Arc<dyn Filter>, Invalid> {
        Ok(Arc::new(self.clone()))
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
