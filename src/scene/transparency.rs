//! Scene settings for transparent surfaces.

/// Shadow rays and radiance at transparent surfaces (chapters 27 and 28).
#[kind(Copy, Default, Eq, PartialEq)]
#[schemars(example = Transparency { shadows: TransparentShadows::Attenuated, ..Transparency::default() })]
pub struct Transparency {
    /// Whether transparent surfaces block shadow rays.
    #[default]
    pub shadows: TransparentShadows,
    /// Whether refraction multiplies radiance by `1/η²`: in the denser medium the same light fills
    /// a smaller cone of directions. Switch it off to compare with renderers that omit the factor;
    /// it makes no difference if the camera, the lights and the lit surfaces are all in the same
    /// medium.
    #[default(true)]
    pub scales_radiance: bool,
}

/// Whether transparent surfaces block shadow rays.
#[kind(Default)]
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
