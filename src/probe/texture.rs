//! The colour of a texture at a point.

use serde::Deserialize;

use super::numbers::{Triple, color};
use crate::invalid::Invalid;
use crate::math::{Normal, Point};
use crate::shapes::Surface;
use crate::textures::Paint;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Texture {
    texture: Paint,
    /// In the coordinates of the object.
    point: Point,
}

impl super::Question for Texture {
    type Answer = Triple;

    fn answer(&self) -> Result<Triple, Invalid> {
        let texture = self.texture.build("texture")?;
        // solid textures look at the local point alone
        Ok(color(texture.color(&Surface::new(self.point, 0.0, Normal::Y))))
    }
}
