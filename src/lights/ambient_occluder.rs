//! The ambient occluder (Suffern, ch. 17): ambient light that objects nearby hold off.

use std::f64::consts::PI;

use super::{
    Context, Light, LightContext, LightSample, Made, Segment, Specification, Target, made,
};
use crate::invalid::Invalid;
use crate::math::{Frame, Length, Share, Strength, maps};
use crate::rgb::Rgb;

/// Ambient light `ls · color` where nothing is in the way, and a share of it where something is:
/// each sample looks in one direction, distributed by the cosine, so that the mean is the visible
/// share of the hemisphere. It meets the ambient reflectance `ka` of materials. The hemisphere is
/// that of the normal: open surfaces that are seen from behind need a two-sided material.
#[kind(Default, PartialEq)]
pub struct AmbientOccluder {
    /// Multiplies both colours; not negative.
    #[default(1.0)]
    pub ls: Strength,
    /// The colour of the light where nothing is in the way.
    #[default(Rgb::WHITE)]
    pub color: Rgb,
    /// The share of light where something is, from 0 to 1.
    #[default]
    pub min_amount: Share,
    /// The colour of the light where something is, which `min_amount` multiplies; `color` if left
    /// out.
    pub occluded_color: Option<Rgb>,
    /// Objects farther away than this are not in the way; positive. Without end if left out.
    pub max_distance: Option<Length>,
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

    fn make(&self, _: &mut Context) -> Made {
        let open = self.ls * self.color.checked("color")?;
        let occluded = self.occluded_color.unwrap_or(self.color).checked("occluded_color")?;
        if self.occluded_color.is_some() && self.min_amount == 0.0 {
            let problem =
                "found 0, by which `occluded_color` is multiplied: with 1 it is seen as it is";
            return Err(Invalid::field("min_amount", problem));
        }
        let occluded = self.min_amount * (self.ls * occluded);
        made(Occluder { open, occluded, max_distance: self.max_distance })
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
