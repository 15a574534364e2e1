//! Cases whose samples are directions with a density: what the laws of integrals need of each kind.

use ask::Stop;
use groundtruth::math::Vector;
use serde_json::Value;

use super::Integrated;
use crate::case::LobeCase;
use crate::light::LightCase;
use crate::map::MapCase;
use crate::naming::{Factor, Given, LIGHTS, LOBES, MAPS};

/// A sample as a direction.
#[derive(Clone, Copy, Debug)]
pub struct Drawn {
    /// The direction, or that on which a point of a map is laid.
    pub w: Vector,
    /// What it counts: its mean is the integral of [`Valued::f`].
    pub weight: [f64; 3],
    /// Whether it is no single direction.
    pub has_density: bool,
}

/// Values in a direction.
#[derive(Clone, Copy, Debug)]
pub struct Valued {
    /// The density of samples, per steradian.
    pub pdf: f64,
    /// What weights are the mean of.
    pub f: [f64; 3],
    /// Of which factors are functions.
    pub given: Given,
}

/// A case whose samples are directions with a density.
pub trait Directed {
    /// Factors that people leave out.
    const FACTORS: &'static [Factor];
    /// An integral that is off by less than this is called right.
    const GRANTED: f64 = 2e-3;

    /// Samples of fresh numbers; `None` where nothing is.
    ///
    /// # Errors
    /// Says why there are none.
    fn drawn(&mut self, count: usize) -> Result<Vec<Option<Drawn>>, Stop>;

    /// Values in directions.
    ///
    /// # Errors
    /// Says why there are none.
    fn values(&mut self, w: &[Vector]) -> Result<Vec<Valued>, Stop>;

    /// The size of f, to which its integral is known relatively.
    fn size(&self, _weights: &Vec<[f64; 3]>) -> f64 {
        1.0
    }

    /// Where counts and integrals are kept.
    fn integrated(&mut self) -> &mut Option<Integrated>;

    /// A question for a sample.
    fn example(&self) -> Value;
}

impl LobeCase<'_> {
    /// What f and weights are multiplied with for the energy of light: radiance over the square of the index stays the
    /// same across a boundary, radiance does not.
    fn invariant(&self, wi: Vector) -> f64 {
        let ratio = self.index_at(wi) / self.index_at(self.wo);
        ratio * ratio
    }
}

impl Directed for LobeCase<'_> {
    const FACTORS: &'static [Factor] = &LOBES;

    fn drawn(&mut self, count: usize) -> Result<Vec<Option<Drawn>>, Stop> {
        let samples = self.samples(count)?;
        let drawn = |it: crate::lobe::Sampled| {
            // a direction in the surface is on the side that is served
            let w = match self.is_level(it.wi) && !self.is_served(it.wi) {
                true => Vector::new(it.wi.x(), it.wi.y(), -it.wi.z()),
                false => it.wi,
            };
            let weight = it.weight.map(|weight| weight * self.invariant(it.wi));
            Drawn { w, weight, has_density: it.pdf.is_some() }
        };
        Ok(samples.into_iter().map(|it| it.map(drawn)).collect())
    }

    fn values(&mut self, w: &[Vector]) -> Result<Vec<Valued>, Stop> {
        let values = self.lobe.eval(self.wo, w)?.into_iter().zip(w);
        let valued = |(it, wi): (crate::lobe::Evaluated, &Vector)| Valued {
            pdf: it.pdf,
            f: it.f.map(|f| f * wi.z().abs() * self.invariant(*wi)),
            given: Given::of(self.wo, *wi, self.eta),
        };
        Ok(values.map(valued).collect())
    }

    fn integrated(&mut self) -> &mut Option<Integrated> {
        &mut self.integrated
    }

    fn example(&self) -> Value {
        self.lobe.sample_question(self.wo, &[[0.5; 4]])
    }
}

/// Where nothing shines there is no density either: a sample that brings no light is none.
impl Directed for LightCase<'_> {
    const FACTORS: &'static [Factor] = &LIGHTS;
    // the edge of a lamp that is within 1/28 of a piece's side of its border lies between the nodes of both rules
    const GRANTED: f64 = 1e-2;

    fn drawn(&mut self, count: usize) -> Result<Vec<Option<Drawn>>, Stop> {
        let drawn = |it: crate::light::LightSample| Drawn {
            w: it.wi,
            weight: it.radiance.map(|l| l / it.pdf.unwrap_or(1.0)),
            has_density: it.pdf.is_some(),
        };
        let samples = self.samples(count)?.into_iter();
        Ok(samples.map(|it| it.filter(|it| it.is_lit()).map(drawn)).collect())
    }

    fn values(&mut self, w: &[Vector]) -> Result<Vec<Valued>, Stop> {
        let valued = |it: crate::light::Seen| {
            let is_lit = it.value.f != [0.0; 3];
            let pdf = if is_lit { it.value.pdf } else { 0.0 };
            Valued { pdf, f: it.value.f, given: it.given }
        };
        Ok(self.eval(self.from, w)?.into_iter().map(valued).collect())
    }

    fn size(&self, weights: &Vec<[f64; 3]>) -> f64 {
        let largest = weights.iter().flatten().copied().fold(0.0, f64::max);
        if largest.is_finite() { largest } else { 1.0 }
    }

    fn integrated(&mut self) -> &mut Option<Integrated> {
        &mut self.integrated
    }

    fn example(&self) -> Value {
        self.sample_question(&[[0.5; 4]])
    }
}

impl Directed for MapCase<'_> {
    const FACTORS: &'static [Factor] = &MAPS;

    fn drawn(&mut self, count: usize) -> Result<Vec<Option<Drawn>>, Stop> {
        let u = self.pairs(count, 0.0);
        let domain = self.domain;
        let drawn =
            |x: Vector| Some(Drawn { w: domain.direction(x), weight: [0.0; 3], has_density: true });
        Ok(self.map(&u)?.into_iter().map(drawn).collect())
    }

    fn values(&mut self, w: &[Vector]) -> Result<Vec<Valued>, Stop> {
        let domain = self.domain;
        // of all but the sphere nothing is below
        let is_there = |w: &Vector| domain == crate::domain::Domain::Sphere || w.z() >= 0.0;
        let x: Vec<Vector> = w.iter().map(|w| domain.point(*w)).collect();
        let values = self.pdf(&x)?.into_iter().zip(w).zip(x);
        let valued = |((pdf, w), x): ((f64, &Vector), Vector)| Valued {
            pdf: if is_there(w) { pdf * domain.scale() } else { 0.0 },
            f: [0.0; 3],
            given: Given::of(Vector::Z, x, 1.0),
        };
        Ok(values.map(valued).collect())
    }

    fn integrated(&mut self) -> &mut Option<Integrated> {
        &mut self.integrated
    }

    fn example(&self) -> Value {
        self.map_question(&[[0.5; 2]])
    }
}
