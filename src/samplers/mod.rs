//! Samplers: well-spread points of the unit square (Suffern, ch. 5), the same on every thread.
//!
//! A sampler fills one *set* of points; [`SampleSets`] keeps 83, made once from a seed. A draw
//! names its purpose: set and permutation follow only from seed, pixel and purpose, the index in
//! them from the sample's index.

/// The specification of a sampler without settings.
macro_rules! without_settings {
    ($Sampler:ident) => {
        impl $crate::samplers::Specification for $Sampler {
            fn make(&self, (): &mut ()) -> $crate::samplers::Made {
                $crate::samplers::made(*self)
            }
        }
    };
}

mod correlated_multi_jittered;
mod hammersley;
mod jittered;
mod multi_jittered;
mod n_rooks;
mod random;
mod regular;
mod sobol;

// shared by the kinds
mod sets;

use std::fmt::Debug;

use crate::math::Pcg32;

#[doc(hidden)]
pub use correlated_multi_jittered::permuted;
pub use sets::{Draws, PathKey, Purpose, SETS, SampleSets, SetKey};

/// A way to spread points over the unit square. Contract: `tests/contracts/sampler.rs`.
pub trait Sampler: Debug + Send + Sync {
    /// One set of `n` points in `[0, 1)²`; `n` comes from [`Sampler::round_up`].
    fn fill(&self, n: u32, random: &mut Pcg32) -> Vec<[f64; 2]>;

    /// The smallest number of points, at least `n`, that the pattern can have.
    fn round_up(&self, n: u32) -> u32;

    /// Whether each draw shifts the whole set by a random vector, wrapping around the square
    /// (Cranley & Patterson 1976): for patterns that have only one set.
    fn is_shifted(&self) -> bool {
        false
    }
}

crate::kinds! {
    /// How samples are spread over a pixel, a lens, a light and the directions of a scattered ray.
    Kind builds dyn Sampler with ();
    ch04 regular::Regular,
    ch04 random::Random,
    ch04 jittered::Jittered,
    ch05 n_rooks::NRooks,
    ch05 multi_jittered::MultiJittered,
    ch05 hammersley::Hammersley,
    ch05 correlated_multi_jittered::CorrelatedMultiJittered,
    ch05 sobol::Sobol,
}

/// Every sampler with its display name, in the order of the list.
pub fn named() -> Vec<(String, Kind)> {
    let named = |entry: &crate::kinds::Entry<Kind>| {
        let name = entry.module.replace('_', " ");
        let specimens = (entry.specimens)().into_iter();
        specimens.map(move |kind| {
            let shifted = kind.build(&mut ()).is_ok_and(|sampler| sampler.is_shifted());
            (name.clone() + if shifted { ", shifted" } else { "" }, kind)
        })
    };
    Kind::ENTRIES.iter().flat_map(|entry| named(entry).collect::<Vec<_>>()).collect()
}

/// The side of the smallest square grid of at least `n` cells.
fn side(n: u32) -> u32 {
    let root = n.isqrt();
    if root * root < n { root + 1 } else { root }
}

/// `n` rounded up to the next square.
fn next_square(n: u32) -> u32 {
    side(n) * side(n)
}

/// A random number in stratum `i` of `n` equal strata of `[0, 1)`.
fn in_stratum(i: u32, n: u32, random: &mut Pcg32) -> f64 {
    let (i, n) = (f64::from(i), f64::from(n));
    // rounding could give the start of the next stratum, or 1
    ((i + random.uniform()) / n).min(((i + 1.0) / n).next_down())
}
