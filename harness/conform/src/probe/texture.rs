//! The colour of a texture at a point.

use serde::Deserialize;

use super::numbers::{Triple, color};
use groundtruth::invalid::Invalid;
use groundtruth::kinds::Resources;
use groundtruth::math::{Normal, Point};
use groundtruth::shapes::Surface;
use groundtruth::textures::{Paint, TexturePoint};

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Texture {
    texture: Paint,
    /// In the coordinates of the object.
    #[serde(default = "origin")]
    point: Point,
    /// The texture coordinates of the surface itself, as a mesh has them.
    #[serde(default)]
    uv: Option<[f64; 2]>,
}

fn origin() -> Point {
    Point::ORIGIN
}

impl super::Question for Texture {
    type Answer = Triple;

    fn answer(&self) -> Result<Triple, Invalid> {
        let mut resources = Resources::default();
        let texture = self.texture.build("texture", &mut resources)?;
        if self.uv.is_none() && resources.uses_of_uv() > 0 {
            let problem = "an image without `mapping` needs the texture coordinates of a surface";
            return Err(Invalid::field("uv", problem));
        }
        let surface = Surface::new(self.point, 0.0, Normal::Y);
        let at = match self.uv {
            Some(uv) => TexturePoint::with_uv(&surface, uv),
            None => TexturePoint::new(&surface),
        };
        Ok(color(texture.at(&at)))
    }
}
