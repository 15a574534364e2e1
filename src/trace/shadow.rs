//! Shadow rays: the visible part of a light's sample (Suffern, ch. 16).

use super::{
    Budget, Outcome, RadianceSum, RayKind, Recorder, ShadingPoint, TermSource, Tracing,
    absorption_towards,
};
use crate::lights::{LightSample, Segment};
use crate::lobes::NormalKind;
use crate::materials::Response;
use crate::math::{Point, Ray, Span, UNIT_ROUNDOFF, Vector};
use crate::rgb::Rgb;
use crate::scene::TransparentShadows;
use crate::world::{Hit, PlacedLight, Search};

/// The light of a sample that arrives at a surface.
#[derive(Clone, Copy)]
pub(super) struct Arrival {
    pub radiance: Rgb,
    /// Whether a shadow ray found it.
    pub traced: bool,
}

/// The surfaces that end a shadow ray.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Blockers {
    /// None: the light casts no shadows.
    None,
    /// Those that cast shadows and transmit no light.
    Opaque,
    /// Those that cast shadows.
    Casting,
    /// All, also those that cast no shadow. For lights that paths can hit: where a path reaches
    /// such a light by itself, a sample of the light would count it twice.
    All,
}

/// The straight way from a point to a light.
struct Way {
    origin: Point,
    /// Unit.
    direction: Vector,
    segment: Segment,
}

/// What lies between a point and a light.
struct Between {
    /// An object that ends the search.
    blocked_by: Option<u32>,
    /// The number of transparent surfaces between them.
    boundaries: u32,
    /// The share of light that all these surfaces transmit.
    passed: Rgb,
    /// The transmittance of the media.
    transmittance: Rgb,
}

impl<R: Recorder, B: Budget> Tracing<'_, R, B> {
    /// The radiance of a light's sample that arrives.
    pub(super) fn arriving(
        &mut self,
        medium: Rgb,
        point: &ShadingPoint<'_>,
        light: &PlacedLight,
        sample: &LightSample,
    ) -> Arrival {
        let blockers = self.blockers(light);
        match sample.segment {
            // The hemisphere is about the interpolated normal. The surface itself hides the part of it
            // below the true normal's horizon, also if the surface is open.
            Some(_) if blockers != Blockers::None && !point.is_outward(sample.direction) => {
                Arrival { radiance: sample.blocked, traced: false }
            }
            Some(segment) if blockers != Blockers::None || self.may_leave(medium) => {
                let origin = point.hit.surface.leave(sample.direction);
                let way = Way { origin, direction: sample.direction, segment };
                let radiance = self.shadow(medium, way, blockers, light, sample);
                Arrival { radiance, traced: true }
            }
            // one medium everywhere: it absorbs over the whole distance, without a ray
            segment => {
                let from = point.hit.surface.point;
                let length = segment.map_or(0.0, |segment| segment.length(from));
                Arrival { radiance: medium.transmittance(length) * sample.radiance, traced: false }
            }
        }
    }

    /// Casts a shadow ray and returns the radiance of the light's sample that arrives.
    fn shadow(
        &mut self,
        medium: Rgb,
        way: Way,
        blockers: Blockers,
        light: &PlacedLight,
        sample: &LightSample,
    ) -> Rgb {
        self.budget.spend();
        let stretch = way.stretch();
        self.recorder.enter(RayKind::Shadow { light: light.index }, &stretch.0, 0, Rgb::WHITE);
        let Between { blocked_by, boundaries, passed, transmittance } =
            self.between(medium, way, stretch, blockers);
        let mut sum = RadianceSum(Rgb::BLACK);
        let held_off = passed.map(|passed| 1.0 - passed);
        for (weight, sent) in [(passed, sample.radiance), (held_off, sample.blocked)] {
            if !weight.is_black() {
                sum.add(self.recorder, TermSource::Light { light: light.index }, weight, sent);
            }
        }
        let arriving = transmittance * sum.0;
        let blocked = blocked_by.map(|blocked_by| Outcome::Blocked { blocked_by });
        let outcome = blocked.unwrap_or(Outcome::Unblocked { boundaries });
        self.recorder.leave(outcome, transmittance, arriving);
        arriving
    }

    /// The surfaces that end a shadow ray of this light.
    fn blockers(&self, light: &PlacedLight) -> Blockers {
        match self.world.transparency.shadows {
            _ if self.strategy.meets(&*light.light) => Blockers::All,
            _ if !light.shadows => Blockers::None,
            TransparentShadows::Opaque => Blockers::Casting,
            TransparentShadows::Attenuated => Blockers::Opaque,
        }
    }

    /// Whether light may leave a medium that absorbs it on a straight way.
    fn may_leave(&self, medium: Rgb) -> bool {
        !medium.is_black() && self.world.has_boundaries
    }

    /// What a shadow ray meets. If all that ends it is opaque, any blocker will do.
    fn between(
        &mut self,
        medium: Rgb,
        way: Way,
        (ray, span, length): (Ray, Span, f64),
        blockers: Blockers,
    ) -> Between {
        let blocked_by = match blockers {
            Blockers::None => None,
            Blockers::Opaque => return self.straight_through(medium, way, blockers),
            Blockers::All if !self.world.all_cast_shadows => {
                self.first_hit(&ray, span).map(|hit| hit.object.index)
            }
            Blockers::Casting | Blockers::All => {
                self.recorder.search(Search::Occluder, &ray, span);
                self.world.occluder(&ray, span).map(|object| object.index)
            }
        };
        if blocked_by.is_none() && self.may_leave(medium) {
            return self.straight_through(medium, way, blockers);
        }
        let passed = if blocked_by.is_some() { Rgb::BLACK } else { Rgb::WHITE };
        Between { blocked_by, boundaries: 0, passed, transmittance: medium.transmittance(length) }
    }

    /// Follows a shadow ray straight through the surfaces that do not block it, an approximation.
    /// Each transparent surface that casts shadows transmits its share for the straight ray's angle
    /// on the side of the smaller index, and each stretch between surfaces its medium's
    /// transmittance. Bodies that cast no shadow do not absorb, unless the point is in them.
    fn straight_through(&mut self, mut medium: Rgb, mut way: Way, blockers: Blockers) -> Between {
        let (passed, transmittance) = (Rgb::WHITE, Rgb::WHITE);
        let mut between = Between { blocked_by: None, boundaries: 0, passed, transmittance };
        // bodies without a shadow that the ray has entered and not left
        let mut entered = 0_u32;
        loop {
            let (ray, span, length) = way.stretch();
            let hit = self.first_hit(&ray, span);
            let end = hit.as_ref().map_or(length, |hit| hit.t * ray.direction.length());
            between.transmittance = between.transmittance * medium.transmittance(end);
            let Some(hit) = hit else { return between };
            let casts_shadow = blockers == Blockers::Opaque && hit.casts_shadow();
            if casts_shadow {
                between.passed = between.passed * transmitted(&hit, way.direction);
                if between.passed.is_black() {
                    return Between { blocked_by: Some(hit.object.index), ..between };
                }
            }
            way.origin = hit.surface.leave(way.direction);
            let is_boundary = hit.material.recipe.boundary().is_some();
            between.boundaries += u32::from(casts_shadow || is_boundary);
            let point = ShadingPoint::new(&hit, -way.direction);
            let beyond = absorption_towards(medium, &point, way.direction);
            let absorbs_less = beyond.average() < medium.average();
            let leaves = point.is_outward(way.direction);
            if casts_shadow || absorbs_less || leaves && entered == 0 {
                medium = beyond;
            }
            if is_boundary && !casts_shadow {
                entered = match leaves {
                    true => entered.saturating_sub(1),
                    false => entered + u32::from(!absorbs_less),
                };
            }
        }
    }
}

impl Way {
    /// The ray from its origin to the light, without the light itself, and its length.
    fn stretch(&self) -> (Ray, Span, f64) {
        let Self { origin, direction, segment } = *self;
        let (ray, span) = match segment {
            Segment::Infinity => (Ray::new(origin, direction), Span::AHEAD),
            Segment::To(end) => (Ray::new(origin, end - origin), up_to(end, origin)),
        };
        (ray, span, segment.length(origin))
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

/// The share of light that a surface transmits along a straight line, without the `1/η²` of
/// radiance; black if it is opaque. The ray's angle is taken on the side of the smaller index. On
/// the other side it could exceed the critical angle, but light that enters a pane from outside
/// always passes it.
fn transmitted(hit: &Hit<'_>, direction: Vector) -> Rgb {
    let recipe = &hit.material.recipe;
    if !recipe.transmits() {
        return Rgb::BLACK;
    }
    let sides = [-direction, direction].map(|wo| ShadingPoint::new(hit, wo));
    let from_thinner = |point: &ShadingPoint<'_>| {
        let mut response = Response::default();
        recipe.respond(&hit.texture_point(), point.cos_o, &mut response);
        let wo = point.frame(NormalKind::Geometry).to_local(point.wo);
        let eta = response.lobes.iter().find_map(|(lobe, _)| lobe.relative_eta(wo))?;
        let refracting = response.lobes.iter().filter(|(lobe, _)| lobe.refracts());
        let share: Rgb = refracting.map(|(lobe, _)| lobe.albedo(wo)).sum();
        (eta >= 1.0).then_some((eta * eta) * share)
    };
    sides.iter().find_map(from_thinner).unwrap_or(Rgb::BLACK)
}
