//! Seeded draws for laws that count their own cases, and for the shapes of [`composites`](super::composites).

use groundtruth::math::{Frame, Normal, Pcg32, Point, Vector, power};

/// A source of random numbers, points and directions.
#[derive(Debug)]
pub struct Draw(Pcg32);

impl Draw {
    /// The source of a seed.
    pub fn new(seed: u64) -> Self {
        Self(Pcg32::new(seed, 0))
    }

    /// Independent numbers for each case, so that one case can be repeated without those before it.
    pub fn case(seed: u64, index: usize) -> Self {
        Self(Pcg32::new(seed, 1 + index as u64))
    }

    /// Uniform in `[low, high)`.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.0.uniform()
    }

    /// Uniform in `0..n`.
    pub fn below(&mut self, n: usize) -> usize {
        self.0.below(n as u32) as usize
    }

    /// True with probability ½.
    pub fn coin(&mut self) -> bool {
        self.below(2) == 0
    }

    /// 1 or −1 with equal probability.
    pub fn sign(&mut self) -> f64 {
        if self.coin() { 1.0 } else { -1.0 }
    }

    /// A number whose logarithm is uniform, from `10^low` to `10^high`.
    pub fn decades(&mut self, low: f64, high: f64) -> f64 {
        power(10.0, self.between(low, high))
    }

    /// Uniform in the cube of this half-side.
    pub fn vector(&mut self, half_side: f64) -> Vector {
        let mut c = || self.between(-half_side, half_side);
        Vector::new(c(), c(), c())
    }

    /// Uniform in the cube of this half-side about the origin.
    pub fn point(&mut self, half_side: f64) -> Point {
        Point::ORIGIN + self.vector(half_side)
    }

    /// Uniform on the sphere, by rejection from the cube.
    pub fn direction(&mut self) -> Normal {
        loop {
            let v = self.vector(1.0);
            if (1e-4..1.0).contains(&v.length_squared()) {
                return Normal::new(v).expect("not zero");
            }
        }
    }

    /// A unit direction that leaves a surface on the side of `n`; in half of the cases grazing, within 10⁻¹
    /// to 10⁻⁹ of the surface.
    pub fn leaving(&mut self, n: Normal) -> Vector {
        let steep = if self.coin() { self.between(0.01, 1.0) } else { self.decades(-9.0, -1.0) };
        let across = self.direction();
        let frame = Frame::around(n);
        let flat = Vector::new(across.dot(frame.u), across.dot(frame.v), 0.0);
        let flat = flat.unit().unwrap_or(Vector::X);
        frame.to_world((1.0 - steep * steep).sqrt() * flat + steep * Vector::Z)
    }

    /// A random element.
    pub fn pick<T: Copy>(&mut self, all: &[T]) -> T {
        all[self.below(all.len())]
    }
}
