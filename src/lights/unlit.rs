//! The reasons why a light adds nothing at a hit.

use std::sync::Arc;

use serde::Serialize;

/// The reason why a light adds nothing at a hit: the first factor of its light that is 0. Cosines
/// are those of unit directions from the hit, angles in degrees.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "reason", rename_all = "snake_case")]
pub enum Unlit {
    /// It has `enabled = false`.
    SwitchedOff,
    /// The tracer never counts such lights; a note of the explanation says why.
    LeftOut,
    /// The tracer samples no lights: it counts where a path hits it.
    NotSampled,
    /// The tracer samples lights at the first hit only.
    FirstHitOnly,
    /// The edge from the hit to the light would exceed the largest depth.
    TooDeep,
    /// The material reflects no ambient light.
    NoAmbientReflectance,
    /// The viewer is behind the surface, which is one-sided.
    ViewerBehind {
        /// Between the true normal and the direction to the viewer.
        cos_o: f64,
    },
    /// The material has no lobes.
    NoLobes,
    /// The material has only lobes of a single direction or of traced rays, which samples of lights
    /// do not meet.
    TracedLobesOnly,
    /// The light is behind the surface.
    BehindSurface {
        /// Between the shading normal and the direction to the light.
        cos_i: f64,
    },
    /// The light is in front of the shading normal's plane, but behind the true surface.
    BehindTrueSurface {
        /// Between the true normal and the direction to the light.
        cos_i: f64,
    },
    /// The lobes scatter nothing from the light's direction to the viewer.
    OutsideLobes {
        /// Between the shading normal and the direction to the light.
        cos_i: f64,
    },
    /// The light sends nothing: its radiance is 0.
    Dark,
    /// The hit is outside the cone of a spot light.
    OutsideCone {
        /// Between the axis and the direction to the hit.
        angle: f64,
        /// From this angle on the light is dark.
        outer: f64,
    },
    /// The hit is behind the lamp, which is one-sided.
    BehindLamp {
        /// Between the lamp's normal and the direction to the hit.
        cos_lamp: f64,
    },
    /// The hit is at the light, or so near that its radiance would be infinite.
    AtLight {
        /// From the hit to the light.
        distance: f64,
    },
    /// The drawn point is on the far side of the lamp, or is seen edge-on.
    HiddenPoint,
    /// The drawn numbers give no direction to the light.
    NoDirection,
    /// An object is in between.
    Blocked {
        /// Its name.
        blocked_by: Arc<str>,
    },
    /// The medium transmits nothing.
    Absorbed,
    /// The surface reflects none of the colours that arrive.
    OtherColors,
    /// The contribution is smaller than the smallest number of a picture.
    TooWeak,
}
