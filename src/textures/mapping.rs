//! Mappings from points of generic objects to texture coordinates (Suffern, ch. 29).
//!
//! The generic objects are the rectangle −1 … 1 in x and z, the unit sphere, and the open cylinder
//! of radius 1 with y from −1 to 1; other objects are instances of them.

use std::f64::consts::{PI, TAU};

use super::Wrap;
use crate::math::{Point, atan2};

/// How an image is mapped to a surface.
#[kind]
#[schemars(title = "mappings")]
pub enum Mapping {
    /// On the rectangle −1 … 1 in x and z: u along z, v along x.
    Square,
    /// On the open cylinder with y from −1 to 1: u around it, v along y.
    Cylindrical,
    /// On a sphere about the origin: u around it, v from the south pole up.
    Spherical,
    /// On the upper half of a sphere: u around it, v from the equator to the north pole.
    Hemispherical,
    /// On a sphere about the origin: an angular map (light probe) with +z at the centre and −z at
    /// the rim.
    LightProbe,
    /// As `light_probe`, viewed from inside: −z at the centre.
    Panoramic,
}

impl Mapping {
    /// The texture coordinates of a point in the coordinates of the generic object; from 0 to 1 on
    /// the object.
    pub fn uv(self, p: Point) -> [f64; 2] {
        let [x, y, z] = p.to_array();
        match self {
            Self::Square => [0.5 * (z + 1.0), 0.5 * (x + 1.0)],
            Self::Cylindrical => [azimuth(x, z), 0.5 * (y + 1.0)],
            Self::Spherical => [azimuth(x, z), 1.0 - polar_angle(z, x, y) / PI],
            Self::Hemispherical => [azimuth(x, z), 1.0 - polar_angle(z, x, y) / (0.5 * PI)],
            Self::LightProbe => angular_map(x, y, z),
            Self::Panoramic => angular_map(x, y, -z),
        }
    }

    /// The default wraps along u and v: `repeat` where the image has a seam.
    pub fn wraps(self) -> [Wrap; 2] {
        match self {
            Self::Square | Self::LightProbe | Self::Panoramic => [Wrap::Clamp; 2],
            Self::Cylindrical | Self::Spherical | Self::Hemispherical => {
                [Wrap::Repeat, Wrap::Clamp]
            }
        }
    }
}

/// The azimuth from +z towards +x about the y axis, as a fraction of a full turn: from 0 to 1.
pub(super) fn azimuth(x: f64, z: f64) -> f64 {
    let phi = atan2(x, z);
    (if phi < 0.0 { phi + TAU } else { phi }) / TAU
}

/// The polar angle of `(a, b, along)` to the axis of `along`, at any radius. The book's `acos`
/// needs a clamp and is inaccurate near the axis; `atan2` is not.
pub(super) fn polar_angle(a: f64, b: f64, along: f64) -> f64 {
    atan2(distance(a, b), along)
}

pub(super) fn distance(a: f64, b: f64) -> f64 {
    (a * a + b * b).sqrt()
}

/// The angle `α` to the z axis determines the distance from the centre, `r = α/π`.
fn angular_map(x: f64, y: f64, z: f64) -> [f64; 2] {
    let d = distance(x, y);
    if d == 0.0 && z >= 0.0 {
        return [0.5; 2];
    }
    let r = polar_angle(x, y, z) / PI;
    // the whole rim is the direction −z; take one of its points
    let [cos, sin] = if d == 0.0 { [1.0, 0.0] } else { [x / d, y / d] };
    [0.5 * (1.0 + r * cos), 0.5 * (1.0 + r * sin)]
}
