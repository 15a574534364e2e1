//! The tracers, as scene files name them.

use std::str::FromStr;

use crate::similar;

/// Which light paths are traced: the book's tracers as settings of one recursion.
#[kind(Copy, Default, PartialEq, Eq)]
#[schemars(title = "tracers")]
pub enum Tracer {
    /// Direct light only (chapter 14): no reflected or refracted rays.
    #[default]
    RayCast,
    /// Direct light and the reflected and refracted rays of mirrors and glass (chapter 24).
    Whitted(Whitted),
    /// Path tracing without sampling of lights (chapter 26): light is reflected between all
    /// surfaces. A path collects the emission of the surfaces and of the background that it hits;
    /// lights without a surface (point, directional, spot …) contribute nothing.
    PathTrace(Depth),
    /// Path tracing that samples the lights at the first hit only (chapter 26). A lamp that a path
    /// hits at its second hit counts as sampled: sharp gloss under a sampled sky is very noisy.
    GlobalTrace(Depth),
    /// The recommended path tracer (not in the book): it samples the lights at every hit, with
    /// multiple importance sampling and Russian roulette.
    Path(Depth),
}

/// The depth of the path tracers.
#[kind(Copy, PartialEq, Eq)]
#[schemars(example = Depth { max_depth: 8 })]
pub struct Depth {
    /// The largest depth of a ray that is traced; deeper rays are black. The camera's ray has depth
    /// 0, each reflection or refraction adds 1, and so does a ray to a light: at a hit of depth
    /// `max_depth` lights are not sampled, and with 0 only what shines itself is seen. From 0 to
    /// 128; 10 is enough for most rooms.
    #[schemars(range(max = 128))]
    pub max_depth: u32,
}

/// The depth of the Whitted tracer.
#[kind(Copy, PartialEq, Eq)]
#[schemars(example = Whitted { max_depth: 5 })]
pub struct Whitted {
    /// The largest depth of a ray that is traced; deeper rays are black. The camera's ray has depth
    /// 0, each reflection or refraction adds 1. From 0 to 128; 5 to 10 is enough for most scenes.
    #[schemars(range(max = 128))]
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

    /// The name in scene files.
    pub fn name(self) -> &'static str {
        match self {
            Self::RayCast => "ray_cast",
            Self::Whitted(_) => "whitted",
            Self::PathTrace(_) => "path_trace",
            Self::GlobalTrace(_) => "global_trace",
            Self::Path(_) => "path",
        }
    }

    /// Its depth; `None` for ray casting.
    pub fn max_depth(&mut self) -> Option<&mut u32> {
        match self {
            Self::RayCast => None,
            Self::Whitted(whitted) => Some(&mut whitted.max_depth),
            Self::PathTrace(depth) | Self::GlobalTrace(depth) | Self::Path(depth) => {
                Some(&mut depth.max_depth)
            }
        }
    }

    /// Another tracer, with the depth of this one if both have a depth.
    #[must_use]
    pub fn replaced_by(mut self, mut other: Self) -> Self {
        if let (Some(depth), Some(other_depth)) = (self.max_depth(), other.max_depth()) {
            *other_depth = *depth;
        }
        other
    }

    /// Replaces the tracer by `other` and sets the depth, where given.
    ///
    /// # Errors
    /// If a depth is given but the tracer has none.
    pub fn change(&mut self, other: Option<Self>, max_depth: Option<u32>) -> Result<(), String> {
        *self = other.map_or(*self, |other| self.replaced_by(other));
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

    fn from_str(name: &str) -> Result<Self, String> {
        let named = Self::ALL.into_iter().find(|tracer| tracer.name() == name);
        named.ok_or_else(|| {
            let names = Self::ALL.map(Self::name);
            format!("there are: {}{}", names.join(", "), similar::did_you_mean(name, &names))
        })
    }
}
