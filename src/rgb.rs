//! Colours: linear radiance and reflectance, unbounded.

use std::borrow::Cow;
use std::fmt;
use std::iter::Sum;
use std::ops::{Add, AddAssign, Div, Mul, Sub};

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{self, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize};

use crate::invalid::{BRIGHTEST, Invalid, shown};
use crate::math::{exp, power};

/// Red, green and blue, linear. In scene files `[r, g, b]`, or one number for a grey.
#[derive(Clone, Copy, Debug, PartialEq, Default, Serialize)]
#[serde(into = "[f64; 3]")]
pub struct Rgb {
    /// Red.
    pub r: f64,
    /// Green.
    pub g: f64,
    /// Blue.
    pub b: f64,
}

impl Rgb {
    /// No light.
    pub const BLACK: Self = Self::grey(0.0);
    /// One in each channel.
    pub const WHITE: Self = Self::grey(1.0);

    /// The colour with these channels.
    pub const fn new(r: f64, g: f64, b: f64) -> Self {
        Self { r, g, b }
    }

    /// The same value in each channel.
    pub const fn grey(value: f64) -> Self {
        Self::new(value, value, value)
    }

    /// The channels.
    pub fn to_array(self) -> [f64; 3] {
        [self.r, self.g, self.b]
    }

    /// A function applied to each channel.
    pub fn map(self, f: impl Fn(f64) -> f64) -> Self {
        Self::new(f(self.r), f(self.g), f(self.b))
    }

    /// Each channel to a power, the book's `powc`.
    pub fn powc(self, exponent: f64) -> Self {
        self.map(|c| power(c, exponent))
    }

    /// The mean of the channels.
    pub fn average(self) -> f64 {
        (self.r + self.g + self.b) / 3.0
    }

    /// The largest channel.
    pub fn max(self) -> f64 {
        self.r.max(self.g).max(self.b)
    }

    /// Whether every channel is zero.
    pub fn is_black(self) -> bool {
        self == Self::BLACK
    }

    /// What a medium of absorption `self` (per unit length, `σ = −ln` of the book's colour filter)
    /// lets through over a distance: `exp(−σ t)`. It is 1 wherever σ or t is 0, also against ∞.
    pub fn transmittance(self, distance: f64) -> Self {
        self.map(|sigma| match sigma == 0.0 || distance == 0.0 {
            true => 1.0,
            false => exp(-sigma * distance),
        })
    }

    /// `self`, if it can be a reflectance or radiance: every channel is from 0 to [`BRIGHTEST`].
    pub(crate) fn checked(self, field: &str) -> Result<Self, Invalid> {
        if self.not_negative(field)?.max() <= BRIGHTEST {
            return Ok(self);
        }
        let found = self.to_array().map(shown).join(", ");
        let problem = format!("found [{found}], but channels of at most {} fit", shown(BRIGHTEST));
        Err(Invalid::field(field, problem))
    }

    /// `self`, if every channel is finite and not negative.
    pub(crate) fn not_negative(self, field: &str) -> Result<Self, Invalid> {
        if self.to_array().iter().all(|c| c.is_finite() && *c >= 0.0) {
            return Ok(self);
        }
        let found = self.to_array();
        let problem =
            format!("found {found:?}, but a colour of finite numbers of at least 0 is needed");
        Err(Invalid::field(field, problem))
    }
}

impl From<Rgb> for [f64; 3] {
    fn from(c: Rgb) -> Self {
        c.to_array()
    }
}

impl From<[f64; 3]> for Rgb {
    fn from([r, g, b]: [f64; 3]) -> Self {
        Self::new(r, g, b)
    }
}

impl Add for Rgb {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::new(self.r + other.r, self.g + other.g, self.b + other.b)
    }
}

impl AddAssign for Rgb {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl Sub for Rgb {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self::new(self.r - other.r, self.g - other.g, self.b - other.b)
    }
}

impl Sum for Rgb {
    fn sum<I: Iterator<Item = Self>>(terms: I) -> Self {
        terms.fold(Self::BLACK, Add::add)
    }
}

impl Mul for Rgb {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self::new(self.r * other.r, self.g * other.g, self.b * other.b)
    }
}

impl Mul<Rgb> for f64 {
    type Output = Rgb;
    fn mul(self, c: Rgb) -> Rgb {
        c.map(|channel| self * channel)
    }
}

impl Div<f64> for Rgb {
    type Output = Self;
    fn div(self, a: f64) -> Self {
        self.map(|channel| channel / a)
    }
}

impl JsonSchema for Rgb {
    fn schema_name() -> Cow<'static, str> {
        "Colour".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        let channel = json_schema!({ "type": "number", "minimum": 0 });
        json_schema!({
            "description": "Red, green and blue as `[r, g, b]`, or one number for a grey. Each is at \
                least 0 and linear: twice the number is twice the light. Reflectances are from 0 to \
                1; light may be above.",
            "anyOf": [
                channel,
                { "type": "array", "items": channel, "minItems": 3, "maxItems": 3 },
            ],
        })
    }
}

impl<'de> Deserialize<'de> for Rgb {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(ColorVisitor)
    }
}

/// Reads `[r, g, b]` or a grey value.
struct ColorVisitor;

impl<'de> Visitor<'de> for ColorVisitor {
    type Value = Rgb;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a colour: [r, g, b], or one number for a grey")
    }

    fn visit_f64<E: de::Error>(self, grey: f64) -> Result<Rgb, E> {
        Ok(Rgb::grey(grey))
    }

    fn visit_i64<E: de::Error>(self, grey: i64) -> Result<Rgb, E> {
        Ok(Rgb::grey(grey as f64))
    }

    fn visit_u64<E: de::Error>(self, grey: u64) -> Result<Rgb, E> {
        Ok(Rgb::grey(grey as f64))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<Rgb, A::Error> {
        let mut channels = [0.0; 3];
        for (i, channel) in channels.iter_mut().enumerate() {
            *channel = seq.next_element()?.ok_or_else(|| de::Error::invalid_length(i, &self))?;
        }
        if seq.next_element::<de::IgnoredAny>()?.is_some() {
            return Err(de::Error::invalid_length(4, &self));
        }
        Ok(channels.into())
    }
}
