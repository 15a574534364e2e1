//! Direct light: samples of the lights.

use arrayvec::ArrayVec;

use super::{
    Lamps, PathState, RadianceSum, Recorder, ShadingPoint, TermSource, Tracing, context,
    medium_towards, power_heuristic,
};
use crate::lights::{LightSample, MAX_DRAWS};
use crate::lobes::{Bsdf, Lit, MAX_LOBES, Which};
use crate::rgb::Rgb;
use crate::samplers::Purpose;
use crate::world::PlacedLight;

impl<R: Recorder> Tracing<'_, R> {
    /// A light's sample at a shading point, for the random numbers drawn there.
    fn sample(
        &mut self,
        path: &PathState,
        point: &ShadingPoint<'_>,
        light: &PlacedLight,
    ) -> Option<LightSample> {
        let from = context(point);
        let mut u = ArrayVec::<[f64; 2], MAX_DRAWS>::new();
        for pair in 0..light.light.draws() as u32 {
            u.push(self.draw(Purpose::Light { path: path.key, light: light.index, pair }));
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
        let source = TermSource::Ambient { light: light.index, traced };
        sum.add(self.recorder, source, reflectance, arriving);
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
        let which = if self.strategy.is_path() { Which::Spread } else { Which::Lit };
        if !bsdf.is_lit(which) {
            return;
        }
        let Some(sample) = self.sample(path, point, light) else { return };
        let pdf = sample.pdf;
        let weighted = pdf.filter(|_| self.strategy.lamps == Lamps::Weighted);
        let mis = weighted.map(|pdf| power_heuristic(pdf, bsdf.pdf(sample.direction)));
        let lit = bsdf.lit(which, sample.direction);
        let terms: ArrayVec<_, MAX_LOBES> = lit
            .into_iter()
            .map(|lit| (lit, (lit.cos_i / pdf.unwrap_or(1.0)) * lit.f))
            .map(|(lit, weight)| (lit, mis.map_or(weight, |mis| mis * weight)))
            .filter(|(_, weight)| counts(*weight, &sample))
            .collect();
        if terms.is_empty() {
            return;
        }
        let medium = medium_towards(path.medium, point, sample.direction);
        let (arriving, traced) = self.arriving(medium, point, light, &sample);
        for (Lit { lobe, f, cos_i }, weight) in terms {
            let source =
                TermSource::Direct { light: light.index, lobe, f, cos_i, pdf, mis, traced };
            sum.add(self.recorder, source, weight, arriving);
        }
    }
}

/// Whether light of this weight can change a picture, whose numbers are single precision. Far from its
/// mirror direction a sharp highlight weighs less, and needs no shadow ray. A larger threshold would
/// darken sums of many lights.
fn counts(weight: Rgb, sample: &LightSample) -> bool {
    /// 2⁻¹⁴⁹.
    const SMALLEST: f64 = f32::from_bits(1) as f64;
    [sample.radiance, sample.blocked].into_iter().any(|sent| (weight * sent).max() >= SMALLEST)
}
