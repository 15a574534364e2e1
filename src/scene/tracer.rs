//! The tracers, as scenes name them.

use std::str::FromStr;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// How light is followed: the book's tracers as settings of one recursion.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
#[schemars(title = "tracers")]
pub enum Tracer {
    /// Direct light only (chapter 14): mirrors and glass are not followed.
    #[default]
    RayCast,
    /// Mirrors and glass are followed (chapter 24).
    Whitted(Whitted),
    /// Paths that end on what shines, lights never sampled (chapter 26): light bounces between all
    /// surfaces. It sees emissive surfaces and the background, no point, directional or spot lights.
    PathTrace(Depth),
    /// Paths whose direct light is sampled at the first hit (chapter 26).
    GlobalTrace(Depth),
    /// Paths whose lights are sampled at every hit and met as well, each weighted by how likely the
    /// other was, and ended by chance where they carry little. Not in the book: the one to choose.
    Path(Depth),
}

/// The setting of the path tracers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(example = Depth { max_depth: 8 })]
pub struct Depth {
    /// The largest number of edges from the camera's ray to a ray that is still cast; what lies
    /// beyond is black. From 0 to 128; 10 is enough for most rooms.
    pub max_depth: u32,
}

/// The setting of the Whitted tracer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(example = Whitted { max_depth: 5 })]
pub struct Whitted {
    /// The largest number of edges from the camera's ray to a ray that is still cast; what lies
    /// beyond is black. From 0 to 128; 5 to 10 is enough for most scenes.
    pub max_depth: u32,
}

impl Tracer {
    /// Every tracer, with a depth that is enough for most scenes.
    pub const ALL: [Self; 5] = [
        Self::RayCast,
        Self::Whitted(Whitted { max_depth: 5 }),
        Self::PathTrace(Depth { max_depth: 10 }),
        Self::GlobalTrace(Depth { max_depth: 10 }),
        Self::Path(Depth { max_depth: 10 }),
    ];

    /// What scene files call it.
    pub fn name(self) -> &'static str {
        match self {
            Self::RayCast => "ray_cast",
            Self::Whitted(_) => "whitted",
            Self::PathTrace(_) => "path_trace",
            Self::GlobalTrace(_) => "global_trace",
            Self::Path(_) => "path",
        }
    }

    /// How deep it follows rays; `None` if it follows none.
    pub fn max_depth(&mut self) -> Option<&mut u32> {
        match self {
            Self::RayCast => None,
            Self::Whitted(whitted) => Some(&mut whitted.max_depth),
            Self::PathTrace(depth) | Self::GlobalTrace(depth) | Self::Path(depth) => {
                Some(&mut depth.max_depth)
            }
        }
    }

    /// Another tracer, as deep as this one if both have a depth.
    #[must_use]
    pub fn exchanged(mut self, mut other: Self) -> Self {
        if let (Some(depth), Some(other_depth)) = (self.max_depth(), other.max_depth()) {
            *other_depth = *depth;
        }
        other
    }

    /// Exchanges the tracer, and then sets the depth, where these are named.
    ///
    /// # Errors
    /// Says so if a depth is named, but the tracer follows no rays.
    pub fn change(&mut self, other: Option<Self>, max_depth: Option<u32>) -> Result<(), String> {
        *self = other.map_or(*self, |other| self.exchanged(other));
        let name = self.name();
        match (self.max_depth(), max_depth) {
            (Some(depth), Some(wanted)) => *depth = wanted,
            (None, Some(wanted)) => {
                let follows = |tracer: &mut Self| tracer.max_depth().is_some();
                let names: Vec<&str> = Self::ALL
                    .into_iter()
                    .filter_map(|mut tracer| follows(&mut tracer).then_some(tracer.name()))
                    .collect();
                let names = names.join(", ");
                return Err(format!(
                    "found {wanted}, but the tracer {name} follows no rays; these do: {names}"
                ));
            }
            (_, None) => {}
        }
        Ok(())
    }
}

impl FromStr for Tracer {
    type Err = String;

    /// A tracer by its name.
    fn from_str(name: &str) -> Result<Self, String> {
        let named = Self::ALL.into_iter().find(|tracer| tracer.name() == name);
        named.ok_or_else(|| format!("there are: {}", Self::ALL.map(Self::name).join(", ")))
    }
}
