//! The one recursion: from a ray to the radiance that arrives along it (Suffern, ch. 3, 14, 24).
//!
//! Lights and lobes answer "from where, how much?" and never trace; only this module casts rays, so
//! each one passes `Tracing::cast` and is heard by the recorder. The book's tracers are settings
//! of it, and its `Material::shade` is `Tracing::shade`.
//!
//! Law: what arrives along a ray is `T · Σ terms`, the terms in the order in which the recorder
//! hears them, each one local or `weight · L(child)`, and `T` the transmittance of the medium.

mod recorder;
mod tree;

use crate::lights::{Illumination, LightSample, Reach};
use crate::lobes::{About, LobeSample, Lobes};
use crate::materials::{Boundary, Response};
use crate::math::{Frame, Normal, Point, Ray, Span, UNIT_ROUNDOFF, Vector};
use crate::rgb::Rgb;
use crate::scene::Tracer;
use crate::world::{Hit, PlacedLight, World};

pub use recorder::{Outcome, RayCounts, RayKind, Recorder, Term, What};
pub use tree::{Node, RayTree, RecordedHit, RecordedOutcome, RecordedTerm};

/// The radiance that arrives at the origin of a ray from the camera. The direction must be unit:
/// distances through media are counted in `t`.
pub fn radiance<R: Recorder>(world: &World, ray: &Ray, recorder: &mut R) -> Rgb {
    let max_depth = match world.tracer {
        Tracer::RayCast => None,
        Tracer::Whitted(whitted) => Some(whitted.max_depth),
    };
    let medium = world.view.medium.absorption;
    let traveller = Traveller { ray: *ray, kind: RayKind::Camera, depth: 0, medium };
    Tracing { world, max_depth, recorder }.cast(&traveller, Rgb::WHITE)
}

/// A ray on its way.
struct Traveller {
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
struct Sum(Rgb);

impl Sum {
    fn add<R: Recorder>(&mut self, recorder: &mut R, what: What, weight: Rgb, light: Rgb) {
        let value = weight * light;
        self.0 += value;
        recorder.term(Term { what, weight, value });
    }
}

impl<R: Recorder> Tracing<'_, R> {
    /// What arrives along a ray that counts `weight` for the one before it.
    fn cast(&mut self, traveller: &Traveller, weight: Rgb) -> Rgb {
        let Traveller { ray, kind, depth, medium } = traveller;
        self.recorder.enter(*kind, ray, *depth, weight);
        let mut sum = Sum(Rgb::BLACK);
        let mut transmittance = Rgb::WHITE;
        if self.max_depth.is_some_and(|max_depth| *depth > max_depth) {
            self.recorder.outcome(Outcome::TooDeep);
        } else if let Some(hit) = &self.world.hit(ray, Span::AHEAD) {
            self.recorder.outcome(Outcome::Hit(hit));
            transmittance = medium.transmittance(hit.t);
            self.shade(traveller, hit, &mut sum);
        } else {
            self.recorder.outcome(Outcome::Background);
            transmittance = medium.transmittance(f64::INFINITY);
            let radiance = self.world.background.radiance(ray);
            sum.add(self.recorder, What::Background, Rgb::WHITE, radiance);
        }
        let arriving = transmittance * sum.0;
        self.recorder.leave(transmittance, arriving);
        arriving
    }

    /// Adds up the light that leaves a surface towards the ray's origin.
    fn shade(&mut self, traveller: &Traveller, hit: &Hit<'_>, sum: &mut Sum) {
        let side = Side::of(hit, -traveller.ray.direction);
        let material = &hit.material.recipe;
        let emitted = material.emitted(&side.hit.surface, side.cos_o);
        if !emitted.is_black() {
            sum.add(self.recorder, What::Emission, Rgb::WHITE, emitted);
        }
        let mut response = Response::default();
        material.respond(&hit.surface, side.cos_o, &mut response);

        let world = self.world;
        for light in &world.lights {
            match light.light.illuminate(hit.surface.point) {
                Illumination::Ambient(radiance) => {
                    if !response.ambient.is_black() {
                        let what = What::Ambient { light: light.place };
                        sum.add(self.recorder, what, response.ambient, radiance);
                    }
                }
                Illumination::From(sample) => {
                    self.direct(&side, &response.lobes, light, &sample, sum)
                }
            }
        }
        if self.max_depth.is_some() {
            let boundary = material.boundary();
            for (lobe, about) in response.lobes.iter().filter(|(l, _)| l.is_specular()) {
                let frame = side.frame(*about);
                let wo = frame.to_local(side.wo);
                if let Some(sample) = lobe.sample(wo, [0.5; 2]) {
                    let what = What::Traced { lobe: lobe.name() };
                    self.follow(traveller, &side, boundary, what, (&frame, sample), sum);
                }
            }
        }
    }

    /// Light that comes straight from a source, by each lobe that takes light from there.
    fn direct(
        &mut self,
        side: &Side<'_>,
        lobes: &Lobes,
        light: &PlacedLight,
        sample: &LightSample,
        sum: &mut Sum,
    ) {
        let mut weights = arrayvec::ArrayVec::<(Rgb, &'static str), 4>::new();
        for (lobe, about) in lobes.iter().filter(|(lobe, _)| !lobe.is_specular()) {
            let n = side.normal(*about);
            let cos_i = n.dot(sample.direction);
            if cos_i <= 0.0 {
                continue; // the light is behind the surface
            }
            let frame = Frame::around(n);
            let [wo, wi] = [side.wo, sample.direction].map(|w| frame.to_local(w));
            let f = match side.cos_o > 0.0 {
                true => lobe.f_outside(wo, wi),
                false if wo.z() <= 0.0 => lobe.f(wo, wi),
                false => Rgb::BLACK, // it only looks as if he were outside
            };
            let weight = (cos_i / sample.pdf) * f;
            if !weight.is_black() {
                weights.push((weight, lobe.name()));
            }
        }
        if weights.is_empty() {
            return;
        }
        let arriving =
            if light.shadows { self.shadow(side, light.place, sample) } else { sample.radiance };
        for (weight, lobe) in weights {
            let what = What::Direct { light: light.place, lobe, traced: light.shadows };
            sum.add(self.recorder, what, weight, arriving);
        }
    }

    /// Whether an object stands in the way of a light, and so what arrives.
    fn shadow(&mut self, side: &Side<'_>, light: u32, sample: &LightSample) -> Rgb {
        let origin = side.hit.surface.leave(sample.direction);
        let (ray, span) = match sample.reach {
            Reach::Infinity => (Ray::new(origin, sample.direction), Span::AHEAD),
            Reach::To(place) => (Ray::new(origin, place - origin), up_to(place, origin)),
        };
        self.recorder.enter(RayKind::Shadow { light }, &ray, 0, Rgb::WHITE);
        let occluder = self.world.occluder(&ray, span);
        let arriving = if occluder.is_some() { sample.blocked } else { sample.radiance };
        self.recorder.outcome(occluder.map_or(Outcome::Unblocked, Outcome::Blocked));
        self.recorder.term(Term {
            what: What::Light { light },
            weight: Rgb::WHITE,
            value: arriving,
        });
        self.recorder.leave(Rgb::WHITE, arriving);
        arriving
    }

    /// Follows a mirrored or refracted ray.
    fn follow(
        &mut self,
        traveller: &Traveller,
        side: &Side<'_>,
        boundary: Option<Boundary>,
        what: What,
        (frame, LobeSample { wi, weight, .. }): (&Frame, LobeSample),
        sum: &mut Sum,
    ) {
        let direction = frame.to_world(wi);
        let n = side.normal(About::Geometry);
        let outward = n.dot(direction) > 0.0;
        let stays = outward == (side.cos_o > 0.0);
        let transmits = wi.z() * frame.to_local(side.wo).z() < 0.0;
        if stays == transmits {
            return; // an interpolated normal sends it to the wrong side of the true surface
        }
        let medium = match boundary {
            Some(boundary) if outward => boundary.outside,
            Some(boundary) => boundary.inside,
            None => traveller.medium,
        };
        let Some(direction) = direction.unit() else {
            return; // an index of refraction so far from 1 that the direction overflows
        };
        let child = Traveller {
            ray: Ray::new(side.hit.surface.leave(direction), direction),
            kind: if transmits { RayKind::Transmitted } else { RayKind::Reflected },
            depth: traveller.depth + 1,
            medium,
        };
        let light = self.cast(&child, weight);
        sum.add(self.recorder, what, weight, light);
    }
}

/// The segment from `origin` to a light, in units of its length, without its ends: objects behind
/// the light are not in the way, nor is the surface that the light may lie on.
fn up_to(light: Point, origin: Point) -> Span {
    let size = light.to_vector().max_abs() + origin.to_vector().max_abs();
    // of the place of the light, and of the t of a surface there that the ray does not graze
    let rounding = 64.0 * UNIT_ROUNDOFF * size / light.distance(origin);
    Span { min: 0.0, max: 1.0 - rounding }
}

/// A hit as the viewer sees it: the normals of a two-sided surface are turned to him.
struct Side<'a> {
    hit: &'a Hit<'a>,
    wo: Vector,
    turned: bool,
    cos_o: f64,
}

impl<'a> Side<'a> {
    fn of(hit: &'a Hit<'a>, wo: Vector) -> Self {
        let turned = hit.material.two_sided && !hit.front;
        let cos_o = hit.surface.normal.dot(wo);
        Self { hit, wo, turned, cos_o: if turned { -cos_o } else { cos_o } }
    }

    fn normal(&self, about: About) -> Normal {
        let n = match about {
            About::Shading => self.hit.surface.shading,
            About::Geometry => self.hit.surface.normal,
        };
        if self.turned { -n } else { n }
    }

    fn frame(&self, about: About) -> Frame {
        Frame::around(self.normal(about))
    }
}
