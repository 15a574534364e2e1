//! The rays of a ray: what arrives along it, and every ray that was cast for it.

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::limits::{self, MAX_POINTS};
use super::numbers::{RayData, Real, Triple, color, triple};
use super::source::{Built, Source};
use explain::{RayTree, RecordedRay};
use groundtruth::invalid::Invalid;
use groundtruth::trace::{self, Outcome, RayBudget, RayKind};
use groundtruth::world::DEFAULT_SEED;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Trace {
    scene: Source,
    ray: RayData,
    max_depth: Option<u32>,
    #[serde(default = "default_seed")]
    seed: u64,
}

fn default_seed() -> u64 {
    DEFAULT_SEED
}

#[derive(Serialize)]
pub struct TraceAnswer {
    /// What arrives at the origin.
    radiance: Triple,
    rays: Vec<Logged>,
}

/// A ray that was cast; the first is the one asked for.
#[derive(Serialize)]
struct Logged {
    #[serde(flatten)]
    kind: RayKind,
    /// The index of the ray that sent it.
    parent: Option<usize>,
    depth: u32,
    origin: Triple,
    direction: Triple,
    /// Null where nothing is hit, and for shadow rays.
    t: Option<Real>,
    object: Option<Arc<str>>,
    /// What arrives along it.
    radiance: Triple,
    /// Of a shadow ray.
    #[serde(skip_serializing_if = "Option::is_none")]
    light: Option<Arc<str>>,
}

impl Trace {
    /// The scene that its rays meet.
    pub fn built(&self) -> Result<Built, Invalid> {
        self.scene.built(self.seed, |scene| {
            let changed = scene.tracer.change(None, self.max_depth);
            changed.map_err(|problem| Invalid::field("max_depth", problem))
        })
    }
}

impl super::Question for Trace {
    type Answer = TraceAnswer;

    fn answer(&self) -> Result<TraceAnswer, Invalid> {
        let ray = self.ray.unit_ray()?;
        let Built { scene, world, primitives } = self.built()?;
        let draws = world.draws([0, 0], 0);
        limits::traceable(&scene, &world, primitives, 1.0, |world, budget| {
            trace::radiance_within(world, &ray, draws, &mut (), budget)
        })?;
        let mut tree = RayTree::of(&world);
        let mut budget = RayBudget::up_to(u64::from(MAX_POINTS));
        let radiance = trace::radiance_within(&world, &ray, draws, &mut tree, &mut budget);
        budget.check(|| "a log of this ray".to_owned()).map_err(|e| Invalid::new(e.to_string()))?;
        let is_cast = |ray: &&RecordedRay| ray.outcome != Outcome::TooDeep;
        let rays: Vec<&RecordedRay> = tree.rays().into_iter().filter(is_cast).collect();
        let place = |number: usize| rays.binary_search_by_key(&number, |ray| ray.number).ok();
        let logged = |ray: &&RecordedRay| logged(ray, ray.parent.and_then(place));
        let rays = rays.iter().map(logged).collect();
        Ok(TraceAnswer { radiance: color(radiance), rays })
    }
}

fn logged(ray: &RecordedRay, parent: Option<usize>) -> Logged {
    Logged {
        kind: ray.kind,
        parent,
        depth: ray.depth,
        origin: triple(ray.ray.origin),
        direction: triple(ray.ray.direction),
        t: ray.hit.as_ref().map(|hit| Real(hit.t)),
        object: ray.hit.as_ref().map(|hit| Arc::clone(&hit.object)),
        radiance: color(ray.radiance),
        light: ray.light.clone(),
    }
}
