//! How much of a difference something explains.

use groundtruth::math::Pcg32;

use statistics::quantile;

use super::linear::product;

/// The part of a squared difference that something explains, with its interval.
#[derive(Clone, Copy, Debug)]
pub struct Share {
    /// The part, weighted by the noise and without it: 1 if all is explained, below 0 if more is left than there was.
    pub part: f64,
    /// Its quantiles of 5 % and 95 %, from tiles drawn again with replacement (Efron, "Bootstrap Methods", 1979).
    pub interval: [f64; 2],
}

/// So often tiles are drawn again.
const DRAWN: usize = 200;

impl Share {
    /// Of a difference over tiles of three channels, and what is left of it: twice, with independent noise of what explains
    /// it, so that this noise has the mean 0 in their product. `noise` is the weighted square that the noise of the
    /// difference has in each tile.
    pub fn of(difference: &[f64], left: [&[f64]; 2], weights: &[f64], noise: &[f64]) -> Self {
        let tiles = difference.len() / 3;
        let channels = |tile: usize| (0..3).map(move |channel| channel * tiles + tile);
        let before = |at: usize| weights[at] * difference[at] * difference[at] - noise[at];
        let after = |at: usize| weights[at] * left[0][at] * left[1][at] - noise[at];
        let of = |value: &dyn Fn(usize) -> f64| -> Vec<f64> {
            (0..tiles).map(|tile| channels(tile).map(value).sum()).collect()
        };
        let (before, after) = (of(&before), of(&after));
        let part = |tiles: &mut dyn Iterator<Item = usize>| {
            let (mut there, mut rest) = (0.0, 0.0);
            for tile in tiles {
                there += before[tile];
                rest += after[tile];
            }
            if there > 0.0 { (1.0 - rest / there).min(1.0) } else { 0.0 }
        };
        let mut random = Pcg32::new(tiles as u64, 0);
        let drawn: Vec<f64> = (0..DRAWN)
            .map(|_| part(&mut (0..tiles).map(|_| random.below(tiles as u32) as usize)))
            .collect();
        let quantile = |at: f64| quantile(&drawn, at).unwrap_or_default();
        Self { part: part(&mut (0..tiles)), interval: [quantile(0.05), quantile(0.95)] }
    }
}

/// The weighted squares of a difference without those of its noise, from two of its values with independent noise of what
/// explains it; without `noise`, with them.
pub fn remainder(left: [&[f64]; 2], weights: &[f64], noise: &[f64]) -> f64 {
    product(left[0], left[1], weights) - noise.iter().sum::<f64>()
}
