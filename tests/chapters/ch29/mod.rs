//! Chapter 29: images on surfaces and as skies.
//!
//! | of the book | what is held | by the law |
//! | --- | --- | --- |

mod mappings;
mod materials;
mod one_texel;
mod sky;
mod sky_light;
mod texels;

use std::io::Write;

use groundtruth::kinds::Resources;
use groundtruth::textures::{Image, Kind, Mapping, Texture};

use crate::prelude::*;

/// A linear image whose texel at a column from the left and a row from the bottom has this colour, in steps
/// of 1/65535; the file is deleted when the value is dropped.
pub fn image_file(
    [width, height]: [u32; 2],
    color: impl Fn(u32, u32) -> [u16; 3],
) -> tempfile::NamedTempFile {
    let mut file = tempfile::Builder::new().suffix(".ppm").tempfile().expect("a temporary file");
    let mut bytes = format!("P6\n{width} {height}\n65535\n").into_bytes();
    for from_top in 0..height {
        let row = height - 1 - from_top;
        let texels = (0..width).flat_map(|column| color(column, row));
        bytes.extend(texels.flat_map(u16::to_be_bytes));
    }
    file.write_all(&bytes).expect("room for a small file");
    file
}

/// An image of that file by the surface's own texture coordinates, or a mapping.
pub fn linear(file: &tempfile::NamedTempFile, mapping: Option<Mapping>) -> Image {
    let encoding = Some(formats::images::Encoding::Linear);
    Image { encoding, ..Image::of_file(file.path(), mapping) }
}

fn texture(image: &Image) -> Arc<dyn Texture> {
    Kind::from(image.clone()).build(&mut Resources::default()).expect("an image")
}

/// The colours that an image has at texture coordinates.
pub fn by_uv(image: &Image) -> impl Fn([f64; 2]) -> Rgb + use<> {
    let (texture, surface) = (texture(image), Surface::new(Point::ORIGIN, 0.0, Normal::Y));
    move |uv| texture.color(&TexturePoint::with_uv(&surface, uv))
}

/// The columns and rows that an image names at texture coordinates.
pub fn texel_by_uv(image: &Image) -> impl Fn([f64; 2]) -> [u32; 2] + use<> {
    let (texture, surface) = (texture(image), Surface::new(Point::ORIGIN, 0.0, Normal::Y));
    move |uv| {
        let texel =
            texture.texel(&TexturePoint::with_uv(&surface, uv)).expect("an image has texels");
        [texel.column, texel.row]
    }
}
