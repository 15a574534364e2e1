//! Media: what light travels through between surfaces (Suffern, ch. 27 and 28).

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::invalid::{Invalid, index};
use crate::kinds;
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
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(example = Medium { eta: 1.33, absorption: Rgb::new(0.25, 0.0, 0.0625) })]
pub struct Medium {
    /// The index of refraction, from 1e-10 to 1e10. Air is 1, water 1.33, glass about 1.5.
    #[serde(default = "kinds::one")]
    pub eta: f64,
    /// `σ` per unit length: the book's colour filter is `exp(−σ)`, so clear is 0. It may be
    /// infinite in code, not in a scene file.
    #[serde(default)]
    #[schemars(extend("x-dimension" = "1/length"))]
    pub absorption: Rgb,
}

impl Default for Medium {
    fn default() -> Self {
        Self { eta: 1.0, absorption: Rgb::BLACK }
    }
}

impl Medium {
    /// A medium without absorption.
    pub const fn clear(eta: f64) -> Self {
        Self { eta, absorption: Rgb::BLACK }
    }

    pub(crate) fn checked(self, field: &str) -> Result<Self, Invalid> {
        index("eta", self.eta).map_err(|e| e.inside(field))?;
        self.absorption.not_negative("absorption").map_err(|e| e.inside(field))?;
        Ok(self)
    }
}
