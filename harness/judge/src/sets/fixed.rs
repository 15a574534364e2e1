//! Pixels without noise before and after, whose values are not the same: no test is needed for them.

use super::Sets;
use super::sums::ROUNDING;
use crate::verdict::residuals::near;

/// The pixels to either side of one whose noise says whether chance could have repeated its value.
const REACH: usize = 2;

impl Sets {
    /// The pixels that have one colour in all pictures before and another in all after, beyond what storage changes, each with
    /// the channel of its largest difference, and that.
    ///
    /// Where noise takes few values (a sample more or less on the other side of an edge), chance may repeat one in all
    /// pictures of a set: a pixel near such noise is left to the tests.
    pub(super) fn fixed_apart(&self) -> Vec<(usize, usize, f64)> {
        let is_noisy = !self.is_fixed();
        // nobody knows the noise of a single picture
        if self.sizes() == [1, 1] || is_noisy && self.sizes().contains(&1) {
            return Vec::new();
        }
        let apart = |pixel: usize| {
            let [before, after] = [&self.before, &self.after].map(|set| one_color(set, pixel));
            let (before, after) = (before?, after?);
            let difference = |channel: usize| {
                let [a, b] = [before, after].map(|color| f64::from(color[channel]));
                // the width of an interval that has this variance
                let storage = (12.0 * self.rounding[3 * pixel + channel]).sqrt();
                let rounding = ROUNDING * a.abs().max(b.abs());
                let least = if is_noisy { rounding + storage } else { rounding };
                ((b - a).abs() > least).then_some((pixel, channel, (b - a).abs()))
            };
            (0..3).filter_map(difference).max_by(|a, b| a.2.total_cmp(&b.2))
        };
        let pixels = (0..self.areas.object_of.len()).filter_map(apart);
        pixels.filter(|(pixel, ..)| !is_noisy || !self.is_near_few_values(*pixel)).collect()
    }

    /// Whether the noise of some pixel near this one takes few values.
    fn is_near_few_values(&self, pixel: usize) -> bool {
        let [width, height] = self.areas.size;
        near(pixel / width, height, REACH)
            .any(|y| near(pixel % width, width, REACH).any(|x| self.has_few_values(y * width + x)))
    }

    /// Whether the noise of a pixel gives two pictures the same colour.
    fn has_few_values(&self, pixel: usize) -> bool {
        let sets = [&self.before, &self.after];
        if sets.iter().all(|set| one_color(set, pixel).is_some()) {
            return false;
        }
        // of a side without noise, one picture stands for all
        let varied = sets.iter().flat_map(|set| match one_color(set, pixel) {
            Some(_) => &set[..1],
            None => &set[..],
        });
        let mut colors: Vec<_> =
            varied.map(|picture| color(picture, pixel).map(f32::to_bits)).collect();
        colors.sort_unstable();
        colors.windows(2).any(|pair| pair[0] == pair[1])
    }
}

fn color(picture: &[f32], pixel: usize) -> [f32; 3] {
    [0, 1, 2].map(|channel| picture[3 * pixel + channel])
}

/// The colour that a pixel has in all pictures of a set.
fn one_color(set: &[Vec<f32>], pixel: usize) -> Option<[f32; 3]> {
    let first = color(&set[0], pixel);
    set.iter().all(|picture| color(picture, pixel) == first).then_some(first)
}
