//! Direct light: samples of the lights.

use arrayvec::ArrayVec;

use super::shadow::Arrival;
use super::{
    Budget, EmitterHits, PathState, RadianceSum, Recorder, ShadingPoint, TermSource, Tracing,
    absorption_towards, power_heuristic,
};
use crate::lights::LightSample;
use crate::lobes::{Bsdf, Lit, MAX_LOBES};
use crate::rgb::Rgb;
use crate::world::PlacedLight;

impl<R: Recorder, B: Budget> Tracing<'_, R, B> {
    /// A light's sample at a shading point, for the random numbers drawn there.
    fn sample(
        &mut self,
        path: &PathState,
        point: &ShadingPoint<'_>,
        light: &PlacedLight,
    ) -> Option<LightSample> {
        let u = light.numbers(path.key, |purpose| self.draw(purpose));
        light.light.sample(&point.light_context(), &u)
    }

    /// The ambient term: ambient light times the ambient reflectance.
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
        let Arrival { radiance, traced } = self.arriving(Rgb::BLACK, point, light, &sample);
        let source = TermSource::Ambient { light: light.index, traced };
        sum.add(self.recorder, source, reflectance, radiance);
    }

    /// Direct light of a light, reflected by each lobe that accepts its samples.
    pub(super) fn direct(
        &mut self,
        path: &PathState,
        point: &ShadingPoint<'_>,
        light: &PlacedLight,
        bsdf: &Bsdf<'_>,
        sum: &mut RadianceSum,
    ) {
        let set = self.strategy.lit_lobes();
        if !bsdf.is_lit(set) {
            return;
        }
        let Some(sample) = self.sample(path, point, light) else { return };
        let lit = bsdf.lit(set, sample.direction);
        if lit.is_empty() {
            return;
        }
        let pdf = sample.pdf;
        let weighted = pdf.filter(|_| self.strategy.emitter_hits == EmitterHits::Mis);
        let mis = weighted.map(|pdf| power_heuristic(pdf, bsdf.pdf(sample.direction)));
        let terms: ArrayVec<_, MAX_LOBES> = lit
            .into_iter()
            .map(|lit| (lit, (lit.cos_i / pdf.unwrap_or(1.0)) * lit.f))
            .map(|(lit, weight)| (lit, mis.map_or(weight, |mis| mis * weight)))
            .filter(|(_, weight)| is_representable(*weight, &sample))
            .collect();
        if terms.is_empty() {
            return;
        }
        let medium = absorption_towards(path.medium, point, sample.direction);
        let Arrival { radiance, traced } = self.arriving(medium, point, light, &sample);
        for (Lit { lobe, f, cos_i }, weight) in terms {
            let source =
                TermSource::Direct { light: light.index, lobe: *lobe, f, cos_i, pdf, mis, traced };
            sum.add(self.recorder, source, weight, radiance);
        }
    }
}

/// Whether light of this weight is at least the smallest single-precision number, in which pictures
/// are kept. Far from its mirror direction a sharp highlight weighs less, and needs no shadow ray.
/// A larger threshold would darken sums of many lights.
fn is_representable(weight: Rgb, sample: &LightSample) -> bool {
    /// 2⁻¹⁴⁹.
    const SMALLEST: f64 = f32::from_bits(1) as f64;
    [sample.radiance, sample.blocked].into_iter().any(|sent| (weight * sent).max() >= SMALLEST)
}
