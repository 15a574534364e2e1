//! How display values encode radiance: what a file says of it, and what its reader says.

use std::ops::RangeInclusive;
use std::str::FromStr;

use libm::pow;

use super::{Encoding, Problem};

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
    /// That of a gamma; of gamma 1, linear.
    pub(super) fn of_gamma(gamma: f64) -> Self {
        if gamma == 1.0 { Self::Linear } else { Self::Gamma(gamma) }
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
            Self::Srgb => pow((value + 0.055) / 1.055, 2.4),
            Self::Gamma(gamma) => pow(value.max(0.0), gamma),
        }
    }

    /// The display value of a radiance.
    pub fn encoded(self, radiance: f64) -> f64 {
        match self {
            Self::Linear => radiance,
            Self::Srgb if radiance <= 0.0031308 => 12.92 * radiance,
            Self::Srgb => 1.055 * pow(radiance, 1.0 / 2.4) - 0.055,
            Self::Gamma(gamma) => pow(radiance.max(0.0), 1.0 / gamma),
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

impl From<Encoding> for Transfer {
    fn from(encoding: Encoding) -> Self {
        match encoding {
            Encoding::Srgb => Self::Srgb,
            Encoding::Linear => Self::Linear,
        }
    }
}

/// What a file says of its transfer function.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Curve {
    /// It is this one.
    Is(Transfer),
    /// A chunk of this kind, which is not read.
    Unread(&'static str),
}

/// The transfer function of a file that is read for a picture or for a texture: what the reader says by this option,
/// else what the file says, if one of them says it; and a note on what the file says.
///
/// # Errors
/// The file says a gamma that no display has, and the reader says nothing.
pub fn settled(
    curve: Option<Curve>,
    said: Option<Transfer>,
    option: &str,
) -> Result<(Option<Transfer>, Option<String>), Problem> {
    let Some(curve) = curve else { return Ok((said, None)) };
    match (curve, said) {
        (Curve::Is(of_file), Some(said)) => {
            let note = (of_file != said).then(|| format!("it says {of_file}; {option} counts"));
            Ok((Some(said), note))
        }
        (Curve::Is(Transfer::Gamma(gamma)), None) if !GAMMAS.contains(&gamma) => Err(format!(
            "its chunk gAMA says gamma {gamma}, which no display has: it is {ALLOWED}; {option} says how its values \
             are encoded"
        )),
        (Curve::Is(of_file), None) => Ok((
            Some(of_file),
            Some(format!("the transfer function is {of_file}, as the file says")),
        )),
        (Curve::Unread(_), Some(said)) => Ok((Some(said), None)),
        (Curve::Unread(kind), None) => {
            let note = format!(
                "the transfer function is in a chunk {kind}, which is not read; {option} says it"
            );
            Ok((None, Some(note)))
        }
    }
}
