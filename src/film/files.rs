//! Picture files: PNG and PPM for viewing, EXR and PFM for linear radiance.

use std::path::{Path, PathBuf};

use formats::pictures::{self, Channel, with_attributes, with_texts};
use formats::replace::{replace, replaceable};

use super::{Film, Provenance, Tone};
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

    /// Whether its values are encoded for display, by the gamma of a [`Tone`]; linear radiance if
    /// not.
    pub fn is_for_display(self) -> bool {
        matches!(self, Self::Png | Self::Ppm)
    }
}

/// The bytes of a picture file: `.png` and `.ppm` as shown by `tone`, `.exr` and `.pfm` as linear
/// radiance in single precision. PNG and EXR say how it was made; a PNG file also its gamma.
///
/// # Errors
/// Of the encoder; none is known.
pub fn encode(
    film: &Film,
    tone: &Tone,
    format: Format,
    made: &Provenance,
) -> std::io::Result<Vec<u8>> {
    encoded(film, tone, format, &made.entries())
}

fn encoded(
    film: &Film,
    tone: &Tone,
    format: Format,
    entries: &[(&str, String)],
) -> std::io::Result<Vec<u8>> {
    let size = [film.width(), film.height()];
    let radiance = || film.to_f32().collect::<Vec<_>>();
    Ok(match format {
        Format::Png => with_texts(&pictures::png(size, shown(film, tone))?, tone.gamma, entries),
        Format::Ppm => pictures::ppm(size, &shown(film, tone)),
        Format::Exr => of_one_part(&pictures::exr(size, &radiance())?, entries),
        Format::Pfm => pictures::pfm(size, &radiance()),
    })
}

fn shown(film: &Film, tone: &Tone) -> Vec<u8> {
    film.pixels().iter().flat_map(|&pixel| tone.to_bytes(pixel)).collect()
}

fn of_one_part(exr: &[u8], entries: &[(&str, String)]) -> Vec<u8> {
    with_attributes(exr, entries).expect("an EXR file of one part")
}

/// The bytes of an EXR file of such channels, each with `width × height` values, in single
/// precision and with the comment. It says how it was made.
///
/// # Errors
/// A name that EXR cannot say, or that is there twice.
pub fn encode_channels(
    size: [u32; 2],
    channels: Vec<Channel>,
    comment: &str,
    made: &Provenance,
) -> std::io::Result<Vec<u8>> {
    Ok(of_one_part(&pictures::exr_of_channels(size, channels, comment)?, &made.entries()))
}

/// Writes a picture: `.png` and `.ppm` as shown by `tone`, `.exr` and `.pfm` as linear radiance in
/// single precision, without a word about how it was made but the gamma of a PNG file. It is
/// written to a temporary file in the same folder and then renamed, so never partly.
///
/// # Errors
/// [`ImageError::Format`] and [`ImageError::Unwritable`].
pub fn write(film: &Film, tone: &Tone, path: &Path) -> Result<(), ImageError> {
    let bytes = encoded(film, tone, Format::of(path)?, &[]);
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

/// Reads the first layer of an EXR file as linear radiance.
///
/// # Errors
/// [`ImageError::Unreadable`].
pub fn read_exr(path: &Path) -> Result<Film, ImageError> {
    let unreadable = |problem| ImageError::Unreadable { path: path.to_owned(), problem };
    let bytes = std::fs::read(path).map_err(|e| unreadable(e.to_string()))?;
    let film = pictures::read_exr(
        &bytes,
        |[width, height]| Film::new(width, height),
        |film: &mut Film, at, color| film.set(at, Rgb::from(color.map(f64::from))),
    );
    film.map_err(unreadable)
}

/// A picture as shown by `tone`, as the address of an HTML image that needs no file: a PNG in base
/// 64.
pub fn data_uri(film: &Film, tone: &Tone) -> String {
    let png = pictures::png([film.width(), film.height()], shown(film, tone));
    let png = png.expect("nothing fails that is written to memory");
    format!("data:image/png;base64,{}", pictures::base64(&png))
}
