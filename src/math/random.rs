//! The random numbers. They are not from a crate, whose generator may change between releases, and
//! every picture with it.

/// O'Neill's PCG-XSH-RR 64/32 ("PCG: A Family of Simple Fast Space-Efficient Statistically Good
/// Algorithms for Random Number Generation", 2014).
#[derive(Clone, Debug)]
pub struct Pcg32 {
    state: u64,
    increment: u64,
}

impl Pcg32 {
    /// The generator of this seed; each `stream` is a sequence of its own.
    pub fn new(seed: u64, stream: u64) -> Self {
        let mut it = Self { state: 0, increment: (stream << 1) | 1 };
        it.next_u32();
        it.state = it.state.wrapping_add(seed);
        it.next_u32();
        it
    }

    /// The next 32 bits.
    pub fn next_u32(&mut self) -> u32 {
        let old = self.state;
        self.state = old.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(self.increment);
        let xorshifted = (((old >> 18) ^ old) >> 27) as u32;
        xorshifted.rotate_right((old >> 59) as u32)
    }

    /// A uniform number in `[0, 1)` with 53 random bits. Half-open: the book's `rand_float` can
    /// return 1 and then index past the end.
    pub fn uniform(&mut self) -> f64 {
        let bits = (u64::from(self.next_u32()) << 32 | u64::from(self.next_u32())) >> 11;
        bits as f64 * (1.0 / 9_007_199_254_740_992.0)
    }

    /// A uniform whole number below `n > 0`, without bias (rejection).
    pub fn below(&mut self, n: u32) -> u32 {
        loop {
            let r = self.next_u32();
            // the threshold, 2³² mod n, is below n: most numbers need no division for it
            if r >= n || r >= n.wrapping_neg() % n {
                return r % n;
            }
        }
    }

    /// Puts `items` in a random order (Fisher and Yates).
    pub fn shuffle<T>(&mut self, items: &mut [T]) {
        for i in (1..items.len()).rev() {
            items.swap(i, self.below(i as u32 + 1) as usize);
        }
    }
}

/// The finaliser of SplitMix64 (Steele, Lea & Flood 2014) applied to `x + 0x9e37…`: what that
/// generator returns from state `x`.
pub fn splitmix(x: u64) -> u64 {
    let z = x.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

/// The hash of several words; their order matters.
pub fn hash(words: &[u64]) -> u64 {
    hash_onto(0, words)
}

/// Continues a hash: `hash_onto(hash(a), b)` is the hash of `a` followed by `b`.
pub fn hash_onto(first: u64, words: &[u64]) -> u64 {
    words.iter().fold(first, |h, &word| splitmix(splitmix(h) ^ word))
}
