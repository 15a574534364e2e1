//! Light straight from lights: their samples, and the rays that say what is in the way.

use arrayvec::ArrayVec;

use super::{
    Lamps, Outcome, PathState, RadianceSum, RayKind, Recorder, ShadingPoint, Term, TermSource,
    Tracing, context, medium_towards, power_heuristic,
};
use crate::lights::{LightSample, MOST_DRAWS, Segment};
use crate::lobes::{Bsdf, Lit, MOST_LOBES, Which};
use crate::math::{Point, Ray, Span, UNIT_ROUNDOFF};
use crate::rgb::Rgb;
use crate::samplers::Purpose;
use crate::world::PlacedLight;

impl<R: Recorder> Tracing<'_, R> {
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
    pub(super) fn ambient(
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
    pub(super) fn direct(
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
}

/// The segment from `origin` to a light, in units of its length, without its ends: objects behind
/// the light do not block it, and a surface that the light lies on does not either.
fn up_to(light: Point, origin: Point) -> Span {
    let size = light.to_vector().max_abs() + origin.to_vector().max_abs();
    // of the place of the light, and of the t of a surface there that the ray does not graze
    let rounding = 64.0 * UNIT_ROUNDOFF * size / light.distance(origin);
    Span { min: 0.0, max: 1.0 - rounding }
}
