//! The values at the lattice points: tables, indexed through a permutation (Peachey's method).

use crate::math::{Pcg32, Vector, cos, floor, sin};
use crate::samplers::{MultiJittered, Sampler};

/// The size of each table, and the period of the lattice.
const TABLE_SIZE: usize = 256;

/// A lattice point: its coordinates modulo 256.
pub type LatticePoint = [u8; 3];

/// A number and a unit vector for each point of integer coordinates.
#[derive(Clone, Debug)]
pub struct Lattice {
    permutation: [u8; TABLE_SIZE],
    values: [f64; TABLE_SIZE],
    vectors: [Vector; TABLE_SIZE],
}

impl Lattice {
    /// The tables of a seed. The permutation does not depend on the seed.
    pub fn new(seed: u64) -> Self {
        let mut permutation: [u8; TABLE_SIZE] = std::array::from_fn(|i| i as u8);
        Pcg32::new(31, 0).shuffle(&mut permutation);
        let mut random = Pcg32::new(seed, 0);
        let values = std::array::from_fn(|_| 1.0 - 2.0 * random.uniform());
        let samples = MultiJittered {}.fill(TABLE_SIZE as u32, &mut Pcg32::new(seed, 1));
        let vectors = std::array::from_fn(|i| on_sphere(samples[i]));
        Self { permutation, values, vectors }
    }

    /// These tables; `None` if one has not 256 entries.
    pub fn of_tables(permutation: &[u8], values: &[f64], vectors: &[Vector]) -> Option<Self> {
        Some(Self {
            permutation: permutation.try_into().ok()?,
            values: values.try_into().ok()?,
            vectors: vectors.try_into().ok()?,
        })
    }

    /// The permutation of 0 … 255.
    pub fn permutation(&self) -> &[u8; TABLE_SIZE] {
        &self.permutation
    }

    /// The numbers, uniform between −1 and 1.
    pub fn values(&self) -> &[f64; TABLE_SIZE] {
        &self.values
    }

    /// The unit vectors, evenly spread over the sphere.
    pub fn vectors(&self) -> &[Vector; TABLE_SIZE] {
        &self.vectors
    }

    /// The number at a point of the lattice.
    pub fn value(&self, knot: LatticePoint) -> f64 {
        self.values[self.index(knot)]
    }

    /// The vector at a point of the lattice.
    pub fn vector(&self, knot: LatticePoint) -> Vector {
        self.vectors[self.index(knot)]
    }

    /// `PERM(ix + PERM(iy + PERM(iz)))`, the sums modulo 256.
    fn index(&self, [ix, iy, iz]: LatticePoint) -> usize {
        let perm = |i: u8| self.permutation[usize::from(i)];
        usize::from(perm(ix.wrapping_add(perm(iy.wrapping_add(perm(iz))))))
    }
}

/// The map from the unit square to the unit sphere that preserves ratios of areas.
fn on_sphere([r1, r2]: [f64; 2]) -> Vector {
    let z = 1.0 - 2.0 * r1;
    let r = (1.0 - z * z).sqrt();
    let phi = std::f64::consts::TAU * r2;
    Vector::new(r * cos(phi), r * sin(phi), z)
}

/// The lattice plane at or below a coordinate, modulo 256, and the distance from the plane, in `[0,
/// 1)`.
pub fn cell(x: f64) -> (u8, f64) {
    /// All larger numbers are multiples of 256.
    const WHOLE_PERIODS: f64 = (1_u64 << 60) as f64;
    // also for infinite and NaN coordinates
    if !(-WHOLE_PERIODS..WHOLE_PERIODS).contains(&x) {
        return (0, 0.0);
    }
    let plane = floor(x);
    // the low byte in two's complement is the remainder modulo 256, for negative numbers too
    (plane as i64 as u8, x - plane)
}
