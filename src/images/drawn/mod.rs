//! Images drawn by a formula. They replace the book's images, which may not be copied, and need no
//! file.

mod directions;
mod flat;

use super::Texels;
use crate::invalid::Invalid;
use crate::rgb::Rgb;

/// An image drawn by a formula.
#[kind(Copy, PartialEq, Eq, Hash)]
pub struct Drawn {
    /// What it shows.
    pub picture: Picture,
    /// Columns; at least 1.
    pub width: u32,
    /// Rows; at least 1.
    pub height: u32,
}

/// What a drawn image shows.
#[kind(Hash)]
#[schemars(title = "pictures")]
pub enum Picture {
    /// Lines every 1/24 of the width and 1/12 of the height; red increases to the right, green
    /// upward.
    UvGrid,
    /// 8 × 8 squares, black and white.
    Checker,
    /// An invented planet with seas, land and ice, for the spherical mapping.
    Globe,
    /// 4 × 4 rosettes of pale thread on a dark background.
    Lace,
    /// A panorama of fields, hills and sky, for the cylindrical mapping.
    Country,
    /// A black ball with an 8 on both sides, for the spherical mapping.
    BilliardBall,
    /// The label of a jar of orange jam, for the cylindrical mapping.
    Label,
    /// A clear sky with a sun of radiance 1500, for the hemispherical mapping.
    SkyDome,
    /// A courtyard with lit windows under a bright sky: a light probe (angular map) with values
    /// above 1.
    Courtyard,
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
            Self::UvGrid => flat::uv_grid(u, v),
            Self::Checker => flat::checker(u, v),
            Self::Globe => directions::globe(u, v),
            Self::Lace => flat::lace(u, v),
            Self::Country => flat::country(u, v),
            Self::BilliardBall => directions::billiard_ball(u, v),
            Self::Label => flat::label(u, v),
            Self::SkyDome => directions::sky_dome(u, v),
            Self::Courtyard => directions::courtyard(u, v),
        }
    }
}
