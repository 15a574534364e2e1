//! What a surface sends out by itself (Suffern, ch. 18): asked by materials where it is seen, and
//! by lights where it is sampled.

use crate::rgb::Rgb;
use crate::textures::{Color, TexturePoint, Value};

/// Radiance `ls · ce`, the same in every direction of the outer side.
#[derive(Clone, Debug)]
pub struct Emission {
    /// Multiplies the colour.
    pub ls: Value,
    /// The colour.
    pub ce: Color,
}

impl Emission {
    /// Whether it is the same everywhere.
    pub fn is_plain(&self) -> bool {
        matches!((&self.ls, &self.ce), (Value::Plain(_), Color::Plain(_)))
    }

    /// The radiance towards a direction at this cosine to the normal, which is negative on the
    /// inner side: that side is black.
    pub fn radiance(&self, at: &TexturePoint<'_>, cos_o: f64) -> Rgb {
        if cos_o > 0.0 { self.ls.at(at) * self.ce.at(at) } else { Rgb::BLACK }
    }
}
