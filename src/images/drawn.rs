//! Images drawn by a formula: the book's own belong to their owners, and a scene file stays small.

use std::f64::consts::{PI, TAU};

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::Texels;
use crate::invalid::Invalid;
use crate::math::{Pcg32, Vector, cos, floor, sin};
use crate::rgb::Rgb;

/// An image drawn by a formula.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Drawn {
    /// What it shows.
    pub picture: Picture,
    /// Columns; at least 1.
    pub width: u32,
    /// Rows; at least 1.
    pub height: u32,
}

/// What a drawn image shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
#[schemars(title = "pictures")]
pub enum Picture {
    /// Lines every 1/24 of the width and 1/12 of the height; redder to the right, greener upward.
    UvGrid,
    /// Eight by eight squares, black and white.
    Checker,
    /// A made-up Earth: seas, land and ice, for the spherical mapping.
    Globe,
}

impl Drawn {
    pub(crate) fn check(&self) -> Result<(), Invalid> {
        for (field, count) in [("width", self.width), ("height", self.height)] {
            if count == 0 {
                return Err(Invalid::field(field, "found 0, but an image has at least one texel"));
            }
        }
        Ok(())
    }

    /// The image: each texel has the colour at its centre.
    pub(crate) fn draw(&self) -> Texels {
        let at = |index: u32, count: u32| (f64::from(index) + 0.5) / f64::from(count);
        let rows = (0..self.height).rev();
        let colors = rows.flat_map(|row| {
            (0..self.width).map(move |column| {
                let color = self.picture.color(at(column, self.width), at(row, self.height));
                color.to_array().map(|c| c as f32)
            })
        });
        Texels::new(self.width, self.height, colors.collect())
    }
}

impl Picture {
    /// The colour at texture coordinates from 0 to 1: u to the right, v up.
    fn color(self, u: f64, v: f64) -> Rgb {
        match self {
            Self::UvGrid => uv_grid(u, v),
            Self::Checker => checker(u, v),
            Self::Globe => globe(u, v),
        }
    }
}

fn uv_grid(u: f64, v: f64) -> Rgb {
    let is_line = |x: f64, width: f64| {
        let beside = x - x.round();
        beside.abs() < width
    };
    if is_line(24.0 * u, 0.08) || is_line(12.0 * v, 0.08) {
        return Rgb::BLACK;
    }
    Rgb::new(0.2 + 0.8 * u, 0.2 + 0.8 * v, 0.5)
}

fn checker(u: f64, v: f64) -> Rgb {
    let is_even = (floor(8.0 * u) + floor(8.0 * v)).rem_euclid(2.0) == 0.0;
    if is_even { Rgb::WHITE } else { Rgb::grey(0.02) }
}

/// Land where a sum of waves over the sphere is high, so that the image has no seam.
fn globe(u: f64, v: f64) -> Rgb {
    let (phi, theta) = (TAU * u, PI * (1.0 - v));
    let direction = Vector::new(sin(theta) * sin(phi), cos(theta), sin(theta) * cos(phi));
    let mut random = Pcg32::new(29, 0);
    let mut height = 0.0;
    for wave in 0..24 {
        let mut component = || 2.0 * random.uniform() - 1.0;
        let frequency = 2.0 + 0.5 * f64::from(wave);
        let along = frequency * Vector::new(component(), component(), component());
        height += cos(along.dot(direction) + TAU * component()) / frequency;
    }
    let latitude = 2.0 * (v - 0.5).abs();
    match height {
        _ if latitude + 0.1 * height > 0.87 => Rgb::new(0.85, 0.9, 0.95),
        h if h < 0.15 => Rgb::new(0.02, 0.08, 0.25 + 0.1 * h.max(-1.0)),
        h if h < 0.25 => Rgb::new(0.6, 0.5, 0.25),
        _ if latitude < 0.3 => Rgb::new(0.35, 0.3, 0.1),
        _ => Rgb::new(0.08, 0.25, 0.06),
    }
}
