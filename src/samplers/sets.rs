//! The book's 83 sets and shuffled indices, without its shared `count` and `jump`.

use super::Sampler;
use crate::lobes::Branch;
use crate::math::{ONE_MINUS, Pcg32, hash, hash_onto};

/// The number of sets, as in the book: a prime.
pub const SETS: usize = 83;

/// 83 sets of samples and as many permutations of their indices, made once from a seed.
#[derive(Debug)]
pub struct SampleSets {
    per_set: u32,
    samples: Vec<[f64; 2]>,
    permutations: Vec<u32>,
    /// The one value of all samples, if they are equal.
    only: Option<[f64; 2]>,
    /// Whether each draw moves its samples; see [`Sampler::is_shifted`].
    shifted: bool,
    /// Whether pixel and lens are always sampled at their centres.
    centered: bool,
}

/// The name of a path from the eye: the hash of its parent's name and the branch taken. It does not
/// depend on other rays.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PathKey(u64);

impl PathKey {
    /// The camera's ray.
    pub const CAMERA: Self = Self(0);

    /// The path that continues by this branch.
    pub fn then(self, branch: Branch) -> Self {
        Self(hash(&[self.0, branch as u64]))
    }
}

/// The purpose of a draw; draws for different purposes are independent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Purpose {
    /// The point in the pixel.
    Pixel,
    /// The point on the lens.
    Lens,
    /// A point of a light, for a hit of a path.
    Light {
        /// The path.
        path: PathKey,
        /// The light's index in the scene; lights that are switched off count.
        light: u32,
        /// The index of the pair among those that the light needs.
        pair: u32,
    },
    /// The choice of a path's lobe, and Russian roulette.
    Lobe {
        /// The path so far.
        path: PathKey,
    },
    /// The direction in which a path continues.
    Direction {
        /// The path so far.
        path: PathKey,
        /// The branch by which it continues.
        branch: Branch,
    },
}

impl Purpose {
    /// Different for different purposes.
    fn words(self) -> [u64; 2] {
        match self {
            Self::Pixel => [1, 0],
            Self::Lens => [2, 0],
            Self::Light { path, light, pair } => {
                [3, hash(&[path.0, u64::from(light) << 32 | u64::from(pair)])]
            }
            Self::Direction { path, branch } => [4, hash(&[path.0, branch as u64])],
            Self::Lobe { path } => [5, hash(&[path.0])],
        }
    }
}

/// The draws of one sample of a pixel.
#[derive(Clone, Copy, Debug)]
pub struct Draws<'a> {
    sets: &'a SampleSets,
    pixel: u64,
    index: u32,
}

impl<'a> Draws<'a> {
    /// Sample `index` of this pixel.
    pub fn new(sets: &'a SampleSets, seed: u64, pixel: [u32; 2], index: u32) -> Self {
        Self { sets, pixel: pixel_hash(seed, pixel), index }
    }

    /// The sample of the pixel.
    pub fn index(&self) -> u32 {
        self.index
    }

    /// Two numbers in `[0, 1)`.
    pub fn draw(&self, purpose: Purpose) -> [f64; 2] {
        self.sets.draw(SetKey { pixel: self.pixel, purpose }, self.index)
    }
}

/// The name of a draw, which determines set and permutation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SetKey {
    /// The hash of seed and pixel, which all draws of the pixel share.
    pixel: u64,
    purpose: Purpose,
}

impl SetKey {
    /// The draw for this purpose in this pixel.
    pub fn new(seed: u64, pixel: [u32; 2], purpose: Purpose) -> Self {
        Self { pixel: pixel_hash(seed, pixel), purpose }
    }

    /// The hash for a run of this draw.
    fn hash(self, run: u32) -> u64 {
        let [what, which] = self.purpose.words();
        hash_onto(self.pixel, &[what, which, run.into()])
    }
}

fn pixel_hash(seed: u64, pixel: [u32; 2]) -> u64 {
    let [x, y] = pixel.map(u64::from);
    hash(&[seed, x << 32 | y])
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
            let start = permutations.len();
            permutations.extend(0..per_set);
            random.shuffle(&mut permutations[start..]);
        }
        let shifted = sampler.is_shifted();
        let only = samples.first().copied();
        let only = only.filter(|first| !shifted && samples.iter().all(|s| s == first));
        Self { per_set, samples, permutations, only, shifted, centered: false }
    }

    /// The same sets, but pixel and lens are sampled at their centres: for one sample a pixel, as
    /// in the book. Other draws are shifted, because one point a set would give only 83 values.
    #[must_use]
    pub fn centered(self) -> Self {
        Self { centered: true, ..self }
    }

    /// The number of samples in a set: `n`, or the next number that the pattern can have.
    pub fn per_set(&self) -> u32 {
        self.per_set
    }

    /// Set `index`, below [`SETS`], in the order in which the sampler made it.
    pub fn set(&self, index: usize) -> &[[f64; 2]] {
        let n = self.per_set as usize;
        &self.samples[index * n..(index + 1) * n]
    }

    /// Whether each draw moves its set; see [`Sampler::is_shifted`].
    pub fn is_shifted(&self) -> bool {
        self.shifted
    }

    /// Sample `index` of a draw. Each run of [`SampleSets::per_set`] indices returns every sample
    /// of one set exactly once; the next run has a set and an order of its own.
    ///
    /// The order is one of the 83 permutations, rotated by a random offset. Without the offset, one
    /// pixel in 83 would use the same permutation for two draws and pair their strata.
    pub fn draw(&self, key: SetKey, index: u32) -> [f64; 2] {
        if let Some(only) = self.only {
            return only; // saves the hashes: a tenth of a simple scene's time
        }
        if self.centered && matches!(key.purpose, Purpose::Pixel | Purpose::Lens) {
            return [0.5; 2];
        }
        let (run, offset) = match index < self.per_set {
            true => (0, index as usize), // avoids divisions, which take most of the time
            false => (index / self.per_set, (index % self.per_set) as usize),
        };
        let choice = key.hash(run);
        let n = self.per_set as usize;
        // the digits of `choice` in the bases 83, 83, n
        let (set, rest) = ((choice % SETS as u64) as usize, choice / SETS as u64);
        let (permutation, rest) = ((rest % SETS as u64) as usize, rest / SETS as u64);
        let start = (rest % n as u64) as usize;
        let permutation = &self.permutations[permutation * n..][..n];
        let along = start + offset;
        let along = if along < n { along } else { along - n };
        let sample = self.samples[set * n + permutation[along] as usize];
        if self.shifted || self.centered { shifted(sample, choice) } else { sample }
    }
}

/// The sample shifted by a vector that follows from `choice`, wrapping around the square (Cranley &
/// Patterson 1976).
fn shifted(sample: [f64; 2], choice: u64) -> [f64; 2] {
    let mut random = Pcg32::new(choice, 1);
    sample.map(|x| {
        let moved = x + random.uniform();
        // a sum just below 2 may round up to 2
        if moved < 1.0 { moved } else { (moved - 1.0).min(ONE_MINUS) }
    })
}
