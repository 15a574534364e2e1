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
mod tree;

use crate::lights::{Illumination, LightSample, Reach};
use crate::lobes::{About, Lobe, LobeSample, Lobes};
use crate::materials::Response;
use crate::math::{Frame, Point, Ray, Span, UNIT_ROUNDOFF};
use crate::rgb::Rgb;
use crate::scene::Tracer;
use crate::world::{Hit, PlacedLight, World};

pub use optics::Optics;
pub use recorder::{Outcome, RayCounts, RayKind, Recorder, Term, TermSource};
pub use shading_point::ShadingPoint;
pub use tree::{Node, RayTree, RecordedHit, RecordedTerm};

/// The radiance that arrives at the origin of a ray from the camera. The direction must be unit:
/// distances through media are counted in `t`.
pub fn radiance<R: Recorder>(world: &World, ray: &Ray, recorder: &mut R) -> Rgb {
    let max_depth = match world.tracer {
        Tracer::RayCast => None,
        Tracer::Whitted(whitted) => Some(whitted.max_depth),
    };
    let medium = world.view.medium.absorption;
    let path = PathState { ray: *ray, kind: RayKind::Camera, depth: 0, medium };
    Tracing { world, max_depth, recorder }.cast(&path, Rgb::WHITE)
}

/// A ray to be cast, and what it carries along its path.
struct PathState {
    ray: Ray,
    kind: RayKind,
    /// The number of edges before it; 0 for the camera's ray.
    depth: u32,
    /// The absorption of the medium it is in.
    medium: Rgb,
}

struct Tracing<'a, R> {
    world: &'a World,
    /// `None` for ray casting, which follows no mirrors and no glass.
    max_depth: Option<u32>,
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
        let PathState { ray, kind, depth, medium } = path;
        self.recorder.enter(*kind, ray, *depth, weight);
        let mut sum = RadianceSum(Rgb::BLACK);
        let mut transmittance = Rgb::WHITE;
        if self.max_depth.is_some_and(|max_depth| *depth > max_depth) {
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
        let emitted = material.emitted(&hit.surface, point.cos_o);
        if !emitted.is_black() {
            sum.add(self.recorder, TermSource::Emission, Rgb::WHITE, emitted);
        }
        let mut response = Response::default();
        material.respond(&hit.surface, point.cos_o, &mut response);
        self.recorder.surface(&point, &response.lobes);

        let world = self.world;
        for light in &world.lights {
            match light.light.illuminate(hit.surface.point) {
                Illumination::Ambient(radiance) => {
                    if !response.ambient.is_black() {
                        let source = TermSource::Ambient { light: light.place };
                        sum.add(self.recorder, source, response.ambient, radiance);
                    }
                }
                Illumination::From(sample) => {
                    self.direct(&point, &response.lobes, light, &sample, sum)
                }
            }
        }
        if self.max_depth.is_some() {
            for (lobe, about) in response.lobes.iter().filter(|(l, _)| l.is_specular()) {
                let frame = point.frame(*about);
                let wo = frame.to_local(point.wo);
                if let Some(sample) = lobe.sample(wo, [0.5; 2]) {
                    self.follow(path, &point, lobe, (&frame, sample), sum);
                }
            }
        }
    }

    /// Light that comes straight from a source, by each lobe that takes light from there.
    fn direct(
        &mut self,
        point: &ShadingPoint<'_>,
        lobes: &Lobes,
        light: &PlacedLight,
        sample: &LightSample,
        sum: &mut RadianceSum,
    ) {
        let (traced, pdf) = (light.shadows, sample.pdf);
        let mut terms = arrayvec::ArrayVec::<(&Lobe, Rgb, f64, Rgb), 4>::new();
        for (lobe, about) in lobes.iter().filter(|(lobe, _)| !lobe.is_specular()) {
            let n = point.normal(*about);
            let cos_i = n.dot(sample.direction);
            if cos_i <= 0.0 {
                continue; // the light is behind the surface
            }
            let frame = Frame::around(n);
            let [wo, wi] = [point.wo, sample.direction].map(|w| frame.to_local(w));
            let f = match point.cos_o > 0.0 {
                true => lobe.f_outside(wo, wi),
                false if wo.z() <= 0.0 => lobe.f(wo, wi),
                // the viewer is below the true surface: this light cannot reach it
                false => Rgb::BLACK,
            };
            let weight = (cos_i / pdf) * f;
            if !weight.is_black() {
                terms.push((lobe, f, cos_i, weight));
            }
        }
        if terms.is_empty() {
            return;
        }
        let arriving =
            if traced { self.shadow(point, light.place, sample) } else { sample.radiance };
        for (&lobe, f, cos_i, weight) in terms {
            let source = TermSource::Direct { light: light.place, lobe, f, cos_i, pdf, traced };
            sum.add(self.recorder, source, weight, arriving);
        }
    }

    /// Whether an object stands in the way of a light, and so what arrives.
    fn shadow(&mut self, point: &ShadingPoint<'_>, light: u32, sample: &LightSample) -> Rgb {
        let origin = point.hit.surface.leave(sample.direction);
        let (ray, span) = match sample.reach {
            Reach::Infinity => (Ray::new(origin, sample.direction), Span::AHEAD),
            Reach::To(place) => (Ray::new(origin, place - origin), up_to(place, origin)),
        };
        self.recorder.enter(RayKind::Shadow { light }, &ray, 0, Rgb::WHITE);
        let occluder = self.world.occluder(&ray, span);
        let arriving = if occluder.is_some() { sample.blocked } else { sample.radiance };
        self.recorder.outcome(match occluder {
            Some(object) => Outcome::Blocked { blocked_by: object.place },
            None => Outcome::Unblocked,
        });
        let source = TermSource::Light { light };
        self.recorder.term(Term { source, weight: Rgb::WHITE, arriving, value: arriving });
        self.recorder.leave(Rgb::WHITE, arriving);
        arriving
    }

    /// Follows a mirrored or refracted ray.
    fn follow(
        &mut self,
        path: &PathState,
        point: &ShadingPoint<'_>,
        lobe: &Lobe,
        (frame, LobeSample { wi, weight, .. }): (&Frame, LobeSample),
        sum: &mut RadianceSum,
    ) {
        let direction = frame.to_world(wi);
        let n = point.normal(About::Geometry);
        let outward = n.dot(direction) > 0.0;
        let stays = outward == (point.cos_o > 0.0);
        let transmits = wi.z() * frame.to_local(point.wo).z() < 0.0;
        if stays == transmits {
            return; // an interpolated normal sends it to the wrong side of the true surface
        }
        let medium = match point.hit.material.recipe.boundary() {
            Some(boundary) if outward => boundary.outside.absorption,
            Some(boundary) => boundary.inside.absorption,
            None => path.medium,
        };
        let Some(direction) = direction.unit() else {
            return; // an index of refraction so far from 1 that the direction overflows
        };
        let child = PathState {
            ray: Ray::new(point.hit.surface.leave(direction), direction),
            kind: if transmits { RayKind::Transmitted } else { RayKind::Reflected },
            depth: path.depth + 1,
            medium,
        };
        let light = self.cast(&child, weight);
        sum.add(self.recorder, TermSource::Traced { lobe: *lobe }, weight, light);
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
