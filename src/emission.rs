//! What a surface sends out by itself (Suffern, ch. 18): asked by materials where it is seen, and by
//! lights where it is sampled.

use std::sync::Arc;

use crate::rgb::Rgb;
use crate::shapes::Surface;
use crate::textures::Texture;

/// Radiance `ls · ce`, the same in every direction of the outer side.
#[derive(Clone, Debug)]
pub struct Emission {
    /// Multiplies the colour.
    pub ls: f64,
    /// The colour.
    pub ce: Arc<dyn Texture>,
}

impl Emission {
    /// The radiance towards a direction at this cosine to the normal, which is negative on the inner
    /// side: that side is black.
    pub fn radiance(&self, at: &Surface, cos_o: f64) -> Rgb {
        if cos_o > 0.0 { self.ls * self.ce.color(at) } else { Rgb::BLACK }
    }
}
