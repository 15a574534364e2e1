//! Image files: PNG, JPEG and PPM; HDR, EXR and PFM.
//!
//! The decoders are those of other crates. What they accept is checked here: sizes before memory is
//! allocated, checksums, counts, and values that are not radiance (negative or not finite).

mod exr;
mod exr_layers;
pub mod guard;
mod hdr;
mod integers;
mod jpeg;
mod pfm;
mod png;
mod pnm;
mod texels;
mod transfer;

use std::io::Read;
use std::path::{Path, PathBuf};

use image::{DynamicImage, ImageDecoder, Limits};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use integers::integers;
pub use texels::Texels;
pub use transfer::{Curve, Transfer, settled};

/// An image file that cannot be used.
#[derive(Debug, thiserror::Error)]
#[error("{}: {problem}", path.display())]
pub struct ImageFileError {
    /// The file.
    pub path: PathBuf,
    /// What is wrong, and what would be right.
    pub problem: String,
    /// The field that is wrong: `file`, `encoding` or `layer`.
    pub field: &'static str,
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

/// The maximum memory for one texel while it is decoded: samples of 16 bytes, and the colour.
const MAX_MEMORY: u64 = 28;

/// What is wrong with a file, and what would be right.
type Problem = String;

/// A problem, and the field of a scene that it is about.
#[derive(Debug, PartialEq)]
struct Wrong {
    field: &'static str,
    problem: Problem,
}

impl Wrong {
    fn layer(problem: Problem) -> Self {
        Self { field: "layer", problem }
    }
}

impl From<Problem> for Wrong {
    fn from(problem: Problem) -> Self {
        Self { field: "file", problem }
    }
}

/// The formats, by their first bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Format {
    Png,
    Jpeg,
    Pnm,
    Hdr,
    Exr,
    Pfm,
}

impl Format {
    fn of(bytes: &[u8]) -> Result<Self, Problem> {
        match bytes {
            [0x89, b'P', b'N', b'G', ..] => Ok(Self::Png),
            [0xff, 0xd8, 0xff, ..] => Ok(Self::Jpeg),
            [b'P', b'F' | b'f', b' ' | b'\t' | b'\r' | b'\n', ..] => Ok(Self::Pfm),
            [b'P', b'1'..=b'6', ..] => Ok(Self::Pnm),
            [b'#', b'?', ..] => Ok(Self::Hdr),
            [0x76, 0x2f, 0x31, 0x01, ..] => Ok(Self::Exr),
            [] => Err("the file is empty".to_owned()),
            _ => Err("its first bytes are not those of a PNG, JPEG, PPM, HDR, EXR or PFM file; \
                      convert it to one of these"
                .to_owned()),
        }
    }

    /// Whether its numbers are radiance, not display colours.
    fn is_linear(self) -> bool {
        matches!(self, Self::Hdr | Self::Exr | Self::Pfm)
    }
}

/// The texels of a file, at most `max_texels`; of an EXR file the layer of this name.
///
/// # Errors
/// [`ImageFileError`] for a file that is not an image, is damaged, or is too large.
pub fn read(
    path: &Path,
    encoding: Option<Encoding>,
    layer: Option<&str>,
    max_texels: u64,
) -> Result<Texels, ImageFileError> {
    let wrong = |field, problem| ImageFileError { path: path.to_owned(), problem, field };
    let bytes = read_bytes(path).map_err(|problem| wrong("file", problem))?;
    let format = Format::of(&bytes).map_err(|problem| wrong("file", problem))?;
    if format.is_linear() && encoding == Some(Encoding::Srgb) {
        let problem = "the numbers of HDR, EXR and PFM files are linear; leave `encoding` out";
        return Err(wrong("encoding", problem.to_owned()));
    }
    if format != Format::Exr && layer.is_some() {
        let problem = "only EXR files have layers; leave `layer` out";
        return Err(wrong("layer", problem.to_owned()));
    }
    decode_format(format, &bytes, encoding, layer, max_texels)
        .map_err(|Wrong { field, problem }| wrong(field, problem))
}

/// The texels of the bytes of a file, at most `max_texels`. HDR, EXR and PFM are linear, whatever
/// `encoding` is; of others it is what a PNG file says, else sRGB, if it is left out.
///
/// # Errors
/// A text that says what is wrong with the bytes.
pub fn decode(bytes: &[u8], encoding: Option<Encoding>, max_texels: u64) -> Result<Texels, String> {
    decode_layer(bytes, encoding, None, max_texels)
}

/// As [`decode()`]; of an EXR file the layer of this name.
///
/// # Errors
/// As [`decode()`].
pub fn decode_layer(
    bytes: &[u8],
    encoding: Option<Encoding>,
    layer: Option<&str>,
    max_texels: u64,
) -> Result<Texels, String> {
    let format = Format::of(bytes)?;
    decode_format(format, bytes, encoding, layer, max_texels).map_err(|wrong| wrong.problem)
}

fn decode_format(
    format: Format,
    bytes: &[u8],
    encoding: Option<Encoding>,
    layer: Option<&str>,
    max_texels: u64,
) -> Result<Texels, Wrong> {
    let (curve, note) = curve(format, bytes)?;
    let wrong = |problem| Wrong { field: "encoding", problem };
    let (transfer, own) =
        settled(curve, encoding.map(Transfer::from), "`encoding`").map_err(wrong)?;
    let transfer = transfer.unwrap_or(Transfer::Srgb);
    let texels = decode_stored(format, bytes, transfer, layer, max_texels)?;
    let texels = texels.with_notes(note).with_notes(own);
    Ok(if format.is_linear() { radiance(texels)? } else { texels })
}

/// What the file says of its transfer function, and a note on its primaries.
fn curve(format: Format, bytes: &[u8]) -> Result<(Option<Curve>, Option<String>), Problem> {
    match format {
        Format::Png => png::curve(bytes),
        _ => Ok((None, None)),
    }
}

/// The values as the file stores them, also those that are no radiance; of integers what this function decodes.
fn decode_stored(
    format: Format,
    bytes: &[u8],
    transfer: Transfer,
    layer: Option<&str>,
    max_texels: u64,
) -> Result<Texels, Wrong> {
    guard::guarded(|| {
        Ok(match format {
            Format::Png => png::decode(bytes, transfer, max_texels)?,
            Format::Jpeg => jpeg::decode(bytes, transfer, max_texels)?,
            Format::Pnm => pnm::decode(bytes, transfer, max_texels)?,
            Format::Hdr => hdr::decode(bytes, max_texels)?,
            Format::Exr => exr::decode(bytes, layer, max_texels)?,
            Format::Pfm => pfm::decode(bytes, max_texels)?,
        })
    })
}

/// A picture file as it is stored, for those who judge it.
#[derive(Debug)]
pub struct Stored {
    /// Its values: of HDR, EXR and PFM files as they are, negative and not finite ones among them; of others
    /// from 0 to 1, not decoded.
    pub texels: Texels,
    /// Whether they are radiance, not encoded for display.
    pub is_linear: bool,
    /// What the file says of its transfer function, if anything.
    pub curve: Option<Curve>,
    /// Of a JPEG, by how many steps of 1/255 the mean of a block of 16 × 16 pixels may be off.
    pub loss: Option<f64>,
}

/// The stored values of a picture file, or of the standard input if its path is `-`; at most `max_texels`.
///
/// # Errors
/// As [`read`].
pub fn read_stored(path: &Path, max_texels: u64) -> Result<Stored, ImageFileError> {
    let wrong = |problem| ImageFileError { path: path.to_owned(), problem, field: "file" };
    let bytes = match path == Path::new("-") {
        true => read_input(),
        false => read_bytes(path),
    };
    stored(&bytes.map_err(wrong)?, path, max_texels)
}

/// As [`read_stored`], of the bytes of a file; `path` is for error messages.
///
/// # Errors
/// As [`read`].
pub fn stored(bytes: &[u8], path: &Path, max_texels: u64) -> Result<Stored, ImageFileError> {
    let wrong = |problem| ImageFileError { path: path.to_owned(), problem, field: "file" };
    let format = Format::of(bytes).map_err(wrong)?;
    let texels = decode_stored(format, bytes, Transfer::Linear, None, max_texels);
    let texels = texels.map_err(|Wrong { problem, .. }| wrong(problem))?;
    let (curve, note) = curve(format, bytes).map_err(wrong)?;
    let loss = (format == Format::Jpeg).then(|| jpeg::loss(bytes));
    Ok(Stored { texels: texels.with_notes(note), is_linear: format.is_linear(), curve, loss })
}

/// All bytes of the standard input; fails if they are too many.
fn read_input() -> Result<Vec<u8>, Problem> {
    let mut bytes = Vec::new();
    let input = std::io::stdin().lock();
    input.take(MAX_BYTES + 1).read_to_end(&mut bytes).map_err(|e| e.to_string())?;
    match bytes.len() as u64 > MAX_BYTES {
        true => Err(format!("there are too many bytes; at most {MAX_BYTES} fit")),
        false => Ok(bytes),
    }
}

/// All bytes of a file; fails if its first bytes are not those of an image, or it is too large.
fn read_bytes(path: &Path) -> Result<Vec<u8>, Problem> {
    const SIGNATURE: u64 = 4;
    let metadata = std::fs::metadata(path).map_err(|e| e.to_string())?;
    if !metadata.is_file() {
        return Err("not a file".to_owned());
    }
    let mut file = std::fs::File::open(path).map_err(|e| e.to_string())?;
    let mut bytes = Vec::new();
    (&mut file).take(SIGNATURE).read_to_end(&mut bytes).map_err(|e| e.to_string())?;
    Format::of(&bytes)?;
    let mut size = metadata.len();
    if size <= MAX_BYTES {
        bytes.try_reserve_exact(size as usize).map_err(|e| e.to_string())?;
        // it may grow while it is read
        file.take(MAX_BYTES).read_to_end(&mut bytes).map_err(|e| e.to_string())?;
        size = bytes.len() as u64;
    }
    if size > MAX_BYTES {
        return Err(format!("{size} bytes are too many; at most {MAX_BYTES} fit"));
    }
    Ok(bytes)
}

/// A note on bytes that no texel is made of.
fn after_the_end(rest: &[u8]) -> Option<String> {
    match rest.len() {
        0 => None,
        1 => Some("1 byte after its end is ignored".to_owned()),
        count => Some(format!("{count} bytes after its end are ignored")),
    }
}

/// Fails if the size is zero or too large, also for the memory of this machine.
fn check_size([width, height]: [u64; 2], max_texels: u64) -> Result<(), Problem> {
    match width.checked_mul(height) {
        Some(0) => Err(format!("{width} × {height} texels; an image has at least one")),
        Some(texels) if texels <= max_texels => {
            // the decoders abort the program if they get no memory
            Vec::<u8>::new()
                .try_reserve_exact((MAX_MEMORY * texels) as usize)
                .map_err(|_| format!("{width} × {height} texels need more memory than there is"))
        }
        _ => Err(format!(
            "{width} × {height} texels, with the images before it, are too many; at most \
             {max_texels} more fit"
        )),
    }
}

/// The samples of a decoder whose size was checked, turned as its EXIF data say.
fn samples(decoder: impl ImageDecoder) -> Result<DynamicImage, Problem> {
    let mut decoder = decoder;
    decoder.set_limits(limits(decoder.total_bytes())).map_err(damaged)?;
    let orientation = decoder.orientation().map_err(damaged)?;
    let mut image = DynamicImage::from_decoder(decoder).map_err(damaged)?;
    image.apply_orientation(orientation);
    Ok(image)
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

/// Radiance from a file; fails unless it is finite. Negative values, which filters leave beside bright
/// texels, become 0.
fn radiance(mut texels: Texels) -> Result<Texels, Problem> {
    let colors = &mut texels.colors;
    if let Some(at) = colors.iter().position(|color| !color.iter().all(|c| c.is_finite())) {
        let (column, row) = (at % texels.width as usize, at / texels.width as usize);
        return Err(format!(
            "the texel in column {column} from the left, row {row} from the top, both from 0, is \
             {:?}; light is finite: write the file again with numbers there, such as the largest that the scene needs",
            colors[at]
        ));
    }
    let is_grey = colors.iter().all(|[r, g, b]| r == g && g == b);
    let (mut count, mut lowest) = (0_u32, 0.0_f32);
    for value in colors.as_flattened_mut().iter_mut().filter(|value| **value < 0.0) {
        count += 1;
        lowest = lowest.min(*value);
        *value = 0.0;
    }
    let count = if is_grey { count / 3 } else { count };
    let note = match count {
        0 => None,
        1 => Some(format!("1 value below 0, {lowest}, is taken as 0")),
        count => Some(format!("{count} values below 0, the lowest {lowest}, are taken as 0")),
    };
    Ok(texels.with_notes(note))
}
