//! The one recursion: from a ray to the radiance that arrives along it (Suffern, ch. 3, 14, 24).
//!
//! Lights and lobes answer "from where, how much?" and never trace; only this module casts rays, so
//! each one is heard by the recorder: shadow rays in `shadow`, all others in `Tracing::cast`. The
//! book's tracers are values of one [`Strategy`], and its `Material::shade` and `area_light_shade`
//! are `Tracing::shade`.
//!
//! Law: what arrives along a ray is `T · Σ terms`, the terms in the order in which the recorder
//! hears them, each one local or `weight · L(child)`, and `T` the transmittance of the medium.

mod budget;
mod direct;
mod recorder;
mod scatter;
mod shading_point;
mod shadow;
mod strategy;

use crate::lights::{LightContext, Target};
use crate::lobes::Bsdf;
use crate::materials::Response;
use crate::math::{Ray, Span, Vector};
use crate::rgb::Rgb;
use crate::samplers::{Draws, PathKey, Purpose};
use crate::world::{Hit, PlacedLight, Search, World};

pub use budget::{Budget, RayBudget, TooManyRays, Unlimited, UntilStopped};
pub use recorder::{Outcome, RayCounts, RayKind, Recorder, Term, TermSource};
pub use shading_point::ShadingPoint;
pub use strategy::{Direct, EmitterHits, Scatter, Strategy};

/// The radiance that arrives at the origin of a ray from the camera. The direction must be unit:
/// distances through media are counted in `t`.
pub fn radiance<R: Recorder>(world: &World, ray: &Ray, draws: Draws<'_>, recorder: &mut R) -> Rgb {
    radiance_within(world, ray, draws, recorder, &mut Unlimited)
}

/// As [`radiance`], within a budget of rays; those beyond it are black.
pub fn radiance_within<R: Recorder, B: Budget>(
    world: &World,
    ray: &Ray,
    draws: Draws<'_>,
    recorder: &mut R,
    budget: &mut B,
) -> Rgb {
    let (kind, key, medium) = (RayKind::Camera, PathKey::CAMERA, world.view.medium.absorption);
    let throughput = Rgb::WHITE;
    let path = PathState { ray: *ray, kind, depth: 0, key, medium, previous: None, throughput };
    let strategy = Strategy::of(world.tracer);
    Tracing { world, strategy, draws, recorder, budget }.cast(&path, Rgb::WHITE)
}

/// A ray to be cast, and what it carries along its path.
struct PathState {
    ray: Ray,
    kind: RayKind,
    /// The number of edges before it; 0 for the camera's ray.
    depth: u32,
    /// The name of its path, from which its random numbers follow.
    key: PathKey,
    /// The absorption of the medium it is in.
    medium: Rgb,
    /// The vertex before, if lights were sampled there; for multiple importance sampling.
    previous: Option<PreviousVertex>,
    /// Of a path, the weight at the eye of light that arrives along it, without the 1/η² of
    /// radiance and the absorption of media; Russian roulette depends on it.
    throughput: Rgb,
}

/// The path's vertex before, if lights were sampled there and the path continued in a direction
/// that light sampling could have chosen.
#[derive(Clone, Copy)]
struct PreviousVertex {
    light_context: LightContext,
    /// The density of the direction, per steradian.
    pdf: f64,
}

struct Tracing<'a, R, B> {
    world: &'a World,
    strategy: Strategy,
    draws: Draws<'a>,
    recorder: &'a mut R,
    budget: &'a mut B,
}

/// The terms of one node, added up in the order in which they are heard.
struct RadianceSum(Rgb);

impl RadianceSum {
    fn add<R: Recorder>(
        &mut self,
        recorder: &mut R,
        source: TermSource,
        weight: Rgb,
        arriving: Rgb,
    ) {
        let value = weight * arriving;
        self.0 += value;
        recorder.term(Term { source, weight, arriving, value });
    }
}

impl<'a, R: Recorder, B: Budget> Tracing<'a, R, B> {
    /// The radiance that arrives along a ray; the ray before it multiplies this by `weight`.
    fn cast(&mut self, path: &PathState, weight: Rgb) -> Rgb {
        let PathState { ray, kind, depth, medium, .. } = path;
        self.recorder.enter(*kind, ray, *depth, weight);
        let mut sum = RadianceSum(Rgb::BLACK);
        let is_within = self.budget.spend();
        let (outcome, transmittance) = if *depth > self.strategy.max_depth {
            (Outcome::TooDeep, Rgb::WHITE)
        } else if !is_within {
            (Outcome::OverBudget, Rgb::WHITE)
        } else if let Some(hit) = &self.first_hit(ray, Span::AHEAD) {
            self.shade(path, hit, &mut sum);
            (Outcome::Hit, medium.transmittance(hit.t))
        } else {
            let radiance = self.world.background.radiance(ray);
            let sky = self.world.sky();
            let mis =
                sky.and_then(|sky| self.mis_weight(path, sky, &Target::Infinity(ray.direction)));
            let share = mis.unwrap_or(1.0);
            sum.add(self.recorder, TermSource::Background { mis }, Rgb::grey(share), radiance);
            (Outcome::Background, medium.transmittance(f64::INFINITY))
        };
        let arriving = transmittance * sum.0;
        self.recorder.leave(outcome, transmittance, arriving);
        arriving
    }

    /// The first hit along a ray, or along a part of it.
    #[inline]
    fn first_hit(&mut self, ray: &Ray, span: Span) -> Option<Hit<'a>> {
        self.recorder.search(Search::FirstHit, ray, span);
        self.world.hit(ray, span)
    }

    /// Adds up the light that leaves a surface towards the ray's origin.
    fn shade(&mut self, path: &PathState, hit: &Hit<'_>, sum: &mut RadianceSum) {
        let point = ShadingPoint::new(hit, -path.ray.direction);
        let material = &hit.material.recipe;
        if let Some(emission) = material.emission().filter(|_| hit.object.shines) {
            let emitted = emission.radiance(&hit.texture_point(), point.cos_o);
            let lamp_of = hit.object.lamp_of.map(|light| &self.world.lights[light as usize]);
            let to = Target::Surface(&hit.surface);
            let mis = lamp_of.and_then(|light| self.mis_weight(path, light, &to));
            let share = mis.unwrap_or(1.0);
            if !emitted.is_black() {
                sum.add(self.recorder, TermSource::Emission { mis }, Rgb::grey(share), emitted);
            }
        }
        let mut response = Response::default();
        material.respond(&hit.texture_point(), point.cos_o, &mut response);
        let mut bsdf = Bsdf::new(&response.lobes, point.normals, point.wo);
        if self.strategy.is_path() {
            bsdf.weigh_lobes();
        }
        self.recorder.hit(&point, &response.lobes);

        if self.strategy.samples_lights(path.depth) {
            for light in &self.world.lights {
                match light.light.is_ambient() {
                    // ambient light replaces indirect light, which paths find themselves
                    true if self.strategy.is_path() => {}
                    true => self.ambient(path, &point, light, response.ambient, sum),
                    false => self.direct(path, &point, light, &bsdf, sum),
                }
            }
        }
        match self.strategy.scatter {
            Scatter::Nothing => {}
            Scatter::TracedLobes => self.follow_each(path, &point, &bsdf, sum),
            Scatter::OneLobe | Scatter::OneLobeOrNone => self.follow_one(path, &point, &bsdf, sum),
        }
    }

    /// The weight of light from a target that a path hit, if the light was also sampled at the hit
    /// before; `None` if it was not, and the weight is 1.
    fn mis_weight(&self, path: &PathState, light: &PlacedLight, to: &Target<'_>) -> Option<f64> {
        match (self.strategy.emitter_hits, path.previous) {
            (EmitterHits::Count, _) | (_, None) => None,
            (EmitterHits::Ignore, Some(_)) => Some(0.0),
            (EmitterHits::Mis, Some(previous)) => {
                Some(power_heuristic(previous.pdf, light.light.pdf(&previous.light_context, to)))
            }
        }
    }

    fn draw(&mut self, purpose: Purpose) -> [f64; 2] {
        self.recorder.draw();
        self.draws.draw(purpose)
    }
}

/// The weight of a direction drawn with density `pdf`, if another strategy would draw it with
/// density `other`: `p²/(p² + q²)` (Veach 1997, power heuristic with β = 2).
fn power_heuristic(pdf: f64, other: f64) -> f64 {
    let ratio = other / pdf;
    1.0 / (1.0 + ratio * ratio)
}

/// The absorption of the medium of a ray in this direction: at a boundary, that of the side the ray
/// leaves to; elsewhere, that of the ray before it.
fn absorption_towards(before: Rgb, point: &ShadingPoint<'_>, direction: Vector) -> Rgb {
    match point.hit.material.recipe.boundary() {
        Some(boundary) if point.is_outward(direction) => boundary.outside.absorption,
        Some(boundary) => boundary.inside.absorption,
        None => before,
    }
}
