//! A picture to be compared: its stored values, and what they mean.

use std::ops::RangeInclusive;
use std::path::Path;
use std::str::FromStr;

use formats::images::{self, Curve, ImageFileError, Stored};
use groundtruth::film::Film;
use groundtruth::math::power;
use groundtruth::world::MAX_PIXELS;

/// How display values encode radiance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Transfer {
    /// They are proportional to radiance.
    Linear,
    /// The curve of sRGB (IEC 61966-2-1).
    Srgb,
    /// Radiance is the value to this power.
    Gamma(f64),
}

impl Transfer {
    /// What a file says, if it is read.
    fn of(curve: Curve) -> Option<Self> {
        match curve {
            Curve::Srgb => Some(Self::Srgb),
            Curve::Gamma(1.0) => Some(Self::Linear),
            Curve::Gamma(gamma) => Some(Self::Gamma(gamma)),
            Curve::Unread(_) => None,
        }
    }

    /// The option of a command line that says it, after a space; nothing if it was not said.
    pub fn option(said: Option<Self>) -> String {
        match said {
            None => String::new(),
            Some(Self::Srgb) => " --encoding srgb".to_owned(),
            Some(Self::Linear) => " --encoding linear".to_owned(),
            Some(Self::Gamma(gamma)) => format!(" --encoding gamma={gamma}"),
        }
    }

    /// The radiance of a display value.
    pub fn decoded(self, value: f64) -> f64 {
        match self {
            Self::Linear => value,
            Self::Srgb if value <= 0.04045 => value / 12.92,
            Self::Srgb => power((value + 0.055) / 1.055, 2.4),
            Self::Gamma(gamma) => power(value.max(0.0), gamma),
        }
    }

    /// The display value of a radiance.
    pub fn encoded(self, radiance: f64) -> f64 {
        match self {
            Self::Linear => radiance,
            Self::Srgb if radiance <= 0.0031308 => 12.92 * radiance,
            Self::Srgb => 1.055 * power(radiance, 1.0 / 2.4) - 0.055,
            Self::Gamma(gamma) => power(radiance.max(0.0), 1.0 / gamma),
        }
    }
}

impl std::fmt::Display for Transfer {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Linear => f.write_str("linear"),
            Self::Srgb => f.write_str("sRGB"),
            Self::Gamma(gamma) => write!(f, "gamma {gamma}"),
        }
    }
}

/// `srgb`, `linear`, or `gamma=2.2`.
impl FromStr for Transfer {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let gamma = text.strip_prefix("gamma=").and_then(|number| number.parse::<f64>().ok());
        match (text, gamma) {
            ("srgb", _) => Ok(Self::Srgb),
            ("linear", _) => Ok(Self::Linear),
            (_, Some(gamma)) if GAMMAS.contains(&gamma) => Ok(Self::Gamma(gamma)),
            (_, Some(gamma)) => Err(format!("no display has gamma {gamma}; write one {ALLOWED}")),
            _ => Err("write srgb, linear or gamma=2.2".to_owned()),
        }
    }
}

/// The gammas that a display may have; those of the files of real programs lie far inside.
const GAMMAS: RangeInclusive<f64> = 0.1..=10.0;

/// They in words.
const ALLOWED: &str = "from 0.1 to 10";

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
}

impl Picture {
    /// A picture of radiance.
    pub fn of_film(film: &Film) -> Self {
        let (size, transfer) = ([film.width(), film.height()], Transfer::Linear);
        Self {
            size,
            values: film.to_f32().collect(),
            transfer,
            stated: None,
            step: None,
            notes: Vec::new(),
            transparent: 0,
        }
    }

    /// A picture of radiance: three values a pixel, row by row from the top left.
    pub fn of_radiance(values: &[f32], size: [u32; 2]) -> Self {
        let (values, transfer) = (values.as_chunks::<3>().0.to_vec(), Transfer::Linear);
        Self { size, values, transfer, stated: None, step: None, notes: Vec::new(), transparent: 0 }
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
        if let (Some(Curve::Gamma(gamma)), None) = (stored.curve, said)
            && !GAMMAS.contains(&gamma)
        {
            let problem = format!(
                "its chunk gAMA says gamma {gamma}, which no display has: it is {ALLOWED}; --encoding says how its \
                 values are encoded"
            );
            return Err(ImageFileError { path: path.to_owned(), problem, field: "encoding" });
        }
        let texels = stored.texels;
        let (size, values) = ([texels.width(), texels.height()], texels.colors().to_vec());
        let (mut notes, transparent) = (texels.notes().to_vec(), texels.transparent());
        let (stated, step) = match stored.is_linear {
            true => (Some(Transfer::Linear), None),
            false => (said.or(stored.curve.and_then(Transfer::of)), Some(step_of(&values))),
        };
        notes.extend(stored.curve.and_then(|curve| note(curve, said)));
        let transfer = stated.unwrap_or(Transfer::Srgb);
        Ok(Self { size, values, transfer, stated, step, notes, transparent })
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

/// What a file says of its transfer function and the user does not.
fn note(curve: Curve, said: Option<Transfer>) -> Option<String> {
    let of_file = Transfer::of(curve);
    match (of_file, curve, said) {
        (Some(of_file), _, Some(said)) if of_file != said => {
            Some(format!("it says {of_file}; --encoding counts"))
        }
        (Some(of_file), _, None) => Some(format!("its transfer function is {of_file}, as it says")),
        (None, Curve::Unread(kind), None) => Some(format!(
            "its transfer function is in a chunk {kind}, which is not read; --encoding says it"
        )),
        _ => None,
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
