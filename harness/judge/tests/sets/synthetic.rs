//! Pictures made by formulas: their mean is known, and their noise is of a chosen kind.

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use groundtruth::math::{self, Pcg32};
use judge::sets::{Divisions, Sets, SetsDecision, SetsVerdict, Watch};
use pictures::compare::Picture;

pub const SIZE: [u32; 2] = [32, 40];

/// Kinds of noise.
#[derive(Clone, Copy, Debug)]
pub enum Noise {
    /// Of deviation 0.1, independent in each pixel, common to the channels.
    Even,
    /// The same, and one pixel in 200 is 20 brighter.
    Fireflies,
    /// The same averaged over two by two pixels.
    Filtered,
}

/// The pictures of these seeds.
pub fn pictures(noise: Noise, seeds: impl Iterator<Item = u64>) -> Vec<Picture> {
    seeds.map(|seed| picture(noise, seed)).collect()
}

fn picture(noise: Noise, seed: u64) -> Picture {
    let [width, height] = SIZE;
    let mut random = Pcg32::new(seed, 77);
    // uniform numbers of variance 1
    let mut uniform = || 12.0_f64.sqrt() * (random.uniform() - 0.5);
    let grid: Vec<f64> = (0..(width + 1) * (height + 1)).map(|_| uniform()).collect();
    let at = |x: u32, y: u32| grid[(y * (width + 1) + x) as usize];
    let mut values = Vec::new();
    for y in 0..height {
        for x in 0..width {
            let one = match noise {
                Noise::Even => 0.1 * at(x, y),
                Noise::Fireflies => {
                    0.1 * at(x, y) + if random.below(200) == 0 { 20.0 } else { 0.1 }
                }
                Noise::Filtered => {
                    0.025 * (at(x, y) + at(x + 1, y) + at(x, y + 1) + at(x + 1, y + 1))
                }
            };
            let mean = mean_at([x, y]);
            values.extend(mean.map(|mean| (mean * (1.0 + one)) as f32));
        }
    }
    Picture::of_radiance(&values, SIZE)
}

/// A gradient with a disk and stripes.
fn mean_at([x, y]: [u32; 2]) -> [f64; 3] {
    let [x, y] = [x, y].map(f64::from);
    let disk = if (x - 20.0) * (x - 20.0) + (y - 12.0) * (y - 12.0) < 50.0 { 1.0 } else { 0.0 };
    let stripe = if y > 25.0 && x % 6.0 < 3.0 { 0.5 } else { 0.0 };
    [0.5 + 0.01 * x + disk, 0.6 + 0.01 * y + stripe, 0.8 - 0.01 * x + 0.3 * disk]
}

/// The mean of pictures.
pub fn mean(all: &[Picture]) -> Picture {
    let mut values = vec![0.0; all[0].values.as_flattened().len()];
    for picture in all {
        let sums = values.iter_mut().zip(picture.values.as_flattened());
        sums.for_each(|(sum, value)| *sum += value / all.len() as f32);
    }
    Picture::of_radiance(&values, all[0].size)
}

/// The pictures with each pixel this many times as bright.
fn times(all: &[Picture], factor: impl Fn([u32; 2]) -> f64) -> Vec<Picture> {
    let changed = |picture: &Picture| {
        let mut picture = picture.clone();
        let width = picture.size[0];
        for (index, color) in (0..).zip(&mut picture.values) {
            let factor = factor([index % width, index / width]) as f32;
            *color = color.map(|value| value * factor);
        }
        picture
    };
    all.iter().map(changed).collect()
}

/// The pictures with some pixels this many times as bright.
pub fn brighter(all: &[Picture], factor: f64, wanted: impl Fn([u32; 2]) -> bool) -> Vec<Picture> {
    times(all, |at| if wanted(at) { factor } else { 1.0 })
}

/// The pictures without the light of one lamp of twelve that hang in a ring: each lights the picture by the fourth power of
/// the cosine.
pub fn without_a_lamp(all: &[Picture]) -> Vec<Picture> {
    let [width, height] = SIZE.map(f64::from);
    let light = |lamp: usize, [x, y]: [u32; 2]| {
        let angle = std::f64::consts::TAU * lamp as f64 / 12.0;
        let at = [0.5 + 0.35 * math::cos(angle), 0.5 + 0.35 * math::sin(angle)];
        let away = [f64::from(x) / width - at[0], f64::from(y) / height - at[1]];
        let distance = away[0] * away[0] + away[1] * away[1];
        1.0 / ((1.0 + 4.0 * distance) * (1.0 + 4.0 * distance))
    };
    times(all, |at| 1.0 - light(7, at) / (0..12).map(|lamp| light(lamp, at)).sum::<f64>())
}

/// The picture, each pixel taken from another place.
pub fn moved(picture: &Picture, from: &dyn Fn([u32; 2]) -> [u32; 2]) -> Picture {
    let width = picture.size[0];
    let source = |index: u32| picture.values[picture.index(from([index % width, index / width]))];
    let values = (0..picture.values.len() as u32).map(source).collect();
    Picture { values, ..picture.clone() }
}

pub fn verdict(before: &[Picture], after: &[Picture]) -> SetsVerdict {
    verdict_at([before, after], None, super::LEVEL)
}

/// The verdict with these regions at this level, which nobody interrupts.
pub fn verdict_at(sets: [&[Picture]; 2], regions: Option<&Picture>, level: f64) -> SetsVerdict {
    let sets = Sets::new(sets.map(<[Picture]>::to_vec), regions).expect("one size");
    let watch = Watch { tried: &|| (), interrupted: &AtomicBool::new(false) };
    SetsVerdict::of(sets, level, watch).expect("it is not interrupted")
}

/// Whether two sets differ. Of sets that agree it is not found out what would have been seen, which takes twenty times as long:
/// the comparison is interrupted as soon as it tries a division again.
pub fn differ(before: &[Picture], after: &[Picture]) -> bool {
    // as many as are tried at most
    let most = (4.0 / super::LEVEL) as usize;
    let all = Divisions::sets([before.len(), after.len()], most).weights.len();
    let (tried, interrupted) = (AtomicUsize::new(0), AtomicBool::new(false));
    let count = || {
        if tried.fetch_add(1, Ordering::Relaxed) == all {
            interrupted.store(true, Ordering::Relaxed);
        }
    };
    let watch = Watch { tried: &count, interrupted: &interrupted };
    let sets = Sets::new([before, after].map(<[Picture]>::to_vec), None).expect("one size");
    let found = SetsVerdict::of(sets, super::LEVEL, watch);
    found.is_some_and(|found| found.decision == SetsDecision::Differ)
}
