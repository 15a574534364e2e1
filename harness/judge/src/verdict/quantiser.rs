//! How display values from 0 to 1 become integers.

/// The integer that is taken for a display value; N is the largest one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Quantiser {
    /// The nearest of N times the value.
    Rounded,
    /// The largest not above N + `surplus` times the value, at most N: `int(255.99 * v)` has a surplus of 0.99.
    Truncated {
        /// From 0 to 1, or that of [`Quantiser::ALMOST_ONE`].
        surplus: f64,
    },
}

impl Quantiser {
    /// Those that programs use, the most usual first.
    pub const ALL: [Self; 5] = [
        Self::Rounded,
        Self::Truncated { surplus: 0.0 },
        Self::Truncated { surplus: 0.99 },
        Self::Truncated { surplus: 0.999 },
        Self::Truncated { surplus: 1.0 },
    ];

    /// Truncated, where the largest display value is a little less than 1: sRGB's 1.055 − 0.055 in double precision.
    pub const ALMOST_ONE: Self = Self::Truncated { surplus: -1e-9 };

    /// The integer of a display value from 0 to 1.
    pub fn integer(self, value: f64, largest: f64) -> f64 {
        match self {
            Self::Rounded => (largest * value).round(),
            Self::Truncated { .. } => (self.scale(largest) * value).floor().min(largest),
        }
    }

    /// The middle of the display values that become an integer. Black is black, and the largest integer is all that is 1
    /// or more.
    pub fn middle(self, integer: f64, largest: f64) -> f64 {
        match self {
            Self::Truncated { .. } if integer > 0.0 && integer < largest => {
                (integer + 0.5) / self.scale(largest)
            }
            _ => integer / largest,
        }
    }

    /// The number of integers from the display value 0 to 1.
    pub fn scale(self, largest: f64) -> f64 {
        match self {
            Self::Rounded => largest,
            Self::Truncated { surplus } => largest + surplus,
        }
    }

    /// In words, for integers up to `largest`.
    pub fn words(self, largest: f64) -> String {
        let bits = if largest < 256.0 { 8 } else { 16 };
        match self {
            Self::Rounded => format!("rounded to {bits} bits"),
            Self::Truncated { surplus: ..=0.0 } => format!("truncated to {bits} bits"),
            Self::Truncated { .. } => {
                format!("times {} and truncated to {bits} bits", self.scale(largest))
            }
        }
    }
}
