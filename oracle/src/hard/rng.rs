//! Random numbers: the same on every platform.

use super::vector::{V, dot, scale, unit};

/// SplitMix64 (Steele, Lea & Flood, *Fast splittable pseudorandom number generators*, 2014).
#[derive(Clone, Debug)]
pub struct SplitMix64 {
    state: u64,
}

impl SplitMix64 {
    /// The generator for a seed.
    pub fn new(seed: u64) -> SplitMix64 {
        SplitMix64 { state: seed }
    }

    /// The next 64 bits.
    pub fn next_u64(&mut self) -> u64 {
        self.state = self.state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.state;
        z = (z ^ z >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ z >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ z >> 31
    }

    /// Uniform in [0, 1).
    pub(super) fn unit(&mut self) -> f64 {
        (self.next_u64() >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub(super) fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    pub(super) fn below(&mut self, n: usize) -> usize {
        (self.next_u64() % n as u64) as usize
    }

    pub(super) fn coin(&mut self) -> bool {
        self.below(2) == 0
    }

    pub(super) fn sign(&mut self) -> f64 {
        if self.coin() { 1.0 } else { -1.0 }
    }

    pub(super) fn pick<T: Copy>(&mut self, from: &[T]) -> T {
        from[self.below(from.len())]
    }

    /// From 10^low to 10^high, approximately uniform in the logarithm.
    pub(super) fn decades(&mut self, low: i32, high: i32) -> f64 {
        let steps = (high - low) as f64 * self.unit();
        let (whole, rest) = (steps as i32, steps.fract());
        let power = |n: i32| (0..n.abs()).fold(1.0, |p, _| if n > 0 { p * 10.0 } else { p / 10.0 });
        power(low + whole) * (1.0 + 9.0 * rest * rest) // 10^rest, nearly
    }

    /// A point of the cube of half-width `h`.
    pub(super) fn point_in_cube(&mut self, h: f64) -> V {
        [(); 3].map(|()| self.between(-h, h))
    }

    /// A unit vector, uniform over the sphere except for rounding.
    pub(super) fn direction(&mut self) -> V {
        loop {
            let v = self.point_in_cube(1.0);
            if (0.01..1.0).contains(&dot(v, v)) {
                return unit(v);
            }
        }
    }

    /// A coordinate axis, with either sign.
    pub(super) fn axis(&mut self) -> V {
        let i = self.below(3);
        scale(self.sign(), std::array::from_fn(|j| if i == j { 1.0 } else { 0.0 }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Oracle: the vector published for seed 1234567 with the reference implementation.
    #[test]
    fn splitmix64_gives_its_published_numbers() {
        let mut rng = SplitMix64::new(1_234_567);
        let published = [
            6_457_827_717_110_365_317,
            3_203_168_211_198_807_973,
            9_817_491_932_198_370_423,
            4_593_380_528_125_082_431,
            16_408_922_859_458_223_821,
        ];
        assert_eq!([(); 5].map(|()| rng.next_u64()), published);
    }

    #[test]
    fn decades_stay_in_their_range_and_fill_it() {
        let mut rng = SplitMix64::new(1);
        let drawn: Vec<f64> = (0..2000).map(|_| rng.decades(-3, 3)).collect();
        for x in &drawn {
            assert!((0.999e-3..=1.001e3).contains(x), "{x} is not from 1e-3 to 1e3");
        }
        let small = drawn.iter().filter(|x| **x < 1e-2).count();
        let large = drawn.iter().filter(|x| **x > 1e2).count();
        assert!(small > 200 && large > 200, "{small} below 1e-2 and {large} above 1e2 of 2000");
    }
}
