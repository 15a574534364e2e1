//! How the values of a picture were stored, so that our replicas can be stored alike before they are compared.

use std::fmt;

use groundtruth::film::{Film, OutOfGamut, Tone};
use groundtruth::math::power_of_two;
use groundtruth::rgb::Rgb;

use super::quantiser::Quantiser;
use pictures::compare::{Picture, Transfer};

/// How values are stored.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Stored {
    /// As integers for display.
    Integers {
        /// The distance between neighbours: 1/255 or 1/65535.
        step: f64,
        /// How they encode radiance.
        transfer: Transfer,
        /// Which integer was taken.
        quantiser: Quantiser,
        /// What became of colours beyond 1.
        bright: Bright,
    },
    /// As binary floating-point numbers of radiance with this many significant bits: 24, or 11 for half precision.
    Floats {
        /// 24, or 11 for half precision.
        bits: u32,
    },
    /// As three integers of 8 bits and one exponent (Ward, "Real Pixels", 1991).
    SharedExponent,
}

/// What became of a colour with a channel above 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bright {
    /// Its channels above 1 are 1.
    Clamped,
    /// As the scene's picture says.
    Mapped(OutOfGamut),
}

impl Bright {
    /// What becomes of a colour, before channels are clamped.
    fn shown(self, color: Rgb) -> Rgb {
        let Self::Mapped(out_of_gamut) = self else { return color };
        Tone { exposure: 1.0, gamma: 1.0, out_of_gamut }.map(color)
    }
}

/// Relative differences up to this are rounding of the renderers, in floating-point pictures.
const ROUNDING: f64 = 1e-5;

/// The part of an interval by which the mean of values may be off: thresholds of others lie a little beside ours.
const UNKNOWN: f64 = 0.1;

impl Stored {
    /// The ways in which the values of a picture may be stored, the likeliest first. Display values say little of
    /// themselves: `transfer` is what the user or the file says of them, `gamma` what the scene's picture has.
    pub fn candidates(
        picture: &Picture,
        transfer: Option<Transfer>,
        (gamma, rule): (f64, OutOfGamut),
    ) -> Vec<Self> {
        let Some(step) = picture.step else {
            return vec![match significant_bits(picture) {
                0..=8 => Self::SharedExponent,
                9..=11 => Self::Floats { bits: 11 },
                _ => Self::Floats { bits: 24 },
            }];
        };
        let own = if gamma == 1.0 { Transfer::Linear } else { Transfer::Gamma(gamma) };
        let usual = [own, Transfer::Srgb, Transfer::Linear].into_iter();
        let usual = || usual.chain([1.8, 2.0, 2.2, 2.4].map(Transfer::Gamma)).collect();
        let transfers: Vec<Transfer> = transfer.map_or_else(usual, |stated| vec![stated]);
        let mut bright = vec![Bright::Mapped(rule), Bright::Clamped];
        bright.extend([OutOfGamut::MaxToOne, OutOfGamut::ClampToColor].map(Bright::Mapped));
        let mut all: Vec<Self> = Vec::new();
        // whether the largest integer in it is one below the largest possible
        let values = picture.values.as_flattened().iter().filter(|value| value.is_finite());
        let largest = values.fold(0.0_f64, |largest, value| largest.max((*value).into()));
        let is_white_less = (largest / step).round() + 1.0 == (1.0 / step).round();
        for transfer in transfers {
            let almost =
                (is_white_less && transfer == Transfer::Srgb).then_some(Quantiser::ALMOST_ONE);
            for bright in &bright {
                for quantiser in almost.into_iter().chain(Quantiser::ALL) {
                    let stored = Self::Integers { step, transfer, quantiser, bright: *bright };
                    if !all.contains(&stored) {
                        all.push(stored);
                    }
                }
            }
        }
        all
    }

    /// The radiance of our picture's values, as it is read back if it is stored like this: three channels a pixel, row
    /// by row from the top left.
    pub fn values(self, film: &Film) -> Vec<f32> {
        self.of_colors(film.pixels())
    }

    /// The same of each of several.
    pub(super) fn all(self, films: &[Film]) -> Vec<Vec<f32>> {
        films.iter().map(|film| self.values(film)).collect()
    }

    /// The same of some colours.
    pub fn of_colors(self, colors: &[Rgb]) -> Vec<f32> {
        colors.iter().flat_map(|color| self.color(*color)).collect()
    }

    /// Our picture, its colours above 1 as the rule for them makes them, and without negative values, which no integers hold.
    pub fn mapped(self, film: &Film) -> Film {
        let Self::Integers { bright, .. } = self else { return film.clone() };
        let mut mapped = film.clone();
        for at in (0..film.height()).flat_map(|y| (0..film.width()).map(move |x| [x, y])) {
            // filters with negative lobes make negative radiance
            let values = bright.shown(film.get(at)).to_array().map(|value| value.max(0.0));
            mapped.set(at, Rgb::from(values));
        }
        mapped
    }

    /// How integers encode radiance.
    pub fn transfer(self) -> Option<Transfer> {
        let Self::Integers { transfer, .. } = self else { return None };
        Some(transfer)
    }

    fn color(self, color: Rgb) -> [f32; 3] {
        match self {
            Self::Floats { bits } => color.to_array().map(|value| rounded(value as f32, bits)),
            Self::SharedExponent => {
                let values = color.to_array();
                let unit = unit_of(values);
                values.map(|value| ((value.max(0.0) / unit).floor() * unit) as f32)
            }
            Self::Integers { .. } => {
                let integers = self.integers(color).unwrap_or_default();
                integers.map(|integer| self.of_integer(integer) as f32)
            }
        }
    }

    /// The integers of a colour; `None` if values are stored as other numbers.
    pub fn integers(self, color: Rgb) -> Option<[f64; 3]> {
        let Self::Integers { step, transfer, quantiser, bright } = self else { return None };
        let largest = 1.0 / step;
        let integer = |radiance: f64| {
            // sRGB of 1 is computed as a little less than 1
            let value = if radiance >= 1.0 { 1.0 } else { transfer.encoded(radiance.max(0.0)) };
            quantiser.integer(value, largest)
        };
        Some(bright.shown(color).to_array().map(integer))
    }

    /// The radiance of a stored value.
    pub fn read(self, value: f32) -> f32 {
        let Self::Integers { step, .. } = self else { return value };
        let exact = f64::from(value) / step;
        let integer = exact.round();
        // values of a changed picture lie between integers
        let is_integer = (exact - integer).abs() < 0.01;
        self.of_integer(if is_integer { integer } else { exact }) as f32
    }

    /// The radiance of a stored integer: the middle, by its display value, of all that is stored so.
    fn of_integer(self, integer: f64) -> f64 {
        let Self::Integers { step, transfer, quantiser, .. } = self else { return integer };
        transfer.decoded(quantiser.middle(integer, 1.0 / step))
    }

    /// The largest radiance that can be stored.
    pub fn largest(self) -> f64 {
        if matches!(self, Self::Integers { .. }) { 1.0 } else { f64::INFINITY }
    }

    /// The standard deviation of the rounding of a value.
    pub fn rounding(self, value: f64) -> f64 {
        // of an error that is evenly spread over an interval of this length
        self.interval(value) / 12.0_f64.sqrt()
    }

    /// How far two values may be apart that stand for the same radiance.
    pub fn tolerance(self, value: f64) -> f64 {
        // a renderer's own rounding may take a value over the border of its interval
        1.001 * self.to_next(value) + ROUNDING * value.abs()
    }

    /// How far the mean over some values of ours may be from that of a correct picture, because of rounding alone: for each
    /// value of a picture of ours, the distance of the values between which its renderer's rounding decides, and the part of
    /// an interval by which an unknown way of rounding may be off.
    pub fn slack(self, film: &Film) -> Vec<f64> {
        let moved = |color: &Rgb, by: f64| self.color((1.0 + by * ROUNDING) * *color);
        let of_color = |color: &Rgb| {
            let [low, high] = [-1.0, 1.0].map(|by| moved(color, by));
            [0, 1, 2].map(|channel| {
                let [low, high] = [low, high].map(|color| f64::from(color[channel]));
                high - low + UNKNOWN * self.interval(low)
            })
        };
        film.pixels().iter().flat_map(of_color).collect()
    }

    /// The distance of a value from the farther of its neighbours that can be stored.
    fn to_next(self, value: f64) -> f64 {
        let Self::Integers { step, transfer, quantiser, .. } = self else {
            return self.interval(value);
        };
        let largest = 1.0 / step;
        let integer = quantiser.integer(transfer.encoded(value.clamp(0.0, 1.0)), largest);
        let [below, here, above] = [integer - 1.0, integer, integer + 1.0]
            .map(|integer| self.of_integer(integer.clamp(0.0, largest.round())));
        (above - here).max(here - below)
    }

    /// The length of the interval of radiance that is stored as one value.
    fn interval(self, value: f64) -> f64 {
        match self {
            Self::Integers { step, transfer, quantiser, .. } => {
                let middle = transfer.encoded(value.clamp(0.0, 1.0));
                let half = 0.5 / quantiser.scale(1.0 / step);
                let [low, high] =
                    [-half, half].map(|half| transfer.decoded((middle + half).max(0.0)));
                high - low
            }
            Self::Floats { bits: 24 } => ROUNDING * value.abs(),
            Self::Floats { bits } => value.abs() * f64::from(2_u32.pow(bits - 1)).recip(),
            // of its own magnitude; smaller channels of a colour have larger ones
            Self::SharedExponent => value.abs() / 128.0,
        }
    }
}

impl fmt::Display for Stored {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Floats { bits: 24 } => f.write_str("radiance, in single precision"),
            Self::Floats { .. } => f.write_str("radiance, in half precision"),
            Self::SharedExponent => f.write_str("radiance, with a shared exponent"),
            Self::Integers { step, transfer, quantiser, bright } => {
                let rounding = quantiser.words(1.0 / step);
                let bright = match bright {
                    Bright::Clamped => "channels above 1 clamped",
                    Bright::Mapped(OutOfGamut::MaxToOne) => {
                        "colours above 1 divided by their largest channel"
                    }
                    Bright::Mapped(OutOfGamut::ClampToColor) => "colours above 1 shown as red",
                };
                write!(f, "{transfer}, {rounding}, {bright}")
            }
        }
    }
}

/// The value of the last bit of the largest channel, for a shared exponent.
fn unit_of(values: [f64; 3]) -> f64 {
    // of black, small enough
    let largest = values.into_iter().fold(power_of_two(-1000), f64::max);
    let exponent = (largest.to_bits() >> 52) as i32 - 1023;
    power_of_two(exponent - 7)
}

/// The nearest number with so many significant bits, halves away from 0.
fn rounded(value: f32, bits: u32) -> f32 {
    if bits == 24 || !value.is_finite() {
        return value;
    }
    let cut = 24 - bits;
    f32::from_bits((value.to_bits() + (1 << (cut - 1))) >> cut << cut)
}

/// The fewest significant bits that hold all values of a picture.
fn significant_bits(picture: &Picture) -> u32 {
    let bits = |value: &f32| 24 - value.to_bits().trailing_zeros().min(23);
    let values = picture.values.as_flattened().iter();
    values.filter(|value| **value != 0.0).map(bits).max().unwrap_or(24)
}
