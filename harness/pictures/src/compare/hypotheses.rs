//! Simple changes that explain a difference.

use groundtruth::math::hash;
use serde::Serialize;

use super::change::known_factor;
use super::{Change, Decoded, Transfer};

/// A change of one picture that makes it nearly the other.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Hypothesis {
    /// What is different about a picture, in words.
    pub what: String,
    /// The mean difference that is left, as a part of what it was.
    pub left: f64,
}

/// A change explains a difference of which it leaves at most this part.
pub(super) const EXPLAINED: f64 = 0.1;

/// What is left of a picture must be at least this part of it: one pixel says nothing of a shift.
const OVERLAP: f64 = 0.75;

/// At most about so many pixels are tried: a change is one of all pixels.
const PIXELS: usize = 1 << 16;

/// A picture and a change of it.
type Changed<'a> = (&'a Decoded<'a>, Change);

/// The changes that leave little of the difference of two pictures, the best first; if none does, those in another
/// transfer function. The first one is only decoded in other ways; all others are of the second. They have these names.
pub fn explaining(names: [&str; 2], a: &Decoded<'_>, b: &Decoded<'_>) -> Vec<Hypothesis> {
    let of_b = changes_that_explain(a, b, 0.0)
        .into_iter()
        .map(|(change, left)| Hypothesis { what: change.words(names, b.picture.transfer), left });
    let pixels = evenly_spread(a.picture.size, PIXELS);
    let before = distance(&pixels, (a, Change::Same), (b, Change::Same));
    let of_a = decodings(a).into_iter().map(|change| Hypothesis {
        what: change.words([names[1], names[0]], a.picture.transfer),
        left: distance(&pixels, (a, change), (b, Change::Same)) / before,
    });
    let mut found: Vec<Hypothesis> = of_b.chain(of_a).filter(|it| it.left <= EXPLAINED).collect();
    if found.is_empty() {
        found = decodings(b).into_iter().flat_map(|it| explaining_both(names, a, b, it)).collect();
    }
    found.sort_by(|a, b| a.left.total_cmp(&b.left));
    found
}

/// The changes of pixels that explain a difference together with another transfer function.
fn explaining_both(
    names: [&str; 2],
    a: &Decoded<'_>,
    b: &Decoded<'_>,
    decoding: Change,
) -> Vec<Hypothesis> {
    let picture = decoding.applied(b.picture);
    let found = changes_that_explain(a, &Decoded::new(&picture), 0.0).into_iter();
    let of_pixels = found.filter(|(it, _)| !matches!(it, Change::Decoded(_) | Change::Scaled(_)));
    let also = decoding.words(names, b.picture.transfer);
    let words = |it: Change| format!("{}, and {also}", it.words(names, picture.transfer));
    of_pixels.map(|(it, left)| Hypothesis { what: words(it), left }).collect()
}

/// The changes of `b` that leave little of its difference from `a` beyond their noise, each with the part that it
/// leaves, the best first. `noise` is the distance, as [`distance_of`] gives it, of pictures that agree.
pub fn changes_that_explain(a: &Decoded<'_>, b: &Decoded<'_>, noise: f64) -> Vec<(Change, f64)> {
    let pixels = evenly_spread(a.picture.size, PIXELS);
    let as_a = (a, Change::Same);
    let before = distance(&pixels, as_a, (b, Change::Same)) - noise;
    let mut changes = Change::of_pixels(b.picture.size);
    changes.retain(|change| change.overlap(b.picture.size) >= OVERLAP);
    changes.extend(decodings(b));
    changes.extend(exposure(&pixels, as_a, b));
    let left = |change| (distance(&pixels, as_a, (b, change)) - noise).max(0.0) / before;
    let mut found: Vec<(Change, f64)> = changes.into_iter().map(|it| (it, left(it))).collect();
    found.retain(|(_, left)| before > 0.0 && *left <= EXPLAINED);
    found.sort_by(|a, b| a.1.total_cmp(&b.1));
    found
}

/// The mean relative distance of two pictures of one size.
pub fn distance_of(a: &Decoded<'_>, b: &Decoded<'_>) -> f64 {
    distance(&evenly_spread(a.picture.size, PIXELS), (a, Change::Same), (b, Change::Same))
}

/// All pixels, or about `most` evenly spread ones.
pub(super) fn evenly_spread([width, height]: [u32; 2], most: usize) -> Vec<[i64; 2]> {
    let pixel = |at: usize| [(at % width as usize) as i64, (at / width as usize) as i64];
    spread(width as usize * height as usize, most).map(pixel).collect()
}

/// All indices below `count`, or about `most` evenly spread ones, ascending: one from each block of equal length, at a hashed
/// offset. A fixed offset would leave out whole columns at some widths.
pub fn spread(count: usize, most: usize) -> impl Iterator<Item = usize> {
    let step = (count / most).max(1);
    (0..count).step_by(step).map(move |first| {
        let length = step.min(count - first) as u64;
        first + (hash(&[first as u64]) % length) as usize
    })
}

/// Both radiances of each pixel at which both are finite.
fn finite<'a>(
    pixels: &'a [[i64; 2]],
    (a, change_a): Changed<'a>,
    (b, change_b): Changed<'a>,
) -> impl Iterator<Item = [[f64; 3]; 2]> + 'a {
    let both =
        pixels.iter().filter_map(move |&at| Some([change_a.at(a, at)?, change_b.at(b, at)?]));
    both.filter(|colors| colors.as_flattened().iter().all(|value| value.is_finite()))
}

/// The mean relative difference `|x − y|/(|x| + |y|)` of channels, over pixels in which both are finite; black
/// counts as a thousandth of the mean.
fn distance(pixels: &[[i64; 2]], a: Changed<'_>, b: Changed<'_>) -> f64 {
    let colors: Vec<_> = finite(pixels, a, b).collect();
    let total: f64 = colors.as_flattened().as_flattened().iter().map(|value| value.abs()).sum();
    let count = (6 * colors.len()).max(1) as f64;
    let floor = 1e-3 * total / count + f64::MIN_POSITIVE;
    let of = |(x, y): (f64, f64)| (x - y).abs() / (x.abs() + y.abs() + floor);
    let sum: f64 = colors.into_iter().map(|[x, y]| x.into_iter().zip(y).map(of).sum::<f64>()).sum();
    sum / (0.5 * count)
}

/// The picture, if its values are for display, with each other transfer function.
pub fn decodings(of: &Decoded<'_>) -> Vec<Change> {
    let picture = of.picture;
    let transfers = [Transfer::Linear, Transfer::Srgb, Transfer::Gamma(1.8), Transfer::Gamma(2.2)];
    let is_other = |it: &Transfer| picture.step.is_some() && *it != picture.transfer;
    transfers.into_iter().filter(is_other).map(Change::Decoded).collect()
}

/// The factor that brings `b` nearest to `a`: the median of their ratios.
fn exposure(pixels: &[[i64; 2]], a: Changed<'_>, b: &Decoded<'_>) -> Option<Change> {
    let ratio = |[x, y]: [[f64; 3]; 2]| x.iter().sum::<f64>() / y.iter().sum::<f64>();
    let mut ratios: Vec<f64> = finite(pixels, a, (b, Change::Same))
        .map(ratio)
        .filter(|ratio| ratio.is_finite() && *ratio > 0.0)
        .collect();
    ratios.sort_by(f64::total_cmp);
    let factor = known_factor(*ratios.get(ratios.len() / 2)?);
    ((factor - 1.0).abs() >= 1e-3).then_some(Change::Scaled(factor))
}
