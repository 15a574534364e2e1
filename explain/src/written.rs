//! The formula of a lobe in the book's letters, with the numbers of one recorded term.

use std::f64::consts::PI;

use groundtruth::lobes::{GlossyReflection, GlossyRule, Lobe};
use groundtruth::math::power;
use groundtruth::rgb::Rgb;

/// What is recorded of a lobe's part in a term.
#[derive(Clone, Copy)]
pub(super) enum Scattered {
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
    /// The `η` of a factor `1/η²`, if there is one.
    fn scaling(self) -> Option<f64> {
        match self {
            Self::Single { eta, .. } => Some(eta).filter(|eta| *eta != 1.0),
            Self::Lit(_) | Self::Drawn(_) => None,
        }
    }

    /// It as a multiple of the lobe's reflectance, which is not black.
    fn over(self, reflectance: Rgb) -> f64 {
        let (Self::Lit(value) | Self::Drawn(value) | Self::Single { weight: value, .. }) = self;
        // the same in each channel: the largest has the most digits
        value.max() / reflectance.max()
    }
}

/// What is recorded of a lobe as a product, in the book's letters and with its numbers.
pub(super) fn written(lobe: &Lobe, of: Scattered) -> Vec<Factor> {
    match lobe {
        Lobe::Lambertian(lobe) => {
            let mut factors = vec![Factor::color("k_d c_d", lobe.reflectance)];
            if let Scattered::Drawn(_) = of {
                factors.push(Factor::number("cos θ_i", PI * of.over(lobe.reflectance)));
            }
            factors.push(Factor::over_pi());
            factors
        }
        Lobe::GlossySpecular(lobe) => {
            let share = of.over(lobe.reflectance);
            vec![Factor::color("k_s c_s", lobe.reflectance), highlight(of, share, lobe.exponent)]
        }
        Lobe::PerfectSpecular(lobe) => vec![Factor::color("k_r c_r", lobe.reflectance)],
        Lobe::GlossyReflection(lobe) => glossy_reflection(lobe, of),
        Lobe::PerfectTransmitter(lobe) => refracted(lobe.transmittance, of),
        Lobe::FresnelReflector(_) => vec![Factor::number("k_r", of.over(Rgb::WHITE))],
        Lobe::FresnelTransmitter(_) => {
            let eta = of.scaling().unwrap_or(1.0);
            refracted(eta * eta * of.over(Rgb::WHITE), of)
        }
    }
}

fn glossy_reflection(lobe: &GlossyReflection, of: Scattered) -> Vec<Factor> {
    let share = of.over(lobe.reflectance);
    let mut factors = vec![Factor::color("k_r c_r", lobe.reflectance)];
    let scale = (lobe.exponent + 2.0) / (2.0 * PI);
    match (lobe.rule, of) {
        (GlossyRule::Book, Scattered::Lit(_)) => {
            factors.push(Factor::number("p(ω_i)/cos θ_i", share));
        }
        (GlossyRule::Book, _) => factors.push(Factor::number("p(ω_i)", share)),
        (GlossyRule::Normalised, _) => factors.extend([
            Factor::number("(e + 2)/2π", scale),
            highlight(of, share / scale, lobe.exponent),
        ]),
    }
    factors
}

/// The power of a highlight, which has this value, perhaps times the cosine.
fn highlight(of: Scattered, value: f64, exponent: f64) -> Factor {
    match of {
        Scattered::Lit(_) => Factor::power("(r·ω_o)^e", value, exponent),
        _ => Factor::number("(r·ω_o)^e cos θ_i", value),
    }
}

/// The share of light that is refracted, and the `1/η²` of radiance if the weight has it.
fn refracted(share: f64, of: Scattered) -> Vec<Factor> {
    let scaling = of.scaling().map(|eta| Factor::divisor("η²", eta * eta));
    [Factor::number("k_t", share)].into_iter().chain(scaling).collect()
}

impl Factor {
    /// A factor that is a colour.
    pub(super) fn color(symbol: &'static str, value: Rgb) -> Self {
        let [r, g, b] = value.to_array().map(|x| digits(x, DIGITS));
        let is_grey = value == Rgb::grey(value.r);
        let number = if is_grey { r } else { format!("({r}, {g}, {b})") };
        Self { symbol, number, value, divides: false }
    }

    /// A factor that is a number.
    pub(super) fn number(symbol: &'static str, value: f64) -> Self {
        Self::color(symbol, Rgb::grey(value))
    }

    /// A number that the term is divided by.
    pub(super) fn divisor(symbol: &'static str, value: f64) -> Self {
        Self { divides: true, ..Self::number(symbol, value) }
    }

    /// The division by π.
    fn over_pi() -> Self {
        Self { number: "π".to_owned(), ..Self::divisor("π", std::f64::consts::PI) }
    }

    /// A power of this value, written with its base, in so many digits that the power has its own.
    fn power(symbol: &'static str, value: f64, exponent: f64) -> Self {
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
