//! A picture to be compared: its stored values, and what they mean.

use std::path::Path;

use formats::images::{self, ImageFileError, Stored};
use groundtruth::film::Film;
use groundtruth::world::MAX_PIXELS;

pub use formats::images::Transfer;

/// A picture, row by row from the top left.
#[derive(Clone, Debug)]
pub struct Picture {
    /// Columns and rows.
    pub size: [u32; 2],
    /// Its values as stored.
    pub values: Vec<[f32; 3]>,
    /// What they mean.
    pub transfer: Transfer,
    /// The transfer function that the user or the file states; if neither does, it is taken to be that of sRGB.
    pub stated: Option<Transfer>,
    /// The distance between neighbouring integers, if the values were stored as such.
    pub step: Option<f64>,
    /// What was ignored in its file.
    pub notes: Vec<String>,
    /// The number of pixels whose alpha, which is ignored, is below 1.
    pub transparent: u64,
    /// Of a JPEG, by how many steps the mean of a block of 16 × 16 pixels may be off ([`Stored::loss`]).
    pub loss: Option<f64>,
}

impl Picture {
    /// A picture of radiance.
    pub fn of_film(film: &Film) -> Self {
        Self::of_colors(film.to_f32().collect(), [film.width(), film.height()])
    }

    /// A picture of radiance: three values a pixel, row by row from the top left.
    pub fn of_radiance(values: &[f32], size: [u32; 2]) -> Self {
        Self::of_colors(values.as_chunks::<3>().0.to_vec(), size)
    }

    fn of_colors(values: Vec<[f32; 3]>, size: [u32; 2]) -> Self {
        let (transfer, notes, transparent, loss) = (Transfer::Linear, Vec::new(), 0, None);
        Self { size, values, transfer, stated: None, step: None, notes, transparent, loss }
    }

    /// Reads a PNG, JPEG, PPM, HDR, EXR or PFM file. Display values are taken to be encoded as the user said, else as
    /// the file says, else by the curve of sRGB.
    ///
    /// # Errors
    /// If it is no picture, or damaged, or says a gamma that no display has and the user says nothing.
    pub fn read(path: &Path, said: Option<Transfer>) -> Result<Self, ImageFileError> {
        Self::of_stored(images::read_stored(path, MAX_PIXELS)?, path, said)
    }

    /// As [`Self::read`], of the bytes of a file; `path` is for error messages.
    ///
    /// # Errors
    /// As [`Self::read`].
    pub fn from_bytes(
        bytes: &[u8],
        path: &Path,
        said: Option<Transfer>,
    ) -> Result<Self, ImageFileError> {
        Self::of_stored(images::stored(bytes, path, MAX_PIXELS)?, path, said)
    }

    fn of_stored(
        stored: Stored,
        path: &Path,
        said: Option<Transfer>,
    ) -> Result<Self, ImageFileError> {
        let wrong = |problem| ImageFileError { path: path.to_owned(), problem, field: "encoding" };
        let (said, note) = images::settled(stored.curve, said, "--encoding").map_err(wrong)?;
        let texels = stored.texels;
        let (size, values) = ([texels.width(), texels.height()], texels.colors().to_vec());
        let (mut notes, transparent) = (texels.notes().to_vec(), texels.transparent());
        let (stated, step) = match stored.is_linear {
            true => (Some(Transfer::Linear), None),
            false => (said, Some(step_of(&values))),
        };
        notes.extend(note);
        let transfer = stated.unwrap_or(Transfer::Srgb);
        Ok(Self { size, values, transfer, stated, step, notes, transparent, loss: stored.loss })
    }

    /// A picture of radiance from 0 to 1 as integers of 16 bits, linear.
    #[must_use]
    pub fn in_16_bits(mut self) -> Self {
        const LARGEST: f64 = 65535.0;
        for value in self.values.as_flattened_mut() {
            *value = ((f64::from(*value).clamp(0.0, 1.0) * LARGEST).round() / LARGEST) as f32;
        }
        Self { transfer: Transfer::Linear, step: Some(1.0 / LARGEST), ..self }
    }

    /// The radiance of its values.
    pub fn radiance(&self) -> Film {
        let [width, height] = self.size;
        let (mut film, decoded) = (Film::new(width, height), Decoded::new(self));
        for index in 0..self.values.len() {
            let at = [index as u32 % width, index as u32 / width];
            film.set(at, decoded.at(index).into());
        }
        film
    }

    /// The index of a pixel.
    pub fn index(&self, [x, y]: [u32; 2]) -> usize {
        y as usize * self.size[0] as usize + x as usize
    }
}

/// A picture whose values are decoded: from a table, because many pixels have the same integers.
pub struct Decoded<'a> {
    /// The picture.
    pub picture: &'a Picture,
    /// For each integer, the radiance that it may stand for at least, in the middle, and at most.
    table: Vec<[f64; 3]>,
}

impl<'a> Decoded<'a> {
    /// Makes the table.
    pub fn new(picture: &'a Picture) -> Self {
        let Some(step) = picture.step else { return Self { picture, table: Vec::new() } };
        let largest = (1.0 / step).round() as u32;
        let white = white(picture, largest);
        let radiance = |value: f64| picture.transfer.decoded((value * step).max(0.0));
        let entry = |integer: u32| {
            let value = f64::from(integer);
            // int(256 v) is value + 1 from value/256 on, and int(255.99 v) hardly later
            let least = (value - 0.5).min(value * f64::from(largest) / f64::from(largest + 1));
            // what is brighter is clamped to the largest
            let most = if integer < white { radiance(value + 1.0) } else { f64::INFINITY };
            [radiance(least), radiance(value), most]
        };
        Self { picture, table: (0..=largest).map(entry).collect() }
    }

    /// As [`Decoded::new`], with the radiance of each stored value as one reads it who knows more of how
    /// they were stored.
    pub fn read_by(picture: &'a Picture, radiance: impl Fn(f32) -> f64) -> Self {
        let mut decoded = Self::new(picture);
        let step = picture.step.unwrap_or(1.0);
        for (integer, entry) in decoded.table.iter_mut().enumerate() {
            entry[1] = radiance((integer as f64 * step) as f32);
        }
        decoded
    }

    /// The entry of a stored value.
    fn entry(&self, value: f32) -> [f64; 3] {
        match self.table.len() {
            0 => [f64::from(value); 3],
            count => {
                let integer = (f64::from(value) * (count - 1) as f64).round() as usize;
                self.table[integer.min(count - 1)]
            }
        }
    }

    /// The radiance that a stored value may stand for: of an integer, all that is rounded, truncated or, of
    /// the largest, clamped to it.
    pub fn interval(&self, value: f32) -> [f64; 2] {
        let [least, _, most] = self.entry(value);
        [least, most]
    }

    /// The radiance of a stored value: the middle of what is rounded to it.
    pub fn linear(&self, color: [f32; 3]) -> [f64; 3] {
        color.map(|value| self.entry(value)[1])
    }

    /// The radiance of the pixel of this index.
    pub fn at(&self, index: usize) -> [f64; 3] {
        self.linear(self.picture.values[index])
    }
}

/// The integer that stands for all values from 1 on: the largest, or the one below it if the picture is sRGB and has none
/// larger. In double precision, sRGB of 1 is 1.055 − 0.055, a little less than 1, and may have been truncated.
fn white(picture: &Picture, largest: u32) -> u32 {
    let half = 0.5 / f64::from(largest);
    let has_largest =
        || picture.values.as_flattened().iter().any(|value| f64::from(*value) > 1.0 - half);
    if picture.transfer == Transfer::Srgb && !has_largest() { largest - 1 } else { largest }
}

/// 1/255 if all values are multiples of it, else 1/65535.
fn step_of(values: &[[f32; 3]]) -> f64 {
    let is_byte = |value: &f32| {
        let byte = 255.0 * f64::from(*value);
        (byte - byte.round()).abs() < 1e-4
    };
    if values.as_flattened().iter().all(is_byte) { 1.0 / 255.0 } else { 1.0 / 65535.0 }
}
