//! Stereo pairs (Suffern, ch. 12): two eyes side by side, and the layout of their images in the
//! picture.

use crate::invalid::{Invalid, shown};
use crate::math::{cos_degrees, sin_degrees};

/// Two eyes side by side, and the layout of their two images in the picture.
#[kind(Copy, PartialEq)]
#[schemars(example = Stereo { viewing: Viewing::Parallel, gap: 5, separation: 4.0 })]
pub struct Stereo {
    /// How the pair is viewed.
    pub viewing: Viewing,
    /// The number of black pixel columns between the two images.
    #[default(5)]
    pub gap: u32,
    /// The angle β between the directions from `look_at` to the two eyes, in degrees; at least 0,
    /// below 180.
    pub separation: f64,
}

/// How a stereo pair is viewed.
#[kind]
#[schemars(title = "viewings")]
pub enum Viewing {
    /// Left image on the left: for parallel lines of sight.
    Parallel,
    /// Left image on the right: for crossed lines of sight.
    Transverse,
}

/// One of the two eyes of a stereo pair.
#[kind]
pub enum Side {
    /// At −x along u.
    Left,
    /// At +x along u.
    Right,
}

impl Stereo {
    /// Half the distance between the eyes, `x = r tan(β/2)`, where r is the distance to `look_at`.
    pub(super) fn half_distance(&self, r: f64) -> Result<f64, Invalid> {
        let beta = self.separation;
        if !(0.0..180.0).contains(&beta) {
            let found = shown(beta);
            let problem = format!("found {found}, but at least 0 and less than 180 degrees fit");
            return Err(Invalid::field("separation", problem));
        }
        Ok(r * (sin_degrees(0.5 * beta) / cos_degrees(0.5 * beta)))
    }

    /// The first columns of the images of the left and the right eye, where each has `width`
    /// columns.
    pub fn first_columns(&self, width: u32) -> [u32; 2] {
        match self.viewing {
            Viewing::Parallel => [0, width + self.gap],
            Viewing::Transverse => [width + self.gap, 0],
        }
    }

    /// The eye and the column of its image for a column of the picture; `None` in the gap.
    pub fn side_of_column(&self, column: u32, width: u32) -> Option<(Side, u32)> {
        let [first, second] = match self.viewing {
            Viewing::Parallel => [Side::Left, Side::Right],
            Viewing::Transverse => [Side::Right, Side::Left],
        };
        if column < width {
            return Some((first, column));
        }
        Some((second, column.checked_sub(width + self.gap)?))
    }
}
