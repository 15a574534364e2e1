//! The orthographic camera (Suffern, ch. 3): parallel rays.

use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{Camera, Specification, ViewPlane};
use crate::invalid::{Invalid, positive};
use crate::kinds;
use crate::math::{Point, Vector};

/// Rays along −w from a plane through the eye.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Orthographic {
    /// The magnification; positive.
    #[serde(default = "kinds::one")]
    pub zoom: f64,
}

impl Specification for Orthographic {
    fn build(&self, _: &mut ViewPlane) -> Result<Arc<dyn Camera>, Invalid> {
        positive("zoom", self.zoom)?;
        Ok(Arc::new(self.clone()))
    }
}

impl Camera for Orthographic {
    fn ray(&self, [x, y]: [f64; 2], _: [f64; 2]) -> Option<(Point, Vector)> {
        Some((Point::new(x / self.zoom, y / self.zoom, 0.0), -Vector::Z))
    }

    /// Points in front of the plane through the eye.
    fn project(&self, point: Point) -> Option<[f64; 2]> {
        (point.z() < 0.0).then(|| [self.zoom * point.x(), self.zoom * point.y()])
    }

    fn window_shift(&self, eye_shift: f64) -> f64 {
        self.zoom * eye_shift
    }
}
