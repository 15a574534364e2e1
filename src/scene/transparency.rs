//! What a scene may choose of transparent surfaces.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::kinds;

/// What shadow rays and radiance do at transparent surfaces (chapters 27 and 28).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(example = Transparency { shadows: TransparentShadows::Attenuated, ..Transparency::default() })]
pub struct Transparency {
    /// What a shadow ray does that meets a transparent surface.
    #[serde(default)]
    pub shadows: TransparentShadows,
    /// Whether refraction multiplies radiance by `1/η²`: the same light fills a smaller cone of
    /// directions in the denser medium. Off, a picture compares with those of renderers that leave
    /// the factor out: the same where the eye and all that shines or is lit are in one medium.
    #[serde(default = "kinds::yes")]
    pub scales_radiance: bool,
}

/// What a shadow ray does that meets a transparent surface.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum TransparentShadows {
    /// It ends: glass has a full shadow, as in the book.
    #[default]
    Opaque,
    /// It goes straight on, and each surface counts what it transmits at that angle (in the medium of the
    /// smaller index), each stretch what its medium absorbs: an approximation, as light does not go
    /// straight. Path tracers do so only
    /// for lights that their paths cannot meet.
    Attenuated,
}

impl Transparency {
    /// Whether it need not be written.
    pub(super) fn is_default(&self) -> bool {
        *self == Self::default()
    }
}

impl Default for Transparency {
    fn default() -> Self {
        Self { shadows: TransparentShadows::default(), scales_radiance: true }
    }
}
