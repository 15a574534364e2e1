//! The one recursion: from a ray to the radiance that arrives along it (Suffern, ch. 3, 14, 24).
//!
//! Lights and lobes answer "from where, how much?" and never trace; only this module casts rays, so
//! each one passes `Tracing::cast` and is heard by the recorder. The book's tracers are values of
//! one [`Strategy`], and its `Material::shade` and `area_light_shade` are `Tracing::shade`.
//!
//! Law: what arrives along a ray is `T · Σ terms`, the terms in the order in which the recorder
//! hears them, each one local or `weight · L(child)`, and `T` the transmittance of the medium.

mod optics;
mod recorder;
mod shading_point;
mod strategy;
mod tree;

use arrayvec::ArrayVec;

use crate::lights::{LightContext, LightSample, MOST_DRAWS, Meets, Segment, Target};
use crate::lobes::{Bsdf, BsdfSample, Lit, Lobe, MOST_LOBES, Which};
use crate::materials::Response;
use crate::math::{Point, Ray, Span, UNIT_ROUNDOFF, Vector};
use crate::rgb::Rgb;
use crate::samplers::{Draws, PathKey, Purpose};
use crate::world::{Hit, PlacedLight, World};

pub use optics::Optics;
pub use recorder::{Outcome, RayCounts, RayKind, Recorder, Term, TermSource};
pub use shading_point::ShadingPoint;
pub use strategy::{Direct, Lamps, Scatter, Strategy, left_out};
pub use tree::{Node, RayTree, RecordedHit, RecordedTerm};

/// The radiance that arrives at the origin of a ray from the camera. The direction must be unit:
/// distances through media are counted in `t`.
pub fn radiance<R: Recorder>(world: &World, ray: &Ray, draws: Draws<'_>, recorder: &mut R) -> Rgb {
    let (kind, key, medium) = (RayKind::Camera, PathKey::CAMERA, world.view.medium.absorption);
    let throughput = Rgb::WHITE;
    let path = PathState { ray: *ray, kind, depth: 0, key, medium, left: None, throughput };
    let strategy = Strategy::of(world.tracer);
    Tracing { world, strategy, draws, recorder }.cast(&path, Rgb::WHITE)
}

/// A ray to be cast, and what it carries along its path.
struct PathState {
    ray: Ray,
    kind: RayKind,
    /// The number of edges before it; 0 for the camera's ray.
    depth: u32,
    /// Names its draws.
    key: PathKey,
    /// The absorption of the medium it is in.
    medium: Rgb,
    /// Where a path left, if lights were sampled there.
    left: Option<Left>,
    /// What light that arrives along a path counts at the eye, without the 1/η² of radiance: Russian
    /// roulette goes by it.
    throughput: Rgb,
}

/// A hit at which lights were sampled, and from which a path went on in a direction that this could have
/// found.
#[derive(Clone, Copy)]
struct Left {
    from: LightContext,
    /// The density of the direction, per steradian.
    pdf: f64,
}

struct Tracing<'a, R> {
    world: &'a World,
    strategy: Strategy,
    draws: Draws<'a>,
    recorder: &'a mut R,
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

impl<R: Recorder> Tracing<'_, R> {
    /// What arrives along a ray that counts `weight` for the one before it.
    fn cast(&mut self, path: &PathState, weight: Rgb) -> Rgb {
        let PathState { ray, kind, depth, medium, .. } = path;
        self.recorder.enter(*kind, ray, *depth, weight);
        let mut sum = RadianceSum(Rgb::BLACK);
        let mut transmittance = Rgb::WHITE;
        if *depth > self.strategy.max_depth {
            self.recorder.outcome(Outcome::TooDeep);
        } else if let Some(hit) = &self.world.hit(ray, Span::AHEAD) {
            self.recorder.outcome(Outcome::Hit { hit });
            transmittance = medium.transmittance(hit.t);
            self.shade(path, hit, &mut sum);
        } else {
            self.recorder.outcome(Outcome::Background);
            transmittance = medium.transmittance(f64::INFINITY);
            let radiance = self.world.background.radiance(ray);
            let share = match self.world.sky() {
                Some(sky) => self.share(path, sky, &Target::Infinity(ray.direction)),
                None => 1.0,
            };
            if share > 0.0 {
                sum.add(self.recorder, TermSource::Background, Rgb::grey(share), radiance);
            }
        }
        let arriving = transmittance * sum.0;
        self.recorder.leave(transmittance, arriving);
        arriving
    }

    /// Adds up the light that leaves a surface towards the ray's origin.
    fn shade(&mut self, path: &PathState, hit: &Hit<'_>, sum: &mut RadianceSum) {
        let point = ShadingPoint::new(hit, -path.ray.direction);
        let material = &hit.material.recipe;
        if let Some(emission) = material.emission().filter(|_| hit.object.shines) {
            let emitted = emission.radiance(&hit.surface, point.cos_o);
            let lamp_of = hit.object.lamp_of.map(|light| &self.world.lights[light as usize]);
            let share = lamp_of
                .map_or(1.0, |light| self.share(path, light, &Target::Surface(&hit.surface)));
            if !emitted.is_black() && share > 0.0 {
                sum.add(self.recorder, TermSource::Emission, Rgb::grey(share), emitted);
            }
        }
        let mut response = Response::default();
        material.respond(&hit.surface, point.cos_o, &mut response);
        let bsdf = Bsdf::new(&response.lobes, point.normals, point.wo);
        self.recorder.surface(&point, &response.lobes);

        if self.strategy.samples_lights(path.depth) {
            for light in &self.world.lights {
                match light.light.meets() {
                    // ambient light stands for what paths find by themselves
                    Meets::Ambient if self.strategy.is_path() => {}
                    Meets::Ambient => self.ambient(path, &point, light, response.ambient, sum),
                    Meets::Lobes => self.direct(path, &point, light, &bsdf, sum),
                }
            }
        }
        match self.strategy.scatter {
            Scatter::Nothing => {}
            Scatter::TracedLobes => self.follow_each(path, &point, &bsdf, sum),
            Scatter::OneLobe | Scatter::OneLobeOrNone => self.follow_one(path, &point, &bsdf, sum),
        }
    }

    /// What light from a target counts along a path that came upon it, if its light may have been
    /// sampled before.
    fn share(&self, path: &PathState, light: &PlacedLight, to: &Target<'_>) -> f64 {
        match (self.strategy.lamps, path.left) {
            (Lamps::Full, _) | (_, None) => 1.0,
            (Lamps::Nothing, Some(_)) => 0.0,
            (Lamps::Weighted, Some(left)) => {
                power_heuristic(left.pdf, light.light.pdf(&left.from, to))
            }
        }
    }

    /// Follows each lobe that lights' samples do not meet.
    fn follow_each(
        &mut self,
        path: &PathState,
        point: &ShadingPoint<'_>,
        bsdf: &Bsdf<'_>,
        sum: &mut RadianceSum,
    ) {
        for (lobe, kind) in bsdf.lobes().iter().filter(|(lobe, _)| !lobe.is_lit()) {
            let u = self.direction(path, lobe);
            if let Some(sample) = bsdf.sample(lobe, *kind, u) {
                let onward = Onward { left: None, throughput: path.throughput };
                self.follow(path, point, lobe, (sample, onward), sum);
            }
        }
    }

    /// Follows one lobe, chosen in proportion to about what it sends on; with Russian roulette perhaps
    /// none.
    fn follow_one(
        &mut self,
        path: &PathState,
        point: &ShadingPoint<'_>,
        bsdf: &Bsdf<'_>,
        sum: &mut RadianceSum,
    ) {
        /// From this depth on a path may end by chance.
        const ROULETTE_FROM: u32 = 3;
        let chances = bsdf.chances();
        let plays = self.strategy.scatter == Scatter::OneLobeOrNone && path.depth >= ROULETTE_FROM;
        let is_certain = chances.iter().any(|chance| *chance == 1.0);
        // one pair for both: a surface of one lobe draws no choice
        let [u, luck] = match plays || !is_certain {
            true => self.draw(Purpose::Lobe { path: path.key }),
            false => [0.0; 2],
        };
        let mut passed = 0.0;
        let chosen = chances.iter().position(|chance| {
            passed += chance;
            u < passed
        });
        let Some((lobe, kind)) = chosen.map(|index| &bsdf.lobes()[index]) else { return };
        let direction = self.direction(path, lobe);
        let Some(mut sample) = bsdf.sample(lobe, *kind, direction) else { return };
        sample.weight = sample.weight / chances[chosen.unwrap_or(0)];
        let eta = if sample.transmits { bsdf.relative_eta(lobe, *kind) } else { 1.0 };
        let mut throughput = path.throughput * ((eta * eta) * sample.weight);
        if plays {
            let survives = throughput.max().min(1.0);
            if luck >= survives {
                return;
            }
            sample.weight = sample.weight / survives;
            throughput = throughput / survives;
        }
        let sampled = self.strategy.samples_lights(path.depth) && sample.pdf.is_some();
        let left = sampled.then(|| Left { from: context(point), pdf: bsdf.pdf(sample.direction) });
        self.follow(path, point, lobe, (sample, Onward { left, throughput }), sum);
    }

    /// The numbers for the direction of a lobe; a single direction needs none.
    fn direction(&mut self, path: &PathState, lobe: &Lobe) -> [f64; 2] {
        match lobe.is_specular() {
            true => [0.5; 2],
            false => self.draw(Purpose::Direction { path: path.key, branch: lobe.branch() }),
        }
    }

    fn draw(&mut self, purpose: Purpose) -> [f64; 2] {
        self.recorder.draw();
        self.draws.draw(purpose)
    }

    /// What a light sends to a point, for the numbers that are drawn for it there.
    fn sample(
        &mut self,
        path: &PathState,
        point: &ShadingPoint<'_>,
        light: &PlacedLight,
    ) -> Option<LightSample> {
        let from = context(point);
        let mut u = ArrayVec::<[f64; 2], MOST_DRAWS>::new();
        for pair in 0..light.light.draws() as u32 {
            u.push(self.draw(Purpose::Light { path: path.key, light: light.place, pair }));
        }
        light.light.sample(&from, &u)
    }

    /// Light that meets the ambient reflectance.
    fn ambient(
        &mut self,
        path: &PathState,
        point: &ShadingPoint<'_>,
        light: &PlacedLight,
        reflectance: Rgb,
        sum: &mut RadianceSum,
    ) {
        if reflectance.is_black() {
            return;
        }
        let Some(sample) = self.sample(path, point, light) else { return };
        let (arriving, traced) = self.arriving(Rgb::BLACK, point, light, &sample);
        let source = TermSource::Ambient { light: light.place, traced };
        sum.add(self.recorder, source, reflectance, arriving);
    }

    /// Light that comes straight from a source, by each lobe that takes light from there.
    fn direct(
        &mut self,
        path: &PathState,
        point: &ShadingPoint<'_>,
        light: &PlacedLight,
        bsdf: &Bsdf<'_>,
        sum: &mut RadianceSum,
    ) {
        let which = if self.strategy.is_path() { Which::Spread } else { Which::Lit };
        if !bsdf.is_lit(which) {
            return;
        }
        let Some(sample) = self.sample(path, point, light) else { return };
        let pdf = sample.pdf;
        let weighted = pdf.filter(|_| self.strategy.lamps == Lamps::Weighted);
        let mis = weighted.map(|pdf| power_heuristic(pdf, bsdf.pdf(sample.direction)));
        let lit = bsdf.lit(which, sample.direction);
        let terms: ArrayVec<_, MOST_LOBES> = lit
            .into_iter()
            .map(|lit| (lit, (lit.cos_i / pdf.unwrap_or(1.0)) * lit.f))
            .map(|(lit, weight)| (lit, mis.map_or(weight, |mis| mis * weight)))
            .filter(|(_, weight)| !weight.is_black())
            .collect();
        if terms.is_empty() || (sample.radiance.is_black() && sample.blocked.is_black()) {
            return;
        }
        let medium = medium_towards(path, point, sample.direction);
        let (arriving, traced) = self.arriving(medium, point, light, &sample);
        for (Lit { lobe, f, cos_i }, weight) in terms {
            let source =
                TermSource::Direct { light: light.place, lobe, f, cos_i, pdf, mis, traced };
            sum.add(self.recorder, source, weight, arriving);
        }
    }

    /// What arrives of a light's sample, and whether a shadow ray told.
    fn arriving(
        &mut self,
        medium: Rgb,
        point: &ShadingPoint<'_>,
        light: &PlacedLight,
        sample: &LightSample,
    ) -> (Rgb, bool) {
        let length = match sample.segment {
            None => 0.0,
            Some(Segment::Infinity) => f64::INFINITY,
            Some(Segment::To(end)) => end.distance(point.hit.surface.point),
        };
        match sample.segment {
            Some(segment) if light.shadows => {
                // where an interpolated normal differs from the true one, the surface hides part of
                // the hemisphere itself, also if it is open and nothing else is behind it
                if point.normals.geometry.dot(sample.direction) <= 0.0 {
                    return (sample.blocked, false);
                }
                (self.shadow(medium, point, light.place, (segment, sample)), true)
            }
            // what absorbs is in its way all the same
            _ => (medium.transmittance(length) * sample.radiance, false),
        }
    }

    /// Whether an object stands in the way of a light, and so what arrives.
    fn shadow(
        &mut self,
        medium: Rgb,
        point: &ShadingPoint<'_>,
        light: u32,
        (segment, sample): (Segment, &LightSample),
    ) -> Rgb {
        let origin = point.hit.surface.leave(sample.direction);
        let (ray, span, length) = match segment {
            Segment::Infinity => (Ray::new(origin, sample.direction), Span::AHEAD, f64::INFINITY),
            Segment::To(end) => {
                (Ray::new(origin, end - origin), up_to(end, origin), end.distance(origin))
            }
        };
        self.recorder.enter(RayKind::Shadow { light }, &ray, 0, Rgb::WHITE);
        let occluder = self.world.occluder(&ray, span);
        let sent = if occluder.is_some() { sample.blocked } else { sample.radiance };
        self.recorder.outcome(match occluder {
            Some(object) => Outcome::Blocked { blocked_by: object.place },
            None => Outcome::Unblocked,
        });
        let source = TermSource::Light { light };
        self.recorder.term(Term { source, weight: Rgb::WHITE, arriving: sent, value: sent });
        let transmittance = medium.transmittance(length);
        let arriving = transmittance * sent;
        self.recorder.leave(transmittance, arriving);
        arriving
    }

    /// Follows a mirrored or refracted ray.
    fn follow(
        &mut self,
        path: &PathState,
        point: &ShadingPoint<'_>,
        lobe: &Lobe,
        (sample, Onward { left, throughput }): (BsdfSample, Onward),
        sum: &mut RadianceSum,
    ) {
        let BsdfSample { direction, weight, transmits, .. } = sample;
        let child = PathState {
            ray: Ray::new(point.hit.surface.leave(direction), direction),
            kind: if transmits { RayKind::Transmitted } else { RayKind::Reflected },
            depth: path.depth + 1,
            key: path.key.then(lobe.branch()),
            medium: medium_towards(path, point, direction),
            left,
            throughput,
        };
        let light = self.cast(&child, weight);
        sum.add(self.recorder, TermSource::Traced { lobe: *lobe }, weight, light);
    }
}

/// What a path knows when it goes on.
struct Onward {
    left: Option<Left>,
    throughput: Rgb,
}

/// Where lights are asked for their light.
fn context(point: &ShadingPoint<'_>) -> LightContext {
    LightContext { point: point.hit.surface.point, normal: point.normals.shading }
}

/// The share of a direction of density `pdf` that another strategy would have drawn with density
/// `other`: `p²/(p² + q²)` (Veach 1997, power heuristic with β = 2).
fn power_heuristic(pdf: f64, other: f64) -> f64 {
    let ratio = other / pdf;
    1.0 / (1.0 + ratio * ratio)
}

/// The absorption of the medium that a ray in this direction is in: at a boundary that of the side it
/// leaves to, else that of the ray before it.
fn medium_towards(path: &PathState, point: &ShadingPoint<'_>, direction: Vector) -> Rgb {
    match point.hit.material.recipe.boundary() {
        Some(boundary) if point.normals.geometry.dot(direction) > 0.0 => {
            boundary.outside.absorption
        }
        Some(boundary) => boundary.inside.absorption,
        None => path.medium,
    }
}

/// The segment from `origin` to a light, in units of its length, without its ends: objects behind
/// the light do not block it, and a surface that the light lies on does not either.
fn up_to(light: Point, origin: Point) -> Span {
    let size = light.to_vector().max_abs() + origin.to_vector().max_abs();
    // of the place of the light, and of the t of a surface there that the ray does not graze
    let rounding = 64.0 * UNIT_ROUNDOFF * size / light.distance(origin);
    Span { min: 0.0, max: 1.0 - rounding }
}
