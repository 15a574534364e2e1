//! The texture coordinates of a point.

use serde::Deserialize;

use groundtruth::invalid::{Invalid, finite_point};
use groundtruth::math::Point;
use groundtruth::textures;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Mapping {
    mapping: textures::Mapping,
    /// On the generic object.
    point: Point,
}

impl super::Question for Mapping {
    type Answer = [f64; 2];

    fn answer(&self) -> Result<[f64; 2], Invalid> {
        Ok(self.mapping.uv(finite_point("point", self.point)?))
    }
}
