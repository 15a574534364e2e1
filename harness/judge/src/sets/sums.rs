//! The sums of pictures over areas of every size, and how far apart two halves of the pictures are in each.

use std::ops::Range;

use groundtruth::math::ln;
use statrs::distribution::{ContinuousCDF, StudentsT};

use crate::verdict::{Area, Areas, residuals::around};

/// More areas of one channel are not tested: tiles of larger pictures begin with a larger side.
const MOST_TILES: usize = 1 << 16;

/// Relative differences up to this are rounding of the renderer.
pub const ROUNDING: f64 = 1e-5;

/// What the sums of a level are over.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SumKind {
    /// Tiles of the side 2^level.
    Tiles(usize),
    /// Regions.
    Regions,
    /// The whole picture, each pixel weighted by what a harmless change adds to it.
    Patterns,
}

/// A small change of a whole picture: its name, and what it adds to a channel of the mean picture.
type Pattern = (&'static str, fn(&[f64], [usize; 2]) -> Vec<f64>);

const PATTERNS: [Pattern; 4] = [
    ("brightness", |mean, _| mean.to_vec()),
    // shifts to the left, and up
    ("place along the rows", |mean, size| slope(mean, size, 0)),
    ("place down the columns", |mean, size| slope(mean, size, 1)),
    ("sharpness", |mean, size| {
        mean.iter().zip(around(mean, size)).map(|(value, around)| value - around).collect()
    }),
];

/// Half the difference of both neighbours along an axis; at the border, of the value itself and its one neighbour.
pub fn slope(values: &[f64], size: [usize; 2], axis: usize) -> Vec<f64> {
    let step = [1, size[0]][axis];
    let at = |pixel: usize| {
        let along = [pixel % size[0], pixel / size[0]][axis];
        let before = if along > 0 { pixel - step } else { pixel };
        let after = if along + 1 < size[axis] { pixel + step } else { pixel };
        0.5 * (values[after] - values[before])
    };
    (0..values.len()).map(at).collect()
}

/// How pictures are divided: as two means, or as differences with signs.
#[derive(Clone, Copy, Debug)]
pub struct Design {
    /// A difference `D` has `between · D²` of the sum of all squares: `nm/(n + m)` for means of `n` and `m` pictures, `k`
    /// for the mean of `k` differences.
    pub between: f64,
    /// The degrees of freedom that are left: `n + m − 2`, or `k − 1`.
    pub freedom: f64,
}

impl Design {
    /// The means of so many pictures are compared.
    pub fn means([n, m]: [usize; 2]) -> Self {
        let (n, m) = (n as f64, m as f64);
        Self { between: n * m / (n + m), freedom: n + m - 2.0 }
    }

    /// The mean of so many differences is compared with 0.
    pub fn differences(count: usize) -> Self {
        Self { between: count as f64, freedom: count as f64 - 1.0 }
    }

    /// Half of the variance is of the sums themselves, half expected from the noise of pixels: see [`AreaSums::t`].
    fn student(self) -> StudentsT {
        // of one difference, all is expected from pixels, of which there are many
        let freedom = if self.freedom > 0.0 { 2.0 * self.freedom } else { f64::INFINITY };
        StudentsT::new(0.0, 1.0, freedom).expect("it is positive")
    }

    /// The probability of a `t` at least as large, on either side.
    pub fn probability(self, t: f64) -> f64 {
        2.0 * self.student().sf(t)
    }

    /// How far out the largest `t` of so many is: −ln of the probability that one of them is as large. No difference at all
    /// is nowhere.
    pub fn score(self, t: f64, count: usize) -> f64 {
        if t > 0.0 { -ln(count as f64 * self.probability(t)) } else { f64::MIN }
    }

    /// The `t` that has this score.
    pub fn t_of_score(self, score: f64, count: usize) -> f64 {
        let [mut low, mut high] = [0.0, 1e6];
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if self.score(middle, count) < score { low = middle } else { high = middle }
        }
        high
    }
}

/// The sums over the areas of all levels.
#[derive(Clone)]
pub struct AreaSums<'a> {
    /// The levels, and the places of their sums. Those of a level begin with the areas of red.
    pub levels: Vec<(SumKind, Range<usize>)>,
    /// For each sum, the variance that it has if pixels have independent noise.
    pub expected: Vec<f64>,
    /// For each sum, that of the mean picture.
    pub mean: Vec<f64>,
    /// How pictures are divided.
    pub design: Design,
    layout: Layout<'a>,
    /// For each picture, its sums.
    pictures: Vec<Vec<f64>>,
    /// For each sum, its squares added up over the pictures.
    squares: Vec<f64>,
}

impl<'a> AreaSums<'a> {
    /// The sums of pictures, from their mean radiance, the variance of each value, and the values of each picture, less
    /// their mean over the pictures if two means are compared; one picture after the other, as large ones need much memory.
    pub fn of(
        pictures: impl Iterator<Item = Vec<f64>>,
        [mean, variance]: [&[f64]; 2],
        areas: &'a Areas,
        design: Design,
    ) -> Self {
        let layout = Layout::new(areas, mean, variance);
        let squared = layout.weights.each_ref().map(|patterns| {
            patterns.each_ref().map(|pattern| pattern.iter().map(|w| w * w).collect())
        });
        let mean = layout.sums(mean, &layout.weights);
        let mut expected = layout.sums(variance, &squared);
        for (expected, mean) in expected.iter_mut().zip(&mean) {
            *expected += design.between * ROUNDING * ROUNDING * mean * mean;
        }
        let sums = |values: Vec<f64>| layout.sums(&values, &layout.weights);
        let (pictures, squares) = (pictures.map(sums).collect(), vec![0.0; mean.len()]);
        let levels = layout.levels();
        Self { levels, expected, mean, design, layout, pictures, squares }.with_squares()
    }

    fn with_squares(mut self) -> Self {
        self.squares.fill(0.0);
        for picture in &self.pictures {
            let squares = self.squares.iter_mut().zip(picture);
            squares.for_each(|(sum, x)| *sum += x * x);
        }
        self
    }

    /// The same pictures, to each of which a picture is added so many times.
    #[must_use]
    pub fn with_added(&self, added: &[f64], times: &[f64]) -> Self {
        let added = self.layout.sums(added, &self.layout.weights);
        let mut changed = self.clone();
        for (sums, times) in changed.pictures.iter_mut().zip(times) {
            sums.iter_mut().zip(&added).for_each(|(sum, added)| *sum += times * added);
        }
        changed.with_squares()
    }

    /// For each sum, the difference that these weights of the pictures make.
    pub fn differences(&self, weights: &[f64]) -> Vec<f64> {
        let mut differences = vec![0.0; self.squares.len()];
        for (picture, weight) in self.pictures.iter().zip(weights) {
            differences.iter_mut().zip(picture).for_each(|(sum, x)| *sum += weight * x);
        }
        differences
    }

    /// Student's t of a difference of this sum: its variance is half that of the sum within the halves, which few pictures
    /// hardly tell, and half that expected from pixels, which many tell and in which neighbours are taken for independent
    /// (a variance moderated by a prior of as many degrees of freedom: Smyth, "Linear Models and Empirical Bayes Methods
    /// for Assessing Differential Expression in Microarray Experiments", 2004).
    pub fn t(&self, index: usize, difference: f64) -> f64 {
        let square = self.design.between * difference * difference;
        if square == 0.0 {
            return 0.0;
        }
        let left = (self.squares[index] - square).max(0.0);
        let variance = match self.design.freedom {
            // one difference says nothing of its variance
            0.0 => self.expected[index],
            freedom => 0.5 * (left / freedom + self.expected[index]),
        };
        let t = difference.signum() * (square / variance).sqrt();
        // of values near the ends of single precision, squares of weighted sums may be infinite
        if t.is_nan() { 0.0 } else { t }
    }

    /// The largest |t| of each level.
    pub fn largest(&self, weights: &[f64]) -> Vec<f64> {
        let differences = self.differences(weights);
        let largest = |(_, range): &(SumKind, Range<usize>)| {
            range.clone().map(|i| self.t(i, differences[i]).abs()).fold(0.0, f64::max)
        };
        self.levels.iter().map(largest).collect()
    }

    /// The sum at this place in each picture.
    pub fn in_pictures(&self, index: usize) -> Vec<f64> {
        self.pictures.iter().map(|picture| picture[index]).collect()
    }

    /// What a sum is of: its level, channel, and the number of its area or pattern in the level.
    pub fn place(&self, index: usize) -> (SumKind, usize, usize) {
        let holds = |level: &&(SumKind, Range<usize>)| level.1.contains(&index);
        let (level, range) = self.levels.iter().find(holds).expect("a place of a sum");
        let (within, each) = (index - range.start, range.len().div_ceil(3));
        (*level, within / each, within % each)
    }

    /// The places of the sums of the three channels of an area, which is the one of this number in its level.
    pub fn places(&self, level: SumKind, number: usize) -> [usize; 3] {
        let of_level = self.levels.iter().find(|(other, _)| *other == level);
        let range = &of_level.expect("a level that is there").1;
        [0, 1, 2].map(|channel| range.start + channel * range.len() / 3 + number)
    }

    /// What a sum is of, in words.
    pub fn name(&self, index: usize) -> String {
        let (level, channel, number) = self.place(index);
        let (areas, channel) = (self.layout.areas, ["red", "green", "blue"][channel]);
        match (level, self.area(index)) {
            (SumKind::Regions, _) => areas.objects[number].0.to_string(),
            (SumKind::Patterns, _) => format!("the {} of the whole picture", PATTERNS[number].0),
            (SumKind::Tiles(level), _) if level + 1 == areas.levels() => {
                format!("the whole picture ({channel})")
            }
            (SumKind::Tiles(_), area) => {
                let [x, y, w, h] = areas.bounds(&areas.pixels(area));
                format!("{x},{y},{w}x{h} ({channel})")
            }
        }
    }

    /// How much the mean difference of the pixels of a sum is beyond this part of it, which noise may be: the largest difference
    /// itself is mostly that of a small area to which noise has added. Of a pattern, which is no light, nothing.
    pub fn beyond(&self, index: usize, difference: f64, noise: f64) -> f64 {
        let areas = self.layout.areas;
        let pixels = match self.area(index) {
            _ if self.place(index).0 == SumKind::Patterns => return 0.0,
            Area::Tile { corner, side } => {
                [0, 1].map(|i| side.min(areas.size[i] - corner[i])).iter().product()
            }
            Area::Object(object) | Area::Structure(object) => areas.objects[object].1 as usize,
        };
        difference.abs() * (1.0 - noise) / pixels as f64
    }

    /// The sums of the three channels of the smallest tile with this pixel.
    pub fn smallest(&self, pixel: usize) -> [usize; 3] {
        let (areas, first) = (self.layout.areas, self.layout.first);
        let [x, y] = [pixel % areas.size[0], pixel / areas.size[0]].map(|at| at >> first);
        self.places(SumKind::Tiles(first), y * areas.grid(first)[0] + x)
    }

    /// The area of a sum.
    pub fn area(&self, index: usize) -> Area {
        match self.place(index) {
            (SumKind::Tiles(level), _, tile) => self.layout.areas.tile(level, tile),
            (SumKind::Regions, _, region) => Area::Object(region),
            (SumKind::Patterns, ..) => self.layout.areas.tile(self.layout.areas.levels() - 1, 0),
        }
    }
}

/// The values of each channel.
pub fn channels(values: &[f64]) -> [Vec<f64>; 3] {
    [0, 1, 2].map(|channel| values.iter().skip(channel).step_by(3).copied().collect())
}

/// The weights of pixels, for each channel and pattern.
type Weights = [[Vec<f64>; 4]; 3];

/// The order of the sums, and the weights of those of patterns.
#[derive(Clone)]
struct Layout<'a> {
    areas: &'a Areas,
    /// The first level of tiles.
    first: usize,
    weights: Weights,
}

impl<'a> Layout<'a> {
    fn new(areas: &'a Areas, mean: &[f64], variance: &[f64]) -> Self {
        let count = |level: &usize| areas.grid(*level).iter().product::<usize>();
        let first = (0..areas.levels()).find(|level| count(level) <= MOST_TILES);
        let weights = weights(&channels(mean), &channels(variance), areas.size);
        Self { areas, first: first.unwrap_or_default(), weights }
    }

    fn levels(&self) -> Vec<(SumKind, Range<usize>)> {
        let tiles = (self.first..self.areas.levels()).map(|level| {
            (SumKind::Tiles(level), 3 * self.areas.grid(level).iter().product::<usize>())
        });
        let regions = (SumKind::Regions, 3 * self.areas.objects.len());
        let others = [regions, (SumKind::Patterns, 3 * PATTERNS.len())];
        let mut start = 0;
        let place = |(level, count)| {
            start += count;
            (level, start - count..start)
        };
        tiles.chain(others).map(place).collect()
    }

    /// The sums of a picture; those of patterns have these weights.
    fn sums(&self, values: &[f64], weights: &Weights) -> Vec<f64> {
        let mut tiles = channels(values);
        let regions = tiles.each_ref().map(|channel| self.areas.by_object(channel));
        let product = |channel: &[f64], weights: &[f64]| -> f64 {
            channel.iter().zip(weights).map(|(value, weight)| value * weight).sum()
        };
        let both = tiles.iter().zip(weights);
        let patterns = both.flat_map(|(channel, patterns)| {
            patterns.each_ref().map(|weights| product(channel, weights))
        });
        let patterns: Vec<f64> = patterns.collect();
        let mut sums = Vec::new();
        for level in 0..self.areas.levels() {
            if level > 0 {
                tiles = tiles.map(|finer| self.areas.coarser(&finer, level));
            }
            if level >= self.first {
                tiles.iter().for_each(|channel| sums.extend(channel));
            }
        }
        regions.iter().for_each(|channel| sums.extend(channel));
        sums.extend(patterns);
        sums
    }
}

/// What a pattern adds to each pixel, over the variance, which is the best weight against noise of this variance. Where
/// there is hardly any noise, other causes limit what is seen.
fn weights(mean: &[Vec<f64>; 3], variance: &[Vec<f64>; 3], size: [usize; 2]) -> Weights {
    [0, 1, 2].map(|channel| {
        let of = &variance[channel];
        let least = 0.01 * of.iter().sum::<f64>() / of.len() as f64;
        let weight = |(added, variance): (f64, &f64)| match variance + least {
            0.0 => 0.0,
            variance => added / variance,
        };
        PATTERNS
            .map(|(_, added)| added(&mean[channel], size).into_iter().zip(of).map(weight).collect())
    })
}
