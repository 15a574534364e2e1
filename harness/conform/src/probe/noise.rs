//! Noise at a point.

use serde::{Deserialize, Serialize};

use super::numbers::{Real, Triple, triple};
use groundtruth::invalid::Invalid;
use groundtruth::math::{Point, Vector};
use groundtruth::noise::Lattice;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct NoiseQuestion {
    #[serde(default)]
    noise: groundtruth::noise::Noise,
    /// Tables for those of the noise's seed.
    #[serde(default)]
    lattice: Option<Tables>,
    /// In cells of the lattice.
    point: Point,
}

/// The values at the points of the lattice, 256 of each; at `[x, y, z]` it is that of
/// `PERM(x + PERM(y + PERM(z)))`, sums modulo 256.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Tables {
    permutation: Vec<u8>,
    values: Vec<f64>,
    vectors: Vec<Vector>,
}

impl Tables {
    fn lattice(&self) -> Result<Lattice, Invalid> {
        let Self { permutation, values, vectors } = self;
        Lattice::of_tables(permutation, values, vectors)
            .ok_or_else(|| Invalid::field("lattice", "each of the three lists needs 256 entries"))
    }
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

impl super::Question for NoiseQuestion {
    type Answer = NoiseAnswer;

    fn answer(&self) -> Result<NoiseAnswer, Invalid> {
        let mut noise = self.noise.build().map_err(|e| e.inside("noise"))?;
        if let Some(tables) = &self.lattice {
            noise = noise.with_lattice(tables.lattice()?);
        }
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
