//! Picture files: PNG and PPM for viewing, EXR and PFM for linear radiance.

use std::io::{BufWriter, Cursor};
use std::path::{Path, PathBuf};

use exr::prelude::{Image as ExrImage, ReadChannels, ReadLayers, SpecificChannels, WritableImage};

use super::replace::{replace, replaceable};
use super::{Film, Provenance, Tone, provenance};
use crate::rgb::Rgb;

/// A picture file that cannot be written or read.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ImageError {
    /// The name does not say which format.
    #[error("{}: unknown picture format; end the name with .png, .ppm, .exr or .pfm", path.display())]
    Format {
        /// The file.
        path: PathBuf,
    },
    /// The file cannot be written; nothing was left behind.
    #[error("{}: cannot be written: {source}", path.display())]
    Unwritable {
        /// The file.
        path: PathBuf,
        /// Why.
        source: std::io::Error,
    },
    /// The file cannot be read, or is not a picture of three channels.
    #[error("{}: cannot be read: {problem}", path.display())]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// Why.
        problem: String,
    },
}

/// The formats of picture files, by the ends of their names.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// For display, compressed.
    Png,
    /// For display.
    Ppm,
    /// Linear radiance, compressed.
    Exr,
    /// Linear radiance.
    Pfm,
}

impl Format {
    /// All of them, with the ends of their names.
    pub const ALL: [(Self, &'static str); 4] =
        [(Self::Png, "png"), (Self::Ppm, "ppm"), (Self::Exr, "exr"), (Self::Pfm, "pfm")];

    /// The format of a file by the end of its name.
    ///
    /// # Errors
    /// [`ImageError::Format`].
    pub fn of(path: &Path) -> Result<Self, ImageError> {
        let extension = path.extension().unwrap_or_default().to_string_lossy().to_lowercase();
        let format = Self::ALL.into_iter().find(|(_, end)| *end == extension);
        format.map(|(format, _)| format).ok_or(ImageError::Format { path: path.to_owned() })
    }

    /// Whether its values are encoded for display, by the gamma of a [`Tone`]; linear radiance if not.
    pub fn is_for_display(self) -> bool {
        matches!(self, Self::Png | Self::Ppm)
    }
}

/// The bytes of a picture file: `.png` and `.ppm` as shown by `tone`, `.exr` and `.pfm` as linear radiance in single
/// precision. PNG and EXR say how it was made; a PNG file also its gamma.
///
/// # Errors
/// Of the encoder; none is known.
pub fn encode(
    film: &Film,
    tone: &Tone,
    format: Format,
    made: &Provenance,
) -> std::io::Result<Vec<u8>> {
    let bytes = encoded(film, tone, format)?;
    Ok(match format {
        Format::Png => made.in_png(&bytes),
        Format::Exr => made.in_exr(&bytes).expect("an EXR file of one part"),
        Format::Ppm | Format::Pfm => bytes,
    })
}

fn encoded(film: &Film, tone: &Tone, format: Format) -> std::io::Result<Vec<u8>> {
    match format {
        Format::Png => Ok(provenance::with_gamma(&png(film, tone)?, tone.gamma)),
        Format::Ppm => Ok(ppm(film, tone)),
        Format::Exr => exr(film),
        Format::Pfm => Ok(pfm(film)),
    }
}

/// Writes a picture: `.png` and `.ppm` as shown by `tone`, `.exr` and `.pfm` as linear radiance in
/// single precision, without a word about how it was made but the gamma of a PNG file. It is written to a temporary file in the same folder and then
/// renamed, so never partly.
///
/// # Errors
/// [`ImageError::Format`] and [`ImageError::Unwritable`].
pub fn write(film: &Film, tone: &Tone, path: &Path) -> Result<(), ImageError> {
    written(path, encoded(film, tone, Format::of(path)?))
}

fn written(path: &Path, bytes: std::io::Result<Vec<u8>>) -> Result<(), ImageError> {
    let unwritable = |source| ImageError::Unwritable { path: path.to_owned(), source };
    replace(path, &bytes.map_err(unwritable)?).map_err(unwritable)
}

/// Whether a picture can be written there, found out before it is rendered.
///
/// # Errors
/// As [`write()`].
pub fn writable(path: &Path) -> Result<(), ImageError> {
    Format::of(path)?;
    replaceable(path).map_err(|source| ImageError::Unwritable { path: path.to_owned(), source })
}

/// Netpbm's binary form with one byte a sample: the bytes of the PNG.
fn ppm(film: &Film, tone: &Tone) -> Vec<u8> {
    let mut bytes = format!("P6\n{} {}\n255\n", film.width(), film.height()).into_bytes();
    bytes.extend(film.pixels().iter().flat_map(|&pixel| tone.to_bytes(pixel)));
    bytes
}

/// Rows from the bottom up; a negative scale says that the least significant byte comes first.
fn pfm(film: &Film) -> Vec<u8> {
    let mut bytes = format!("PF\n{} {}\n-1.0\n", film.width(), film.height()).into_bytes();
    for row in film.pixels().chunks_exact(film.width() as usize).rev() {
        let samples = row.iter().flat_map(|pixel| pixel.to_array());
        bytes.extend(samples.flat_map(|c| super::stored(c).to_le_bytes()));
    }
    bytes
}

fn png(film: &Film, tone: &Tone) -> std::io::Result<Vec<u8>> {
    let bytes = film.pixels().iter().flat_map(|&pixel| tone.to_bytes(pixel)).collect();
    let picture = image::RgbImage::from_raw(film.width(), film.height(), bytes)
        .expect("three bytes for each pixel");
    let mut encoded = Cursor::new(Vec::new());
    picture
        .write_to(&mut BufWriter::new(&mut encoded), image::ImageFormat::Png)
        .map_err(std::io::Error::other)?;
    Ok(encoded.into_inner())
}

fn exr(film: &Film) -> std::io::Result<Vec<u8>> {
    let size = (film.width() as usize, film.height() as usize);
    let channels = SpecificChannels::rgb(|at: exr::math::Vec2<usize>| {
        let [r, g, b] = film.get([at.0 as u32, at.1 as u32]).to_array().map(super::stored);
        (r, g, b)
    });
    let mut encoded = Cursor::new(Vec::new());
    ExrImage::from_channels(size, channels)
        .write()
        .non_parallel() // the same bytes each time: goldens are kept in git
        .to_buffered(&mut encoded)
        .map_err(|e| std::io::Error::other(e.to_string()))?;
    Ok(encoded.into_inner())
}

/// Reads the first layer of an EXR file as linear radiance.
///
/// # Errors
/// [`ImageError::Unreadable`].
pub fn read_exr(path: &Path) -> Result<Film, ImageError> {
    let unreadable = |problem| ImageError::Unreadable { path: path.to_owned(), problem };
    let bytes = std::fs::read(path).map_err(|e| unreadable(e.to_string()))?;
    let film = decode_exr(
        &bytes,
        |[width, height]| Film::new(width, height),
        |film: &mut Film, at, color| film.set(at, Rgb::from(color.map(f64::from))),
    );
    film.map_err(unreadable)
}

/// Decodes the first layer with channels R, G and B of an EXR file. `create` allocates the picture for its
/// columns and rows; `set` sets the colour at a column and a row from the top.
///
/// # Errors
/// What is wrong with them.
fn decode_exr<P: 'static>(
    bytes: &[u8],
    create: impl Fn([u32; 2]) -> P + 'static,
    set: impl Fn(&mut P, [u32; 2], [f32; 3]) + 'static,
) -> Result<P, String> {
    exr::prelude::read()
        .no_deep_data()
        .largest_resolution_level()
        .rgba_channels(
            move |size, _: &_| create([size.width() as u32, size.height() as u32]),
            move |pixels: &mut P, at, (r, g, b, _): (f32, f32, f32, f32)| {
                set(pixels, [at.x() as u32, at.y() as u32], [r, g, b]);
            },
        )
        .first_valid_layer()
        .all_attributes()
        .from_buffered(std::io::Cursor::new(bytes))
        .map(|image| image.layer_data.channel_data.pixels)
        .map_err(|e| e.to_string())
}

/// A picture as shown by `tone`, as the address of an HTML image that needs no file: a PNG in base 64.
pub fn data_uri(film: &Film, tone: &Tone) -> String {
    let png = png(film, tone).expect("nothing fails that is written to memory");
    format!("data:image/png;base64,{}", base64(&png))
}

/// RFC 4648, with padding.
fn base64(bytes: &[u8]) -> String {
    const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for chunk in bytes.chunks(3) {
        let byte = |i: usize| u32::from(chunk.get(i).copied().unwrap_or(0));
        let bits = byte(0) << 16 | byte(1) << 8 | byte(2);
        for i in 0..4 {
            let digit = DIGITS[(bits >> (18 - 6 * i) & 63) as usize];
            text.push(if i <= chunk.len() { digit.into() } else { '=' });
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn base64_has_the_rfcs_examples() {
        for (bytes, text) in [
            ("", ""),
            ("f", "Zg=="),
            ("fo", "Zm8="),
            ("foo", "Zm9v"),
            ("foob", "Zm9vYg=="),
            ("fooba", "Zm9vYmE="),
            ("foobar", "Zm9vYmFy"),
        ] {
            assert_eq!(base64(bytes.as_bytes()), text);
        }
    }
}
