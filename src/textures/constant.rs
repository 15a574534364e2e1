//! The constant texture (Suffern, ch. 29): a plain colour.

use super::{Made, Specification, Texture, TexturePoint, made};
use crate::kinds::Resources;
use crate::rgb::Rgb;

/// The same colour everywhere.
#[kind(PartialEq)]
pub struct Constant {
    /// The colour.
    pub color: Rgb,
}

impl Specification for Constant {
    fn make(&self, _: &mut Resources) -> Made {
        self.color.checked("color")?;
        made(self.clone())
    }
}

impl Texture for Constant {
    fn color(&self, _: &TexturePoint<'_>) -> Rgb {
        self.color
    }
}
