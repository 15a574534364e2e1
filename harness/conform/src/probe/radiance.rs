//! The radiance of a pixel or along a ray.

use serde::{Deserialize, Serialize};

use super::numbers::{RayData, Triple, color};
use super::source::{Built, Source};
use super::{camera_ray, limits};
use groundtruth::invalid::Invalid;
use groundtruth::math::Ray;
use groundtruth::render::{self, Renderer};
use groundtruth::rgb::Rgb;
use groundtruth::trace;
use groundtruth::trace::RayBudget;
use groundtruth::world::{DEFAULT_SEED, MAX_PIXELS, World};

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Radiance {
    scene: Source,
    pixel: Option<[u32; 2]>,
    /// Columns and rows of the picture of the pixel.
    size: Option<[u32; 2]>,
    ray: Option<RayData>,
    samples: Option<u32>,
    tracer: Option<String>,
    max_depth: Option<u32>,
    replicas: Option<u32>,
    seed: Option<u64>,
}

#[derive(Serialize)]
pub struct RadianceAnswer {
    mean: Triple,
    /// Of the mean, from the differences between the replicas; null for a single one.
    standard_error: Option<Triple>,
    /// Samples of a replica.
    samples: u32,
    /// Pictures of independent seeds.
    replicas: u32,
}

/// Enough for a standard error that is itself good to about 20 %.
const REPLICAS: u32 = 16;
/// More add nothing that more samples would not.
const MAX_REPLICAS: u32 = 1024;

impl super::Question for Radiance {
    type Answer = RadianceAnswer;

    /// Replica `i` is what is rendered with `seed + i`.
    fn answer(&self) -> Result<RadianceAnswer, Invalid> {
        let looks = self.looks()?;
        let replicas = self.replicas.unwrap_or(REPLICAS);
        if !(1..=MAX_REPLICAS).contains(&replicas) {
            let problem = format!("found {replicas}, but 1 to {MAX_REPLICAS} fit");
            return Err(Invalid::field("replicas", problem));
        }
        let seed = self.seed();
        let (mut world, most) = self.world(seed, &looks, f64::from(replicas))?;
        let mut budget = RayBudget::up_to(most);
        let mut values = Vec::with_capacity(replicas as usize);
        for i in 0..replicas {
            if i > 0 {
                world.reseed(seed.wrapping_add(u64::from(i)));
            }
            values.push(looks.value(&world, &mut budget));
            let asked = || "these samples and replicas".to_owned();
            budget.check(asked).map_err(|e| Invalid::new(e.to_string()))?;
        }
        let mean = render::mean(values.iter().copied());
        Ok(RadianceAnswer {
            mean: color(mean),
            standard_error: (replicas > 1).then(|| color(standard_error(mean, &values))),
            samples: world.samples_per_pixel(),
            replicas,
        })
    }
}

/// What is asked for.
pub(super) enum Looks {
    AtPixel([u32; 2]),
    Along(Ray),
}

impl Looks {
    fn sample(&self, world: &World, index: u32, budget: &mut RayBudget) -> Rgb {
        match self {
            Self::AtPixel(pixel) => world.sample(*pixel, index, &mut (), budget),
            Self::Along(ray) => {
                trace::radiance_within(world, ray, world.draws([0, 0], index), &mut (), budget)
            }
        }
    }

    /// The value of a pixel, or the mean of as many samples along a ray.
    pub(super) fn value(&self, world: &World, budget: &mut RayBudget) -> Rgb {
        let samples = (0..world.samples_per_pixel()).map(|i| self.sample(world, i, budget));
        match self {
            Self::AtPixel(_) => render::expose(world, samples),
            Self::Along(_) => render::mean(samples),
        }
    }
}

impl Radiance {
    /// The seed of the first replica.
    pub(super) fn seed(&self) -> u64 {
        self.seed.unwrap_or(DEFAULT_SEED)
    }

    /// The seeds of the replicas.
    pub(super) fn seeds(&self) -> impl Iterator<Item = u64> {
        let (first, count) = (self.seed(), self.replicas.unwrap_or(REPLICAS).min(MAX_REPLICAS));
        (0..count).map(move |i| first.wrapping_add(u64::from(i)))
    }

    pub(super) fn looks(&self) -> Result<Looks, Invalid> {
        match (self.pixel, self.ray) {
            (Some(pixel), None) => Ok(Looks::AtPixel(pixel)),
            (None, Some(_)) if self.size.is_some() => {
                Err(Invalid::field("size", "a ray has no size; leave it out, or ask for a `pixel`"))
            }
            (None, Some(ray)) => Ok(Looks::Along(ray.unit_ray()?)),
            _ => Err(Invalid::new("needs either `pixel` or `ray`")),
        }
    }

    /// The scene with what the question changes of it, and its world.
    pub(super) fn built(&self, seed: u64) -> Result<Built, Invalid> {
        let tracer = self.tracer.as_deref().map(str::parse).transpose();
        let tracer = tracer.map_err(|problem| Invalid::field("tracer", problem))?;
        self.scene.built(seed, |scene| {
            if let Some([width, height]) = self.size {
                let pixels = u64::from(width) * u64::from(height);
                if !(1..=MAX_PIXELS).contains(&pixels) {
                    let problem =
                        format!("found {width} × {height}, but 1 to {MAX_PIXELS} pixels fit");
                    return Err(Invalid::field("size", problem));
                }
                scene.image.resize(width, height);
            }
            if let Some(samples) = self.samples {
                scene.image.samples = samples;
            }
            let changed = scene.tracer.change(tracer, self.max_depth);
            changed.map_err(|problem| Invalid::field("max_depth", problem))
        })
    }

    /// The world, and the number of rays at which tracing must end.
    fn world(&self, seed: u64, looks: &Looks, replicas: f64) -> Result<(World, u64), Invalid> {
        let Built { scene, world, primitives } = self.built(seed)?;
        if let Looks::AtPixel(pixel) = looks {
            camera_ray::inside(*pixel, world.picture_size())?;
        }
        let samples = f64::from(world.samples_per_pixel());
        let samples = samples * replicas;
        let most = limits::traceable(&scene, &world, primitives, samples, |world, budget| {
            looks.sample(world, 0, budget)
        })?;
        Ok((world, most))
    }
}

/// `√(Σ(xᵢ − x̄)² / (n (n − 1)))` of `n` independent values.
pub(super) fn standard_error(mean: Rgb, values: &[Rgb]) -> Rgb {
    let n = values.len() as f64;
    let squares = values.iter().map(|&value| {
        let difference = value + (-1.0) * mean;
        difference * difference
    });
    let sum: Rgb = squares.sum();
    (sum / (n * (n - 1.0))).map(f64::sqrt)
}
