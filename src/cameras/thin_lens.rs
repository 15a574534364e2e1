//! The thin-lens camera (Suffern, ch. 10): depth of field.

use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{Camera, ViewPlane};
use crate::invalid::{Invalid, not_negative, positive};
use crate::kinds::{self, Specification};
use crate::math::{Point, Vector};

/// A pinhole camera whose hole is a disk: what lies at the focal distance is sharp, all else blurred.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ThinLens {
    /// From the lens to the view plane, `d` in the book; positive. As `distance` of `pinhole`.
    pub distance: f64,
    /// From the lens to the plane that is sharp, `f` in the book; positive. It counts along −w, not
    /// along the ray.
    pub focal_distance: f64,
    /// The radius `R` of the lens, not negative: the larger, the more is blurred; with 0 this is the
    /// pinhole camera.
    pub lens_radius: f64,
    /// Things are this many times as large in the picture; positive.
    #[serde(default = "kinds::one")]
    pub zoom: f64,
}

impl Specification for ThinLens {
    type Built = Arc<dyn Camera>;
    type Context = ViewPlane;

    fn build(&self, _: &mut ViewPlane) -> Result<Arc<dyn Camera>, Invalid> {
        positive("distance", self.distance)?;
        positive("focal_distance", self.focal_distance)?;
        not_negative("lens_radius", self.lens_radius)?;
        positive("zoom", self.zoom)?;
        Ok(Arc::new(self.clone()))
    }

    fn scaled(&self, factor: f64) -> Self {
        Self {
            distance: factor * self.distance,
            focal_distance: factor * self.focal_distance,
            lens_radius: factor * self.lens_radius,
            zoom: self.zoom,
        }
    }

    fn specimens() -> Vec<Self> {
        vec![
            Self { distance: 40.0, focal_distance: 74.0, lens_radius: 1.0, zoom: 0.5 },
            Self { distance: 500.0, focal_distance: 75.0, lens_radius: 20.0, zoom: 1.0 },
            Self { distance: 300.0, focal_distance: 1e5, lens_radius: 0.0, zoom: 2.0 },
        ]
    }
}

impl Camera for ThinLens {
    /// From the point l of the lens through the point `(f/d) p` of the plane that is sharp, p being
    /// the one of the view plane: `(p − (d/f) l) − d w`, which is d/f times the book's direction, so
    /// that a lens of radius 0 gives the pinhole's to the last bit.
    fn ray(&self, [x, y]: [f64; 2], lens: [f64; 2]) -> Option<(Point, Vector)> {
        let (px, py) = (x / self.zoom, y / self.zoom);
        let [lx, ly] = lens.map(|l| self.lens_radius * l);
        let to_plane = self.distance / self.focal_distance;
        let direction = Vector::new(px - to_plane * lx, py - to_plane * ly, -self.distance);
        Some((Point::new(lx, ly, 0.0), direction))
    }

    fn has_lens(&self) -> bool {
        self.lens_radius > 0.0
    }

    /// As for the pinhole camera.
    fn project(&self, point: Point) -> Option<[f64; 2]> {
        let scale = self.zoom * self.distance / -point.z();
        (point.z() < 0.0).then(|| [scale * point.x(), scale * point.y()])
    }

    fn window_shift(&self, aside: f64) -> f64 {
        self.zoom * aside
    }
}
