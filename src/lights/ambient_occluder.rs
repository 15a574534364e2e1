//! The ambient occluder (Suffern, ch. 17): ambient light that objects nearby hold off.

use std::f64::consts::PI;
use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{Context, Light, LightContext, LightSample, Segment, Specification, Target};
use crate::invalid::{Invalid, length, strength, within};
use crate::kinds;
use crate::math::{Frame, Length, maps};
use crate::rgb::Rgb;

/// Ambient light `ls · color` where nothing is in the way, and a share of it where something is:
/// each sample looks in one direction, distributed by the cosine, so that the mean is the visible
/// share of the hemisphere. It meets the ambient reflectance `ka` of materials. The hemisphere is
/// that of the normal: open surfaces that are seen from behind need a two-sided material.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct AmbientOccluder {
    /// Multiplies both colours; not negative.
    #[serde(default = "kinds::one")]
    pub ls: f64,
    /// The colour of the light where nothing is in the way.
    #[serde(default = "kinds::white::<Rgb>")]
    pub color: Rgb,
    /// The share of light where something is, from 0 to 1.
    #[serde(default)]
    pub min_amount: f64,
    /// The colour of the light where something is, which `min_amount` multiplies; `color` if left
    /// out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub occluded_color: Option<Rgb>,
    /// Objects farther away than this are not in the way; positive. Without end if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(with = "Option<Length>")]
    pub max_distance: Option<f64>,
}

impl Default for AmbientOccluder {
    /// White, and black where something is in the way.
    fn default() -> Self {
        let color = Rgb::WHITE;
        Self { ls: 1.0, color, min_amount: 0.0, occluded_color: None, max_distance: None }
    }
}

#[derive(Debug)]
struct Occluder {
    open: Rgb,
    occluded: Rgb,
    max_distance: Option<f64>,
}

impl Specification for AmbientOccluder {
    const FORMULA: &'static str = "\
        adds ρa · V, where ρa is the ambient reflectance of the material, and V the mean over the \
        directions of the hemisphere about the normal, with the density cosθ/π, of this: ls · \
        color where the direction is open, min_amount · ls · occluded_color where an object is hit \
        nearer than max_distance, or where the direction is below the true surface. If the light \
        casts no shadows, V is ls · color.";

    fn build(&self, _: &mut Context) -> Result<Arc<dyn Light>, Invalid> {
        let ls = strength("ls", self.ls)?;
        let open = ls * self.color.checked("color")?;
        let occluded = self.occluded_color.unwrap_or(self.color).checked("occluded_color")?;
        let min_amount = within("min_amount", self.min_amount, 0.0..=1.0)?;
        if self.occluded_color.is_some() && min_amount == 0.0 {
            let problem =
                "found 0, by which `occluded_color` is multiplied: with 1 it is seen as it is";
            return Err(Invalid::field("min_amount", problem));
        }
        let max_distance = self.max_distance.map(|far| length("max_distance", far)).transpose()?;
        Ok(Arc::new(Occluder { open, occluded: min_amount * (ls * occluded), max_distance }))
    }
}

impl Light for Occluder {
    fn draws(&self) -> usize {
        1
    }

    fn is_ambient(&self) -> bool {
        true
    }

    fn sample(&self, from: &LightContext, u: &[[f64; 2]]) -> Option<LightSample> {
        let direction = Frame::around(from.normal).to_world(maps::hemisphere(u[0], 1.0));
        let segment = match self.max_distance {
            None => Segment::Infinity,
            Some(far) => Segment::To(from.point + far * direction),
        };
        Some(LightSample {
            direction,
            segment: Some(segment),
            radiance: self.open,
            blocked: self.occluded,
            pdf: Some(from.normal.dot(direction).max(0.0) / PI),
        })
    }

    fn pdf(&self, from: &LightContext, to: &Target<'_>) -> f64 {
        match to {
            Target::Infinity(direction) => from.normal.dot(*direction).max(0.0) / PI,
            Target::Surface(_) => 0.0,
        }
    }
}
