//! The book's 83 sets and shuffled indices, without its shared `count` and `jump`.

use super::Sampler;
use crate::math::{Pcg32, hash};

/// As many sets as in the book: a prime.
pub const SETS: usize = 83;

/// 83 sets of samples and as many permutations of their indices, made once from a seed.
#[derive(Debug)]
pub struct SampleSets {
    per_set: u32,
    samples: Vec<[f64; 2]>,
    permutations: Vec<u32>,
    /// The sample that all are, if they are: there is nothing to draw then.
    only: Option<[f64; 2]>,
}

/// What a draw is for; draws for different things are independent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Purpose {
    /// The place in the pixel.
    Pixel = 1,
}

/// Names a draw: it decides on the set and the permutation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Key {
    seed: u64,
    pixel: [u32; 2],
    purpose: Purpose,
}

impl Key {
    /// The draw for this purpose in this pixel.
    pub fn new(seed: u64, pixel: [u32; 2], purpose: Purpose) -> Self {
        Self { seed, pixel, purpose }
    }

    fn hash(self) -> u64 {
        let [x, y] = self.pixel.map(u64::from);
        hash(&[self.seed, x, y, self.purpose as u64])
    }
}

impl SampleSets {
    /// Sets of at least `n` samples each; see [`SampleSets::per_set`].
    pub fn new(sampler: &dyn Sampler, n: u32, seed: u64) -> Self {
        let per_set = sampler.round_up(n.max(1));
        let mut random = Pcg32::new(seed, 0);
        let mut samples = Vec::with_capacity(SETS * per_set as usize);
        let mut permutations = Vec::with_capacity(SETS * per_set as usize);
        for _ in 0..SETS {
            samples.extend(sampler.fill(per_set, &mut random));
            let mut permutation: Vec<u32> = (0..per_set).collect();
            random.shuffle(&mut permutation);
            permutations.extend(permutation);
        }
        let only = samples.first().copied().filter(|first| samples.iter().all(|s| s == first));
        Self { per_set, samples, permutations, only }
    }

    /// The number of samples that use up a set: `n`, or the next square where the pattern needs one.
    pub fn per_set(&self) -> u32 {
        self.per_set
    }

    /// Set `index`, below [`SETS`], in the order in which the sampler made it.
    pub fn set(&self, index: usize) -> &[[f64; 2]] {
        let n = self.per_set as usize;
        &self.samples[index * n..(index + 1) * n]
    }

    /// Sample `index` of a draw. Each run of [`SampleSets::per_set`] indices returns every sample
    /// of one set exactly once; the next run has a set and a permutation of its own.
    pub fn draw(&self, key: Key, index: u32) -> [f64; 2] {
        if let Some(only) = self.only {
            return only; // without the hashes, a tenth of what a simple scene's pixel takes
        }
        let n = self.per_set as usize;
        let (run, place) = (index as usize / n, index as usize % n);
        let choice = hash(&[key.hash(), run as u64]);
        let set = choice as u32 as usize % SETS;
        let permutation = (choice >> 32) as usize % SETS;
        self.samples[set * n + self.permutations[permutation * n + place] as usize]
    }
}
