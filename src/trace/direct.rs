//! Direct light: samples of the lights.

use arrayvec::ArrayVec;

use super::shadow::Arrival;
use super::{
    Budget, EmitterHits, PathState, RadianceSum, Recorder, ShadingPoint, TermSource, Tracing,
    absorption_towards, light_context, power_heuristic,
};
use crate::lights::{LightSample, MAX_DRAWS, Unlit};
use crate::lobes::{Bsdf, Lit, LobeSet, MAX_LOBES};
use crate::rgb::Rgb;
use crate::samplers::Purpose;
use crate::world::PlacedLight;

impl<R: Recorder, B: Budget> Tracing<'_, R, B> {
    /// A light's sample at a shading point, for the random numbers drawn there.
    fn sample(
        &mut self,
        path: &PathState,
        point: &ShadingPoint<'_>,
        light: &PlacedLight,
    ) -> Option<LightSample> {
        let from = light_context(point);
        let mut u = ArrayVec::<[f64; 2], MAX_DRAWS>::new();
        for pair in 0..light.light.draws() as u32 {
            u.push(self.draw(Purpose::Light { path: path.key, light: light.index, pair }));
        }
        let sample = light.light.sample(&from, &u);
        if sample.is_none() {
            self.recorder.unlit(light.index, || light.light.unlit(&from, &u));
        }
        sample
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
            self.recorder.unlit(light.index, || Unlit::NoAmbientReflectance);
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
        let set = if self.strategy.is_path() { LobeSet::NonDelta } else { LobeSet::DirectOnly };
        if !bsdf.is_lit(set) {
            self.recorder.unlit(light.index, || unlit_surface(point, bsdf));
            return;
        }
        let Some(sample) = self.sample(path, point, light) else { return };
        let pdf = sample.pdf;
        let weighted = pdf.filter(|_| self.strategy.emitter_hits == EmitterHits::Mis);
        let mis = weighted.map(|pdf| power_heuristic(pdf, bsdf.pdf(sample.direction)));
        let lit = bsdf.lit(set, sample.direction);
        let terms: ArrayVec<_, MAX_LOBES> = lit
            .into_iter()
            .map(|lit| (lit, (lit.cos_i / pdf.unwrap_or(1.0)) * lit.f))
            .map(|(lit, weight)| (lit, mis.map_or(weight, |mis| mis * weight)))
            .filter(|(_, weight)| is_representable(*weight, &sample))
            .collect();
        if terms.is_empty() {
            self.recorder.unlit(light.index, || {
                unlit_sample(&sample, point, &bsdf.lit(set, sample.direction))
            });
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

/// Why samples of lights meet no lobe of a surface.
fn unlit_surface(point: &ShadingPoint<'_>, bsdf: &Bsdf<'_>) -> Unlit {
    match bsdf.lobes().is_empty() {
        true => Unlit::NoLobes,
        false if point.cos_o <= 0.0 => Unlit::ViewerBehind { cos_o: point.cos_o },
        false => Unlit::TracedLobesOnly,
    }
}

/// Why a light's sample contributes nothing: the first reason that holds. `lit` are the lobes' values for it.
fn unlit_sample(sample: &LightSample, point: &ShadingPoint<'_>, lit: &[Lit<'_>]) -> Unlit {
    let sent = sample.radiance + sample.blocked;
    let [shading, geometry] = [point.normals.shading, point.normals.geometry];
    let [cos_i, cos_true] = [shading, geometry].map(|normal| normal.dot(sample.direction));
    if sent.is_black() {
        Unlit::Dark
    } else if lit.iter().any(|lit| !(lit.f * sent).is_black()) {
        Unlit::TooWeak
    } else if !lit.is_empty() {
        Unlit::OtherColors
    } else if cos_i <= 0.0 {
        Unlit::BehindSurface { cos_i }
    } else if cos_true <= 0.0 {
        Unlit::BehindTrueSurface { cos_i: cos_true }
    } else {
        Unlit::OutsideLobes { cos_i }
    }
}

/// Whether light of this weight is at least the smallest single-precision number, in which pictures are kept. Far from its
/// mirror direction a sharp highlight weighs less, and needs no shadow ray. A larger threshold would
/// darken sums of many lights.
fn is_representable(weight: Rgb, sample: &LightSample) -> bool {
    /// 2⁻¹⁴⁹.
    const SMALLEST: f64 = f32::from_bits(1) as f64;
    [sample.radiance, sample.blocked].into_iter().any(|sent| (weight * sent).max() >= SMALLEST)
}
