//! The book's tracers as values.

use crate::lights::Light;
use crate::lobes::LobeSet;
use crate::scene::Tracer;

/// How light is traced: every tracer of the book is a value of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Strategy {
    /// The hits at which lights are sampled.
    pub direct: Direct,
    /// What is followed from a hit.
    pub scatter: Scatter,
    /// The weight of a lamp that a ray hits, if its light was also sampled where the ray starts.
    pub emitter_hits: EmitterHits,
    /// A ray is cast if at most `max_depth` edges are before it.
    pub max_depth: u32,
}

/// The hits at which lights are sampled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direct {
    /// At every hit, as a term of shading.
    Shading,
    /// At the first hit of a path.
    FirstHit,
    /// At every hit of a path, unless its edge to the light would be too deep.
    EveryHit,
    /// Nowhere.
    Never,
}

/// What is followed from a hit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scatter {
    /// Nothing.
    Nothing,
    /// Each lobe that does not accept the samples of lights: a tree.
    TracedLobes,
    /// One of all lobes: a path.
    OneLobe,
    /// The same with Russian roulette.
    OneLobeOrNone,
}

/// The weight of a lamp that a ray hits, if its light was also sampled at the hit from which the
/// ray comes. Does not apply to rays of a single direction, which light sampling cannot choose.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EmitterHits {
    /// 1: light samples and scattered rays never use the same lobe.
    Count,
    /// 0: the light sample counts instead.
    Ignore,
    /// The MIS weight (multiple importance sampling, Veach 1997).
    Mis,
}

impl Strategy {
    /// The strategy of a scene's tracer.
    pub fn of(tracer: Tracer) -> Self {
        let tree = |scatter, max_depth| Self {
            direct: Direct::Shading,
            scatter,
            emitter_hits: EmitterHits::Count,
            max_depth,
        };
        let path = |direct, emitter_hits, max_depth| Self {
            direct,
            scatter: Scatter::OneLobe,
            emitter_hits,
            max_depth,
        };
        match tracer {
            Tracer::RayCast => tree(Scatter::Nothing, 0),
            Tracer::Whitted(it) => tree(Scatter::TracedLobes, it.max_depth),
            Tracer::PathTrace(it) => path(Direct::Never, EmitterHits::Count, it.max_depth),
            Tracer::GlobalTrace(it) => path(Direct::FirstHit, EmitterHits::Ignore, it.max_depth),
            Tracer::Path(it) => Self {
                scatter: Scatter::OneLobeOrNone,
                ..path(Direct::EveryHit, EmitterHits::Mis, it.max_depth)
            },
        }
    }

    /// Whether one lobe is followed, so that the samples of a pixel are paths.
    pub fn is_path(self) -> bool {
        matches!(self.scatter, Scatter::OneLobe | Scatter::OneLobeOrNone)
    }

    /// The lobes that take samples of lights.
    pub fn lit_lobes(self) -> LobeSet {
        if self.is_path() { LobeSet::NonDelta } else { LobeSet::DirectOnly }
    }

    /// Whether its paths can hit this light.
    pub fn meets(self, light: &dyn Light) -> bool {
        self.is_path() && light.is_met()
    }

    /// Whether lights are sampled at a hit of this depth.
    pub fn samples_lights(self, depth: u32) -> bool {
        match self.direct {
            Direct::Shading => true,
            Direct::FirstHit => depth == 0 && depth < self.max_depth,
            Direct::EveryHit => depth < self.max_depth,
            Direct::Never => false,
        }
    }
}
