//! From radiance to the colours of a screen (Suffern, ch. 3 and 14).

use std::fmt;

use crate::rgb::Rgb;

/// What becomes of a colour with a channel above 1.
#[kind(Default)]
#[schemars(title = "out of gamut rules")]
pub enum OutOfGamut {
    /// Divided by its largest channel, which keeps its hue.
    #[default]
    MaxToOne,
    /// Shown as red, so that it can be seen.
    ClampToColor,
}

/// How radiance is shown. The order is the book's: out-of-gamut first, then gamma.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tone {
    /// Multiplies the radiance first; 1 shows the picture as it is.
    pub exposure: f64,
    /// The shown value is the radiance to the power of 1/gamma.
    pub gamma: f64,
    /// What becomes of a colour with a channel above 1.
    pub out_of_gamut: OutOfGamut,
}

/// `exposure 2, gamma 2.2, max_to_one`.
impl fmt::Display for Tone {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let rule = match self.out_of_gamut {
            OutOfGamut::MaxToOne => "max_to_one",
            OutOfGamut::ClampToColor => "clamp_to_color",
        };
        write!(f, "exposure {}, gamma {}, {rule}", self.exposure, self.gamma)
    }
}

impl Tone {
    /// Shows values that are already those of a screen.
    pub const PLAIN: Self = Self { exposure: 1.0, gamma: 1.0, out_of_gamut: OutOfGamut::MaxToOne };

    /// Shows radiance on a usual screen.
    pub const SCREEN: Self = Self { gamma: 2.2, ..Self::PLAIN };

    /// A screen colour with channels in `[0, 1]`.
    pub fn map(&self, radiance: Rgb) -> Rgb {
        let color = self.exposure * radiance;
        let largest = color.max();
        let color = match self.out_of_gamut {
            OutOfGamut::MaxToOne if largest > 1.0 => color / largest,
            OutOfGamut::ClampToColor if largest > 1.0 => Rgb::new(1.0, 0.0, 0.0),
            _ => color,
        };
        if self.gamma == 1.0 { color } else { color.powc(1.0 / self.gamma) }
    }

    /// The screen colour in 8 bits, rounded to nearest. (The book truncates.)
    pub fn to_bytes(&self, radiance: Rgb) -> [u8; 3] {
        // the cast saturates; a NaN becomes 0
        self.map(radiance).to_array().map(|c| (c * 255.0).round() as u8)
    }
}
