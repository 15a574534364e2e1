//! Shadow rays: the visible part of a light's sample (Suffern, ch. 16).

use super::{
    Budget, Optics, Outcome, RayKind, Recorder, ShadingPoint, Term, TermSource, Tracing,
    absorption_towards,
};
use crate::lights::{LightSample, Segment, Unlit};
use crate::materials::Response;
use crate::math::{Point, Ray, Span, UNIT_ROUNDOFF, Vector};
use crate::rgb::Rgb;
use crate::scene::TransparentShadows;
use crate::world::{Hit, PlacedLight, Search};

/// What lies between a point and a light.
struct Between {
    /// An opaque object, which ends the search.
    blocked_by: Option<u32>,
    /// The number of transparent surfaces between them.
    boundaries: u32,
    /// The share of light that all these surfaces transmit.
    passed: Rgb,
    /// The transmittance of the media.
    transmittance: Rgb,
}

/// The surfaces that end a shadow ray.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Blockers {
    /// All, also those that cast no shadow. For lights that paths can hit: where a path reaches such a light
    /// by itself, a sample of the light would count it twice.
    All,
    /// Those that cast shadows.
    Casting,
    /// Those of them that transmit no light.
    Opaque,
}

impl<R: Recorder, B: Budget> Tracing<'_, R, B> {
    /// The radiance of a light's sample that arrives, and whether a shadow ray was cast.
    pub(super) fn arriving(
        &mut self,
        medium: Rgb,
        point: &ShadingPoint<'_>,
        light: &PlacedLight,
        sample: &LightSample,
    ) -> (Rgb, bool) {
        match sample.segment {
            Some(segment) if light.shadows || self.is_met(light) => {
                // The hemisphere is about the interpolated normal. The surface itself hides the part of it
                // below the true normal's horizon, also if the surface is open.
                let cos_i = point.normals.geometry.dot(sample.direction);
                if cos_i <= 0.0 {
                    if sample.blocked.is_black() {
                        self.recorder.unlit(light.index, || Unlit::BehindTrueSurface { cos_i });
                    }
                    return (sample.blocked, false);
                }
                (self.shadow(medium, point, light, segment, sample), true)
            }
            Some(segment) if !medium.is_black() && self.world.has_boundaries => {
                (self.unshadowed(medium, point, light, segment, sample), true)
            }
            // one medium everywhere: it absorbs over the whole distance, without a ray
            segment => {
                let from = point.hit.surface.point;
                let length = segment.map_or(0.0, |segment| segment.length(from));
                (medium.transmittance(length) * sample.radiance, false)
            }
        }
    }

    /// Casts the ray to a light without shadows from a point in an absorbing medium, and returns the
    /// radiance that arrives. Nothing blocks it: it only finds where it leaves the medium.
    fn unshadowed(
        &mut self,
        medium: Rgb,
        point: &ShadingPoint<'_>,
        light: &PlacedLight,
        segment: Segment,
        sample: &LightSample,
    ) -> Rgb {
        let origin = point.hit.surface.leave(sample.direction);
        let (ray, ..) = stretch(origin, sample.direction, segment);
        self.budget.spend();
        self.recorder.enter(RayKind::Shadow { light: light.index }, &ray, 0, Rgb::WHITE);
        let from = point.hit.surface.point;
        let (boundaries, transmittance) =
            self.way_out(medium, from, origin, sample.direction, segment);
        self.recorder.outcome(Outcome::Unblocked { boundaries });
        let (weight, value) = (Rgb::WHITE, sample.radiance);
        let source = TermSource::Light { light: light.index };
        self.recorder.term(Term { source, weight, arriving: value, value });
        let arriving = transmittance * value;
        self.recorder.leave(transmittance, arriving);
        arriving
    }

    /// Casts a shadow ray and returns the radiance of the light's sample that arrives.
    fn shadow(
        &mut self,
        medium: Rgb,
        point: &ShadingPoint<'_>,
        light: &PlacedLight,
        segment: Segment,
        sample: &LightSample,
    ) -> Rgb {
        let origin = point.hit.surface.leave(sample.direction);
        let (ray, span, length) = stretch(origin, sample.direction, segment);
        let kind = RayKind::Shadow { light: light.index };
        self.budget.spend();
        self.recorder.enter(kind, &ray, 0, Rgb::WHITE);
        let blockers = self.blockers(light);
        let is_simple = match blockers {
            Blockers::All => self.world.all_cast_shadows,
            Blockers::Casting => self.world.all_boundaries_cast_shadows,
            Blockers::Opaque => false,
        };
        let between = if !is_simple {
            self.straight_through(origin, sample.direction, segment, medium, blockers)
        } else {
            self.recorder.search(Search::Occluder, &ray, span);
            let blocked_by = self.world.occluder(&ray, span).map(|object| object.index);
            let passed = if blocked_by.is_some() { Rgb::BLACK } else { Rgb::WHITE };
            let transmittance = medium.transmittance(length);
            Between { blocked_by, boundaries: 0, passed, transmittance }
        };
        let Between { blocked_by, boundaries, passed, transmittance } = between;
        self.recorder.outcome(match blocked_by {
            Some(blocked_by) => Outcome::Blocked { blocked_by },
            None => Outcome::Unblocked { boundaries },
        });
        let mut sent = Rgb::BLACK;
        for (weight, arriving) in
            [(passed, sample.radiance), (passed.map(|passed| 1.0 - passed), sample.blocked)]
        {
            if !weight.is_black() {
                let value = weight * arriving;
                sent += value;
                let source = TermSource::Light { light: light.index };
                self.recorder.term(Term { source, weight, arriving, value });
            }
        }
        let arriving = transmittance * sent;
        self.recorder.leave(transmittance, arriving);
        arriving
    }

    /// Whether paths can hit this light.
    fn is_met(&self, light: &PlacedLight) -> bool {
        self.strategy.is_path() && light.light.is_met()
    }

    /// The surfaces that end a shadow ray of this light.
    fn blockers(&self, light: &PlacedLight) -> Blockers {
        match self.world.transparency.shadows {
            _ if self.is_met(light) => Blockers::All,
            TransparentShadows::Opaque => Blockers::Casting,
            TransparentShadows::Attenuated => Blockers::Opaque,
        }
    }

    /// Follows a shadow ray straight through the surfaces that do not block it, an approximation. Each
    /// transparent surface that casts shadows transmits its share for the straight ray's angle on the side
    /// of the smaller index, and each stretch between surfaces its medium's transmittance.
    fn straight_through(
        &mut self,
        mut origin: Point,
        direction: Vector,
        segment: Segment,
        mut medium: Rgb,
        blockers: Blockers,
    ) -> Between {
        let (mut boundaries, mut passed, mut transmittance) = (0, Rgb::WHITE, Rgb::WHITE);
        loop {
            let (ray, span, length) = stretch(origin, direction, segment);
            let hit = self.first_hit(&ray, span);
            let end = hit.as_ref().map_or(length, |hit| hit.t * ray.direction.length());
            transmittance = transmittance * medium.transmittance(end);
            let Some(hit) = hit else {
                return Between { blocked_by: None, boundaries, passed, transmittance };
            };
            origin = hit.surface.leave(direction);
            if blockers == Blockers::All || hit.casts_shadow() {
                passed = match blockers {
                    Blockers::Opaque => passed * transmitted(&hit, direction),
                    Blockers::All | Blockers::Casting => Rgb::BLACK,
                };
                if passed.is_black() {
                    let blocked_by = Some(hit.object.index);
                    return Between { blocked_by, boundaries, passed, transmittance };
                }
                boundaries += 1;
            }
            let point = ShadingPoint::new(&hit, -direction);
            let beyond = absorption_towards(medium, &point, direction);
            // light may leave a medium through what casts no shadow, but is not absorbed on its way in
            if hit.casts_shadow() || beyond.average() < medium.average() {
                medium = beyond;
            }
        }
    }

    /// The number of boundaries between media on the straight way from a point to a light without shadows,
    /// and the transmittance of the way: each stretch between boundaries counts with its medium. Bodies that
    /// the point is not in do not absorb, as they do not for a point in a clear medium.
    fn way_out(
        &mut self,
        mut medium: Rgb,
        mut from: Point,
        mut origin: Point,
        direction: Vector,
        segment: Segment,
    ) -> (u32, Rgb) {
        let (mut boundaries, mut transmittance) = (0, Rgb::WHITE);
        // bodies that the ray has entered and not left
        let mut entered = 0_u32;
        loop {
            let (ray, span, _) = stretch(origin, direction, segment);
            let Some(hit) = self.first_hit(&ray, span) else { break };
            origin = hit.surface.leave(direction);
            if hit.material.recipe.boundary().is_none() {
                continue;
            }
            boundaries += 1;
            let point = ShadingPoint::new(&hit, -direction);
            let beyond = absorption_towards(medium, &point, direction);
            let absorbs_less = beyond.average() < medium.average();
            let enters = point.normals.geometry.dot(direction) < 0.0;
            if absorbs_less || !(enters || entered > 0) {
                let end = hit.surface.point;
                transmittance = transmittance * medium.transmittance(end.distance(from));
                (from, medium) = (end, beyond);
            }
            entered = match enters {
                true if absorbs_less => entered,
                true => entered + 1,
                false => entered.saturating_sub(1),
            };
        }
        (boundaries, transmittance * medium.transmittance(segment.length(from)))
    }
}

/// The ray from `origin` to a light, without the light itself, and its length.
fn stretch(origin: Point, direction: Vector, segment: Segment) -> (Ray, Span, f64) {
    match segment {
        Segment::Infinity => (Ray::new(origin, direction), Span::AHEAD, segment.length(origin)),
        Segment::To(end) => {
            (Ray::new(origin, end - origin), up_to(end, origin), segment.length(origin))
        }
    }
}

/// The segment from `origin` to a light, in units of its length, without its ends: objects behind
/// the light do not block it, and a surface that the light lies on does not either.
fn up_to(light: Point, origin: Point) -> Span {
    let size = light.to_vector().max_abs() + origin.to_vector().max_abs();
    // of the light's position, and of the t of a surface there that the ray does not graze
    let rounding = 64.0 * UNIT_ROUNDOFF * size / light.distance(origin);
    Span { min: 0.0, max: 1.0 - rounding }
}

/// The share of light that a surface transmits along a straight line, without the `1/η²` of radiance;
/// black if it is opaque. The ray's angle is taken on the side of the smaller index. On the other side it
/// could exceed the critical angle, but light that enters a pane from outside always passes it.
fn transmitted(hit: &Hit<'_>, direction: Vector) -> Rgb {
    let recipe = &hit.material.recipe;
    if !recipe.transmits() {
        return Rgb::BLACK;
    }
    let sides = [-direction, direction].map(|wo| ShadingPoint::new(hit, wo));
    let from_thinner = |point: &ShadingPoint<'_>| {
        let mut response = Response::default();
        recipe.respond(&hit.texture_point(), point.cos_o, &mut response);
        Optics::of(point, &response.lobes).filter(|optics| optics.eta >= 1.0)
    };
    sides.iter().find_map(from_thinner).map_or(Rgb::BLACK, |optics| optics.transmitted)
}
