//! Scattered rays from a hit: a tree of them, or a path.

use super::{
    Budget, PathState, PreviousVertex, RadianceSum, RayKind, Recorder, Scatter, ShadingPoint,
    TermSource, Tracing, absorption_towards,
};
use crate::lobes::{Bsdf, BsdfSample, Lobe};
use crate::math::Ray;
use crate::rgb::Rgb;
use crate::samplers::Purpose;

/// The continuation of a path by one lobe.
struct Continuation {
    previous: Option<PreviousVertex>,
    throughput: Rgb,
    /// The probability with which it took the lobe.
    lobe_probability: f64,
    /// The probability with which it went on.
    survival: f64,
}

impl<R: Recorder, B: Budget> Tracing<'_, R, B> {
    /// Follows each lobe that does not accept the samples of lights.
    pub(super) fn follow_each(
        &mut self,
        path: &PathState,
        point: &ShadingPoint<'_>,
        bsdf: &Bsdf<'_>,
        sum: &mut RadianceSum,
    ) {
        for (lobe, kind) in bsdf.lobes().iter().filter(|(lobe, _)| !lobe.is_lit()) {
            let u = self.direction_u(path, lobe);
            if let Some(sample) = bsdf.sample(lobe, *kind, u) {
                let throughput = path.throughput;
                let continuation = Continuation {
                    previous: None,
                    throughput,
                    lobe_probability: 1.0,
                    survival: 1.0,
                };
                self.follow(path, point, lobe, sample, continuation, sum);
            }
        }
    }

    /// Follows one lobe, chosen with a probability about proportional to its albedo; with Russian
    /// roulette perhaps none.
    pub(super) fn follow_one(
        &mut self,
        path: &PathState,
        point: &ShadingPoint<'_>,
        bsdf: &Bsdf<'_>,
        sum: &mut RadianceSum,
    ) {
        /// Russian roulette starts at this depth: earlier, its noise costs more than the time it
        /// saves.
        const ROULETTE_FROM: u32 = 5;
        let probabilities = bsdf.lobe_probabilities();
        if probabilities.iter().all(|probability| *probability == 0.0) {
            return; // nothing is scattered
        }
        let uses_roulette =
            self.strategy.scatter == Scatter::OneLobeOrNone && path.depth >= ROULETTE_FROM;
        let is_certain = probabilities.contains(&1.0);
        // one pair serves the choice and the roulette; without either none is drawn
        let [u_lobe, u_roulette] = match uses_roulette || !is_certain {
            true => self.draw(Purpose::Lobe { path: path.key }),
            false => [0.0; 2],
        };
        let mut cumulative = 0.0;
        let chosen = probabilities.iter().position(|probability| {
            cumulative += probability;
            u_lobe < cumulative
        });
        let Some(chosen) = chosen else { return };
        let (lobe, kind) = &bsdf.lobes()[chosen];
        let u = self.direction_u(path, lobe);
        let Some(mut sample) = bsdf.sample(lobe, *kind, u) else { return };
        sample.weight = sample.weight / probabilities[chosen];
        let eta = sample.refracted.unwrap_or(1.0);
        let mut throughput = path.throughput * ((eta * eta) * sample.weight);
        let mut survival = 1.0;
        if uses_roulette {
            survival = throughput.max().min(1.0);
            if u_roulette >= survival {
                return;
            }
            sample.weight = sample.weight / survival;
            throughput = throughput / survival;
        }
        let sampled = self.strategy.samples_lights(path.depth) && sample.pdf.is_some();
        let previous = sampled.then(|| {
            let pdf = bsdf.pdf(sample.direction);
            PreviousVertex { light_context: point.light_context(), pdf }
        });
        let continuation = Continuation {
            previous,
            throughput,
            lobe_probability: probabilities[chosen],
            survival,
        };
        self.follow(path, point, lobe, sample, continuation, sum);
    }

    /// The random numbers for the direction of a lobe; a single direction needs none.
    fn direction_u(&mut self, path: &PathState, lobe: &Lobe) -> [f64; 2] {
        match lobe.is_specular() {
            true => [0.5; 2],
            false => self.draw(Purpose::Direction { path: path.key, branch: lobe.branch() }),
        }
    }

    /// Follows the ray of a lobe's sample.
    fn follow(
        &mut self,
        path: &PathState,
        point: &ShadingPoint<'_>,
        lobe: &Lobe,
        sample: BsdfSample,
        continuation: Continuation,
        sum: &mut RadianceSum,
    ) {
        let BsdfSample { direction, mut weight, pdf, refracted } = sample;
        if let Some(eta) = refracted.filter(|_| !self.world.transparency.scales_radiance) {
            weight = (eta * eta) * weight;
        }
        let Continuation { previous, throughput, lobe_probability, survival } = continuation;
        let child = PathState {
            ray: Ray::new(point.hit.surface.leave(direction), direction),
            kind: if refracted.is_some() { RayKind::Transmitted } else { RayKind::Reflected },
            depth: path.depth + 1,
            key: path.key.then(lobe.branch()),
            medium: absorption_towards(path.medium, point, direction),
            previous,
            throughput,
        };
        let light = self.cast(&child, weight);
        let source = TermSource::Traced { lobe: *lobe, pdf, lobe_probability, survival };
        sum.add(self.recorder, source, weight, light);
    }
}
