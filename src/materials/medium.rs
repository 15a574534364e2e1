//! Media: what light travels through between surfaces (Suffern, ch. 27 and 28).

use crate::invalid::{Invalid, Ranges};
use crate::math::Index;
use crate::rgb::Rgb;

/// The medium on each side of a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Boundary {
    /// On the inner side, which the normal points away from.
    pub inside: Medium,
    /// On the side the normal points to.
    pub outside: Medium,
}

/// A transparent medium.
#[kind(Copy, Default, PartialEq)]
#[schemars(example = Medium { eta: 1.33, absorption: Rgb::new(0.25, 0.0, 0.0625) })]
pub struct Medium {
    /// The index of refraction, from 1e-10 to 1e10. Air is 1, water 1.33, glass about 1.5.
    #[default(1.0)]
    pub eta: Index,
    /// `σ` per unit length: the book's colour filter is `exp(−σ)`, so clear is 0. It may be
    /// infinite in code, not in a scene file.
    #[default]
    #[schemars(extend("x-dimension" = "1/length"))]
    pub absorption: Rgb,
}

impl Medium {
    /// A medium without absorption.
    pub const fn clear(eta: f64) -> Self {
        Self { eta, absorption: Rgb::BLACK }
    }

    pub(crate) fn checked(self, field: &str) -> Result<Self, Invalid> {
        self.check_ranges().map_err(|e| e.inside(field))?;
        self.absorption.not_negative("absorption").map_err(|e| e.inside(field))?;
        Ok(self)
    }
}
