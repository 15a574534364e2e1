//! Image files: PNG and PPM, HDR and EXR.

use std::io::{BufReader, Cursor};
use std::path::{Path, PathBuf};

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::Texels;
use crate::math::power;

/// An image file that cannot be used.
#[derive(Debug, thiserror::Error)]
#[error("{}: {problem}", path.display())]
pub struct ImageFileError {
    /// The file.
    pub path: PathBuf,
    /// What is wrong, and what would be right.
    pub problem: String,
}

/// What the numbers of a file mean.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
#[schemars(title = "encodings")]
pub enum Encoding {
    /// Steps that look alike, as pictures for eyes have them; they are decoded (IEC 61966-2-1).
    Srgb,
    /// Twice the number is twice the light; the book takes all images so.
    Linear,
}

/// The texels of a file, at most so many.
///
/// # Errors
/// [`ImageFileError`] for what is no image, or a damaged or too large one.
pub fn read(
    path: &Path,
    encoding: Option<Encoding>,
    most_texels: u64,
) -> Result<Texels, ImageFileError> {
    let failed = |problem: String| ImageFileError { path: path.to_owned(), problem };
    let bytes = std::fs::read(path).map_err(|e| failed(e.to_string()))?;
    let reader = image::ImageReader::new(BufReader::new(Cursor::new(bytes)))
        .with_guessed_format()
        .map_err(|e| failed(e.to_string()))?;
    let _ = most_texels;
    let decoded = reader.decode().map_err(|e| failed(e.to_string()))?;
    let (width, height) = (decoded.width(), decoded.height());
    let pixels = decoded.into_rgb32f();
    let decode = |c: f32| match encoding {
        Some(Encoding::Linear) => c,
        _ => srgb_decoded(f64::from(c)) as f32,
    };
    let colors = pixels.pixels().map(|pixel| pixel.0.map(decode)).collect();
    Ok(Texels::new(width, height, colors))
}

/// The linear value of an sRGB one (IEC 61966-2-1).
fn srgb_decoded(c: f64) -> f64 {
    if c <= 0.04045 { c / 12.92 } else { power((c + 0.055) / 1.055, 2.4) }
}
