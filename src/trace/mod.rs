//! The one recursion: from a ray to the radiance that arrives along it (Suffern, ch. 3, 14, 24).
//!
//! Lights and lobes answer "from where, how much?" and never trace; only this module casts rays, so
//! each one passes `Tracing::cast` and is heard by the recorder. The book's tracers are settings
//! of it, and its `Material::shade` is `Tracing::shade`.
//!
//! Law: what arrives along a ray is `T · Σ terms`, the terms in the order in which the recorder
//! hears them, each one local or `weight · L(child)`, and `T` the transmittance of the medium.

mod optics;
mod recorder;
mod shading_point;
mod strategy;
mod tree;

use arrayvec::ArrayVec;

use crate::lights::{LightContext, LightSample, Meets, Segment};
use crate::lobes::{Bsdf, BsdfSample, Lit, Lobe, MOST_LOBES};
use crate::materials::Response;
use crate::math::{Point, Ray, Span, UNIT_ROUNDOFF, Vector};
use crate::rgb::Rgb;
use crate::samplers::{Draws, PathKey, Purpose};
use crate::world::{Hit, PlacedLight, World};

pub use optics::Optics;
pub use recorder::{Outcome, RayCounts, RayKind, Recorder, Term, TermSource};
pub use shading_point::ShadingPoint;
pub use strategy::{Scatter, Strategy};
pub use tree::{Node, RayTree, RecordedHit, RecordedTerm};

/// The radiance that arrives at the origin of a ray from the camera. The direction must be unit:
/// distances through media are counted in `t`.
pub fn radiance<R: Recorder>(world: &World, ray: &Ray, draws: Draws<'_>, recorder: &mut R) -> Rgb {
    let (kind, key, medium) = (RayKind::Camera, PathKey::CAMERA, world.view.medium.absorption);
    let path = PathState { ray: *ray, kind, depth: 0, key, medium };
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
            sum.add(self.recorder, TermSource::Background, Rgb::WHITE, radiance);
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
            if !emitted.is_black() {
                sum.add(self.recorder, TermSource::Emission, Rgb::WHITE, emitted);
            }
        }
        let mut response = Response::default();
        material.respond(&hit.surface, point.cos_o, &mut response);
        let bsdf = Bsdf::new(&response.lobes, point.normals, point.wo);
        self.recorder.surface(&point, &response.lobes);

        let world = self.world;
        for light in &world.lights {
            match light.light.meets() {
                Meets::Ambient => self.ambient(path, &point, light, response.ambient, sum),
                Meets::Lobes => self.direct(path, &point, light, &bsdf, sum),
            }
        }
        if self.strategy.scatter == Scatter::TracedLobes {
            for (lobe, kind) in response.lobes.iter().filter(|(lobe, _)| !lobe.is_lit()) {
                let u = match lobe.is_specular() {
                    true => [0.5; 2], // a single direction: nothing is drawn
                    false => {
                        self.draw(Purpose::Direction { path: path.key, branch: lobe.branch() })
                    }
                };
                if let Some(sample) = bsdf.sample(lobe, *kind, u) {
                    self.follow(path, &point, lobe, sample, sum);
                }
            }
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
        /// More than any light draws.
        const MOST_DRAWS: usize = 4;
        let from = LightContext { point: point.hit.surface.point, normal: point.normals.shading };
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
        if !bsdf.is_lit() {
            return;
        }
        let Some(sample) = self.sample(path, point, light) else { return };
        let pdf = sample.pdf;
        let lit = bsdf.lit(sample.direction);
        let terms: ArrayVec<_, MOST_LOBES> = lit
            .into_iter()
            .map(|lit| (lit, (lit.cos_i / pdf.unwrap_or(1.0)) * lit.f))
            .filter(|(_, weight)| !weight.is_black())
            .collect();
        if terms.is_empty() {
            return;
        }
        let medium = medium_towards(path, point, sample.direction);
        let (arriving, traced) = self.arriving(medium, point, light, &sample);
        for (Lit { lobe, f, cos_i }, weight) in terms {
            let source = TermSource::Direct { light: light.place, lobe, f, cos_i, pdf, traced };
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
        match sample.segment {
            Some(segment) if light.shadows => {
                // where an interpolated normal differs from the true one, the surface hides part of
                // the hemisphere itself, also if it is open and nothing else is behind it
                if point.normals.geometry.dot(sample.direction) <= 0.0 {
                    return (sample.blocked, false);
                }
                (self.shadow(medium, point, light.place, (segment, sample)), true)
            }
            _ => (sample.radiance, false),
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
        BsdfSample { direction, weight, transmits, .. }: BsdfSample,
        sum: &mut RadianceSum,
    ) {
        let child = PathState {
            ray: Ray::new(point.hit.surface.leave(direction), direction),
            kind: if transmits { RayKind::Transmitted } else { RayKind::Reflected },
            depth: path.depth + 1,
            key: path.key.then(lobe.branch()),
            medium: medium_towards(path, point, direction),
        };
        let light = self.cast(&child, weight);
        sum.add(self.recorder, TermSource::Traced { lobe: *lobe }, weight, light);
    }
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
