//! Mappings: from points of generic objects to texture coordinates (Suffern, ch. 29).
//!
//! The generic objects are the rectangle −1 … 1 in x and z, the unit sphere, and the open cylinder of
//! radius 1 with y from −1 to 1; all others are instances of them.

use std::f64::consts::{PI, TAU};

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::Wrap;
use crate::math::{Point, atan2};

/// How an image is laid on a surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
#[schemars(title = "mappings")]
pub enum Mapping {
    /// On the rectangle −1 … 1 in x and z: u along z, v along x.
    Square,
    /// On the open cylinder with y from −1 to 1: u around it, v along y.
    Cylindrical,
    /// On a sphere about the origin: u around it, v from the south pole up.
    Spherical,
    /// On its upper half: v from the equator to the north pole.
    Hemispherical,
    /// On a sphere about the origin: an angular map (light probe), +z in the middle, −z all around.
    LightProbe,
    /// The same seen from within: −z in the middle.
    Panoramic,
}

impl Mapping {
    /// The texture coordinates of a point, whose coordinates are measured in the generic object's; from
    /// 0 to 1 on it.
    pub fn uv(self, p: Point) -> [f64; 2] {
        let [x, y, z] = p.to_array();
        match self {
            Self::Square => [0.5 * (z + 1.0), 0.5 * (x + 1.0)],
            Self::Cylindrical => [around(x, z), 0.5 * (y + 1.0)],
            Self::Spherical => [around(x, z), 1.0 - from_axis(z, x, y) / PI],
            Self::Hemispherical => [around(x, z), 1.0 - from_axis(z, x, y) / (0.5 * PI)],
            Self::LightProbe => angular_map(x, y, z),
            Self::Panoramic => angular_map(x, y, -z),
        }
    }

    /// How coordinates beyond 0 … 1 are brought back, along u and v: a seam goes on at its other side.
    pub fn wraps(self) -> [Wrap; 2] {
        match self {
            Self::Square | Self::LightProbe | Self::Panoramic => [Wrap::Clamp; 2],
            Self::Cylindrical | Self::Spherical | Self::Hemispherical => {
                [Wrap::Repeat, Wrap::Clamp]
            }
        }
    }
}

/// The angle from +z towards +x about the y axis, from 0 to 1 for a whole turn.
pub(super) fn around(x: f64, z: f64) -> f64 {
    let phi = atan2(x, z);
    (if phi < 0.0 { phi + TAU } else { phi }) / TAU
}

/// The angle to an axis, `acos` of the book, of any radius: `atan2` needs no clamp and is exact beside
/// the axis.
pub(super) fn from_axis(a: f64, b: f64, along: f64) -> f64 {
    atan2(distance(a, b), along)
}

pub(super) fn distance(a: f64, b: f64) -> f64 {
    (a * a + b * b).sqrt()
}

/// The angle `α` to the z axis is the distance from the middle, `r = α/π`.
fn angular_map(x: f64, y: f64, z: f64) -> [f64; 2] {
    let d = distance(x, y);
    if d == 0.0 && z >= 0.0 {
        return [0.5; 2];
    }
    let r = from_axis(x, y, z) / PI;
    // opposite to the middle every point of the rim is right
    let [cos, sin] = if d == 0.0 { [1.0, 0.0] } else { [x / d, y / d] };
    [0.5 * (1.0 + r * cos), 0.5 * (1.0 + r * sin)]
}
