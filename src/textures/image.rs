//! The image texture (Suffern, ch. 29).

use std::path::PathBuf;
use std::sync::Arc;

use super::sampling::Sampling;
use super::{
    Filtering, Made, Mapping, Rule, Specification, Texel, Texture, TexturePoint, Wrap, made,
};
use crate::images::Drawn;
use crate::kinds::{ImageSource, Resources};
use crate::math::{Length, Point};
use crate::rgb::Rgb;
use formats::images::{Encoding, Texels};

/// An image mapped to a surface: by a mapping of the local point, or by the texture coordinates of
/// a mesh. In the image, u increases to the right and v upward.
#[kind(PartialEq)]
pub struct Image {
    /// The file, relative to the scene file: PNG, JPEG, PPM, HDR, EXR or PFM. An alpha channel is
    /// ignored. Either this, or `drawn`, or `texels`.
    pub file: Option<PathBuf>,
    /// Instead of a file: an image drawn by a formula.
    pub drawn: Option<Drawn>,
    /// In place of a file: its colours, linear, row by row from the top down, as
    /// `[[[1, 0, 0], [0, 0, 1]], [[0, 1, 0], 1]]`.
    pub texels: Option<Vec<Vec<Rgb>>>,
    /// How the image is mapped to the surface; if left out, by the texture coordinates of the
    /// surface, which meshes may have.
    pub mapping: Option<Mapping>,
    /// The length of one unit of the mapping: the radius of the cylinder, half the side of the
    /// rectangle; positive.
    #[default(1.0)]
    pub unit: Length,
    /// Which texels are used; the nearest if left out, as in the book.
    #[default]
    pub filtering: Filtering,
    /// How u outside 0 … 1 is treated; if left out, as the mapping needs, and `repeat` without a
    /// mapping.
    pub wrap_u: Option<Wrap>,
    /// The same for v.
    pub wrap_v: Option<Wrap>,
    /// The part of the image that each texel covers.
    #[default]
    pub rule: Rule,
    /// How a PNG, JPEG or PPM file encodes colours; if left out, what a PNG file says of itself
    /// (sRGB, gAMA), else `srgb`. HDR, EXR and PFM files are linear.
    pub encoding: Option<Encoding>,
    /// The layer or view of an EXR file, such as `ViewLayer.Combined`; only needed if it has
    /// several.
    pub layer: Option<String>,
}

impl Image {
    /// The image of a file, with this mapping or with the surface's texture coordinates.
    pub fn of_file(file: impl Into<PathBuf>, mapping: Option<Mapping>) -> Self {
        Self { file: Some(file.into()), ..Self::empty(mapping) }
    }

    /// A drawn image, with this mapping or with the surface's texture coordinates.
    pub fn of_drawn(drawn: Drawn, mapping: Option<Mapping>) -> Self {
        Self { drawn: Some(drawn), ..Self::empty(mapping) }
    }

    fn empty(mapping: Option<Mapping>) -> Self {
        Self {
            file: None,
            drawn: None,
            texels: None,
            mapping,
            unit: 1.0,
            filtering: Filtering::Nearest,
            wrap_u: None,
            wrap_v: None,
            rule: Rule::Even,
            encoding: None,
            layer: None,
        }
    }
}

#[derive(Debug)]
struct ImageTexture {
    texels: Arc<Texels>,
    mapping: Option<Mapping>,
    unit: f64,
    sampling: Sampling,
}

impl Specification for Image {
    fn make(&self, resources: &mut Resources) -> Made {
        let texels = resources.texels(&ImageSource {
            file: self.file.as_deref(),
            drawn: self.drawn,
            texels: self.texels.as_deref(),
            encoding: self.encoding,
            layer: self.layer.as_deref(),
        })?;
        if self.mapping.is_none() {
            resources.use_uv();
        }
        let [wrap_u, wrap_v] = self.mapping.map_or([Wrap::Repeat; 2], Mapping::wraps);
        let wraps = [self.wrap_u.unwrap_or(wrap_u), self.wrap_v.unwrap_or(wrap_v)];
        let (filtering, rule) = (self.filtering, self.rule);
        made(ImageTexture {
            texels,
            mapping: self.mapping,
            unit: self.unit,
            sampling: Sampling { filtering, rule, wraps },
        })
    }
}

impl ImageTexture {
    fn uv(&self, at: &TexturePoint<'_>) -> [f64; 2] {
        match self.mapping {
            Some(mapping) => {
                let local = at.local.to_array().map(|c| c / self.unit);
                mapping.uv(Point::from(local))
            }
            // building the world checks that the surface has texture coordinates
            None => at.uv().unwrap_or_default(),
        }
    }
}

impl Texture for ImageTexture {
    fn color(&self, at: &TexturePoint<'_>) -> Rgb {
        self.sampling.color(&self.texels, self.uv(at))
    }

    fn texel(&self, at: &TexturePoint<'_>) -> Option<Texel> {
        Some(self.sampling.texel(&self.texels, self.uv(at)))
    }
}
