//! The formula of a lobe in the book's letters, with the numbers of one recorded term.

use crate::math::power;
use crate::rgb::Rgb;

/// What is recorded of a lobe's part in a term.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Scattered {
    /// Its value for a light's sample, `f`, per steradian.
    Lit(Rgb),
    /// `f cos θ_i` for a direction that it drew, per steradian.
    Drawn(Rgb),
    /// What light from its single direction counts.
    Single {
        /// The weight of that light.
        weight: Rgb,
        /// For a refracted direction, the `η` of the weight's factor `1/η²`; 1 where it has none.
        eta: f64,
    },
}

/// A factor of a term.
#[derive(Clone, Debug, PartialEq)]
pub struct Factor {
    /// In the book's letters, as `k_d c_d`.
    pub symbol: &'static str,
    /// The same with numbers of some six digits, as `(0.8, 0.4, 0.1)` or `0.98^20`.
    pub number: String,
    /// What the term is multiplied by, or divided by.
    pub value: Rgb,
    /// Whether the term is divided by it.
    pub divides: bool,
}

impl Scattered {
    /// It as a multiple of the lobe's reflectance, which is not black.
    pub(super) fn over(self, reflectance: Rgb) -> f64 {
        let (Self::Lit(value) | Self::Drawn(value) | Self::Single { weight: value, .. }) = self;
        // the same in each channel: the largest has the most digits
        value.max() / reflectance.max()
    }
}

impl Factor {
    /// A factor that is a colour.
    pub fn color(symbol: &'static str, value: Rgb) -> Self {
        let [r, g, b] = value.to_array().map(|x| digits(x, DIGITS));
        let is_grey = value == Rgb::grey(value.r);
        let number = if is_grey { r } else { format!("({r}, {g}, {b})") };
        Self { symbol, number, value, divides: false }
    }

    /// A factor that is a number.
    pub fn number(symbol: &'static str, value: f64) -> Self {
        Self::color(symbol, Rgb::grey(value))
    }

    /// A number that the term is divided by.
    pub fn divisor(symbol: &'static str, value: f64) -> Self {
        Self { divides: true, ..Self::number(symbol, value) }
    }

    /// The division by π.
    pub(super) fn over_pi() -> Self {
        Self { number: "π".to_owned(), ..Self::divisor("π", std::f64::consts::PI) }
    }

    /// A power of this value, written with its base, in so many digits that the power has its own.
    pub(super) fn power(symbol: &'static str, value: f64, exponent: f64) -> Self {
        /// An `f64` has hardly more.
        const MOST_DIGITS: usize = 15;
        let needed = DIGITS + format!("{exponent:.0}").len();
        let number = Self::number(symbol, value);
        if exponent == 0.0 || needed > MOST_DIGITS {
            return number;
        }
        let base = digits(power(value, 1.0 / exponent), needed);
        Self { number: format!("{base}^{exponent}"), ..number }
    }
}

/// The digits of a number that is not written as a power.
const DIGITS: usize = 6;

/// A number with this many digits, without zeros at its end.
fn digits(x: f64, count: usize) -> String {
    let rounded: f64 = format!("{x:.*e}", count - 1).parse().unwrap_or(x);
    match rounded.abs() {
        0.0 => "0".to_owned(),
        a if (1e-4..1e7).contains(&a) => format!("{rounded}"),
        _ => format!("{rounded:e}"),
    }
}
