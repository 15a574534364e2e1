//! Noise at a point.

use serde::{Deserialize, Serialize};

use super::numbers::{Real, Triple, triple};
use groundtruth::invalid::Invalid;
use groundtruth::math::Point;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Noise {
    #[serde(default)]
    noise: groundtruth::noise::Noise,
    /// In cells of the lattice.
    point: Point,
}

#[derive(Serialize)]
pub struct NoiseAnswer {
    value: Real,
    vector: Triple,
    fractal_sum: Real,
    turbulence: Real,
    fbm: Real,
    vector_fbm: Triple,
}

impl super::Question for Noise {
    type Answer = NoiseAnswer;

    fn answer(&self) -> Result<NoiseAnswer, Invalid> {
        let noise = self.noise.build().map_err(|e| e.inside("noise"))?;
        let p = self.point;
        Ok(NoiseAnswer {
            value: Real(noise.value(p)),
            vector: triple(noise.vector(p)),
            fractal_sum: Real(noise.value_fractal_sum(p)),
            turbulence: Real(noise.value_turbulence(p)),
            fbm: Real(noise.value_fbm(p)),
            vector_fbm: triple(noise.vector_fbm(p)),
        })
    }
}
