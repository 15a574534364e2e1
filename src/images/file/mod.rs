//! Image files: PNG and PPM, HDR and EXR.
//!
//! The decoders are those of other crates. What they accept is checked here: sizes before memory is
//! allocated, checksums, counts, and values that are not radiance (negative or not finite).

mod exr;
mod hdr;
mod png;
mod pnm;

use std::io::Read;
use std::path::{Path, PathBuf};

use image::{DynamicImage, ImageDecoder, Limits};
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
    /// Whether the `encoding` that was requested is wrong, and not the file.
    pub wrong_encoding: bool,
}

/// How the numbers of an image file encode colours.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
#[schemars(title = "encodings")]
pub enum Encoding {
    /// Gamma-encoded for display (IEC 61966-2-1); decoded to linear values when read.
    Srgb,
    /// Proportional to radiance; the book uses all images like this.
    Linear,
}

/// The maximum size of a file, which is kept in memory while it is decoded.
const MAX_BYTES: u64 = 1 << 29;

/// What is wrong with a file, and what would be right.
type Problem = String;

/// The formats, by their first bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Format {
    Png,
    Pnm,
    Hdr,
    Exr,
}

impl Format {
    fn of(bytes: &[u8]) -> Result<Self, Problem> {
        match bytes {
            [0x89, b'P', b'N', b'G', ..] => Ok(Self::Png),
            [b'P', b'1'..=b'6', ..] => Ok(Self::Pnm),
            [b'#', b'?', ..] => Ok(Self::Hdr),
            [0x76, 0x2f, 0x31, 0x01, ..] => Ok(Self::Exr),
            [] => Err("the file is empty".to_owned()),
            _ => {
                Err("its first bytes are not those of a PNG, PPM, HDR or EXR file; convert it to \
                      one of these"
                    .to_owned())
            }
        }
    }

    /// Whether its numbers are radiance, not display colours.
    fn is_linear(self) -> bool {
        matches!(self, Self::Hdr | Self::Exr)
    }
}

/// The texels of a file, at most `max_texels`.
///
/// # Errors
/// [`ImageFileError`] for a file that is not an image, is damaged, or is too large.
pub fn read(
    path: &Path,
    encoding: Option<Encoding>,
    max_texels: u64,
) -> Result<Texels, ImageFileError> {
    let path_of = |problem, wrong_encoding| {
        let path = path.to_owned();
        ImageFileError { path, problem, wrong_encoding }
    };
    let bytes = read_bytes(path).map_err(|problem| path_of(problem, false))?;
    let format = Format::of(&bytes).map_err(|problem| path_of(problem, false))?;
    if format.is_linear() && encoding == Some(Encoding::Srgb) {
        let problem = "the numbers of HDR and EXR files are linear; leave `encoding` out";
        return Err(path_of(problem.to_owned(), true));
    }
    decode(&bytes, encoding, max_texels).map_err(|problem| path_of(problem, false))
}

/// The texels of the bytes of a file, at most `max_texels`. HDR and EXR are linear, whatever
/// `encoding` is.
///
/// # Errors
/// A text that says what is wrong with the bytes.
pub fn decode(bytes: &[u8], encoding: Option<Encoding>, max_texels: u64) -> Result<Texels, String> {
    match Format::of(bytes)? {
        Format::Png => png::decode(bytes, encoding, max_texels),
        Format::Pnm => pnm::decode(bytes, encoding, max_texels),
        Format::Hdr => hdr::decode(bytes, max_texels),
        Format::Exr => exr::decode(bytes, max_texels),
    }
}

/// All bytes of a file; fails if it is too large.
fn read_bytes(path: &Path) -> Result<Vec<u8>, Problem> {
    let metadata = std::fs::metadata(path).map_err(|e| e.to_string())?;
    if !metadata.is_file() {
        return Err("not a file".to_owned());
    }
    if metadata.len() > MAX_BYTES {
        return Err(format!("{} bytes are too many; at most {MAX_BYTES} fit", metadata.len()));
    }
    let file = std::fs::File::open(path).map_err(|e| e.to_string())?;
    let mut bytes = Vec::new();
    file.take(MAX_BYTES).read_to_end(&mut bytes).map_err(|e| e.to_string())?;
    Ok(bytes)
}

/// Fails if the size is zero or too large.
fn check_size([width, height]: [u64; 2], max_texels: u64) -> Result<(), Problem> {
    match width.checked_mul(height) {
        Some(0) => Err(format!("{width} × {height} texels; an image has at least one")),
        Some(texels) if texels <= max_texels => Ok(()),
        _ => Err(format!(
            "{width} × {height} texels, with the images before it, are too many; at most \
             {max_texels} more fit"
        )),
    }
}

/// The samples of a decoder whose size was checked.
fn samples(decoder: impl ImageDecoder) -> Result<DynamicImage, Problem> {
    let mut decoder = decoder;
    decoder.set_limits(limits(decoder.total_bytes())).map_err(damaged)?;
    DynamicImage::from_decoder(decoder).map_err(damaged)
}

/// A memory limit of `bytes` for the samples, and some more for metadata.
fn limits(bytes: u64) -> Limits {
    let mut limits = Limits::no_limits();
    limits.max_alloc = Some(bytes.saturating_add(1 << 26));
    limits
}

fn damaged(error: image::ImageError) -> Problem {
    match &error {
        image::ImageError::IoError(e) if e.kind() == std::io::ErrorKind::UnexpectedEof => {
            "the file ends before its last texel; it is damaged".to_owned()
        }
        _ => format!("it is damaged, or of a form that is not read: {error}"),
    }
}

/// The colours of integer samples, where `largest` means 1: grey, or red, green and blue; alpha is
/// ignored.
fn integers(
    image: DynamicImage,
    largest: u16,
    encoding: Option<Encoding>,
) -> Result<Texels, Problem> {
    let linear = |sample: u32| {
        let value = f64::from(sample) / f64::from(largest);
        match encoding {
            Some(Encoding::Linear) => value as f32,
            Some(Encoding::Srgb) | None => srgb_decoded(value) as f32,
        }
    };
    // a table, because many texels have the same sample values
    let table: Vec<f32> = (0..=u32::from(largest)).map(linear).collect();
    let (width, height) = (image.width(), image.height());
    let channels = usize::from(image.color().channel_count());
    let colors = match image.as_bytes() {
        bytes if usize::from(image.color().bytes_per_pixel()) == channels => {
            colors(bytes.iter().map(|sample| u16::from(*sample)), channels, &table)
        }
        bytes => {
            let (pairs, _) = bytes.as_chunks::<2>();
            colors(pairs.iter().map(|pair| u16::from_ne_bytes(*pair)), channels, &table)
        }
    };
    Ok(Texels::new(width, height, colors?))
}

fn colors(
    samples: impl Iterator<Item = u16>,
    channels: usize,
    table: &[f32],
) -> Result<Vec<[f32; 3]>, Problem> {
    let mut values = samples.map(|sample| {
        table.get(usize::from(sample)).copied().ok_or_else(|| {
            let largest = table.len() - 1;
            format!("found a sample of {sample}, but the largest value (maxval) is {largest}")
        })
    });
    let mut colors = Vec::with_capacity(values.size_hint().0 / channels);
    while let Some(first) = values.next() {
        let mut next = || values.next().expect("texels have all their channels");
        let first = first?;
        colors.push(if channels < 3 { [first; 3] } else { [first, next()?, next()?] });
        if channels.is_multiple_of(2) {
            next()?;
        }
    }
    Ok(colors)
}

/// Radiance from a file; fails unless it is finite and not negative.
fn radiance(width: u32, height: u32, colors: Vec<[f32; 3]>) -> Result<Texels, Problem> {
    let is_radiance = |color: &[f32; 3]| color.iter().all(|c| c.is_finite() && *c >= 0.0);
    if let Some(at) = colors.iter().position(|color| !is_radiance(color)) {
        let (column, row) = (at % width as usize, at / width as usize);
        return Err(format!(
            "the texel in column {column} from the left, row {row} from the top, both from 0, is \
             {:?}; light is finite and not negative",
            colors[at]
        ));
    }
    Ok(Texels::new(width, height, colors))
}

/// The linear value of an sRGB value (IEC 61966-2-1).
fn srgb_decoded(c: f64) -> f64 {
    if c <= 0.04045 { c / 12.92 } else { power((c + 0.055) / 1.055, 2.4) }
}
