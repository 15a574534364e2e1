//! Several pictures of another program, with other seeds: nothing is assumed of their noise.

use super::areas::{Area, Areas};
use statistics::means::two_samples;

/// The test of an area and channel.
#[derive(Clone, Copy, Debug)]
pub struct WelchTest {
    /// The area.
    pub area: Area,
    /// Red, green or blue.
    pub channel: usize,
    /// The probability of means at least as far apart, times the number of tests that were as far apart or less (Holm,
    /// "A Simple Sequentially Rejective Multiple Test Procedure", 1979).
    pub probability: f64,
}

/// Tiles are tested down to this part of the picture's side: each further halving makes every test stricter.
const SMALLEST: usize = 8;

/// Welch's test of the mean of each object and each large tile, the most significant first: `theirs` and `ours` are
/// pictures by their stored values.
pub fn several(theirs: &[Vec<f32>], ours: &[Vec<f32>], areas: &Areas) -> Vec<WelchTest> {
    let smallest = areas.size[0].max(areas.size[1]).div_ceil(SMALLEST);
    let tiles = (0..areas.levels()).filter(|level| 1 << level >= smallest).flat_map(|level| {
        let [across, down] = areas.grid(level);
        (0..across * down).map(move |index| areas.tile(level, index))
    });
    let objects = (0..areas.objects.len()).map(Area::Object);
    let mut tests = Vec::new();
    for area in tiles.chain(objects) {
        let pixels = areas.pixels(area);
        for channel in 0..3 {
            let [a, b] = [theirs, ours].map(|all| Areas::means(all, &pixels, channel..channel + 1));
            let all = || a.iter().chain(&b);
            let [least, most] =
                [all().fold(f64::MAX, |a, b| a.min(*b)), all().fold(f64::MIN, |a, b| a.max(*b))];
            // what hardly differs at all is rounding
            if most - least > 1e-5 * most.abs() {
                tests.push(WelchTest { area, channel, probability: two_samples(&a, &b) });
            }
        }
    }
    tests.sort_by(|a, b| a.probability.total_cmp(&b.probability));
    let count = tests.len();
    let mut largest: f64 = 0.0;
    for (index, test) in tests.iter_mut().enumerate() {
        // no test is more significant than one before it
        largest = largest.max(test.probability * (count - index) as f64).min(1.0);
        test.probability = largest;
    }
    tests
}
