//! Scene settings for transparent surfaces.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::kinds;

/// Shadow rays and radiance at transparent surfaces (chapters 27 and 28).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(example = Transparency { shadows: TransparentShadows::Attenuated, ..Transparency::default() })]
pub struct Transparency {
    /// Whether transparent surfaces block shadow rays.
    #[serde(default)]
    pub shadows: TransparentShadows,
    /// Whether refraction multiplies radiance by `1/η²`: in the denser medium the same light fills
    /// a smaller cone of directions. Switch it off to compare with renderers that omit the factor;
    /// it makes no difference if the camera, the lights and the lit surfaces are all in the same
    /// medium.
    #[serde(default = "kinds::yes")]
    pub scales_radiance: bool,
}

/// Whether transparent surfaces block shadow rays.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum TransparentShadows {
    /// They do: glass casts a full shadow, as in the book.
    #[default]
    Opaque,
    /// They do not: the shadow ray goes straight on. It is attenuated by the transmittance of each
    /// surface at that angle (in the medium of smaller index) and by the absorption of each medium.
    /// This is an approximation, because it ignores refraction. Path tracers use it only for lights
    /// that their paths cannot hit.
    Attenuated,
}

impl Transparency {
    /// Whether it can be left out of a scene file.
    pub(super) fn is_default(&self) -> bool {
        *self == Self::default()
    }
}

impl Default for Transparency {
    fn default() -> Self {
        Self { shadows: TransparentShadows::default(), scales_radiance: true }
    }
}
