//! Two pictures compared: to the last bit, up to drift, or with a tolerance.

use std::collections::HashSet;

use groundtruth::film::Film;

/// How a picture compares with the one that was expected.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// The same bits.
    Same,
    /// Every channel of every pixel is within [`DRIFT`], as after a change of the order of sums.
    Drift,
    /// A larger difference.
    Changed,
}

/// The largest relative difference of a channel that is still drift: about eight times the
/// distance between neighbouring numbers of single precision.
pub const DRIFT: f64 = 1e-6;

/// Compares two pictures as files store them, in single precision.
pub fn verdict(expected: &Film, got: &Film) -> Verdict {
    if !same_size(expected, got) {
        return Verdict::Changed;
    }
    let channels = || expected.to_f32().zip(got.to_f32()).flat_map(|(a, b)| a.into_iter().zip(b));
    if channels().all(|(a, b)| a.to_bits() == b.to_bits()) {
        Verdict::Same
    } else if channels().all(|(a, b)| a.to_bits() == b.to_bits() || within(a, b, DRIFT, 0.0)) {
        Verdict::Drift
    } else {
        Verdict::Changed
    }
}

fn same_size(a: &Film, b: &Film) -> bool {
    (a.width(), a.height()) == (b.width(), b.height())
}

/// `|a − b| ≤ relative · max(|a|, |b|)`, with the maximum at least `floor`; false for NaN.
fn within(a: f32, b: f32, relative: f64, floor: f64) -> bool {
    let (a, b) = (f64::from(a), f64::from(b));
    (a - b).abs() <= relative * a.abs().max(b.abs()).max(floor)
}

/// A pixel in which two pictures differ.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Difference {
    /// x right and y down, from 0.
    pub pixel: [u32; 2],
    /// The expected colour.
    pub expected: [f32; 3],
    /// The actual colour.
    pub got: [f32; 3],
    /// The largest absolute difference of a channel; infinite if it is NaN.
    pub size: f64,
}

/// The pixels whose bits differ, the largest difference first. Both pictures have the same size.
pub fn differences(expected: &Film, got: &Film) -> Vec<Difference> {
    let mut all = Vec::new();
    for (i, (a, b)) in expected.to_f32().zip(got.to_f32()).enumerate() {
        if a.map(f32::to_bits) != b.map(f32::to_bits) {
            let channel = |c: usize| (f64::from(a[c]) - f64::from(b[c])).abs();
            let channels = [channel(0), channel(1), channel(2)];
            let not_a_number = channels.iter().any(|c| c.is_nan());
            let size = channels.into_iter().fold(0.0, f64::max);
            let i = i as u32;
            all.push(Difference {
                pixel: [i % expected.width(), i / expected.width()],
                expected: a,
                got: b,
                size: if not_a_number { f64::INFINITY } else { size },
            });
        }
    }
    all.sort_by(|a, b| b.size.total_cmp(&a.size));
    all
}

/// The allowed difference between pictures of different programs.
///
/// "99 % of the pixels agree" would accept a wrong line one pixel wide, so clusters of differing pixels
/// are limited too.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerance {
    /// The largest relative difference of a channel in a pixel that agrees.
    pub relative: f64,
    /// Channels below this are compared as if they were this large.
    pub floor: f64,
    /// The largest share of pixels that do not agree.
    pub share: f64,
    /// The most pixels in a cluster: pixels that do not agree, connected by sides or corners.
    pub cluster: u32,
}

/// The pixels that do not agree within a [`Tolerance`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Disagreement {
    /// The share of pixels that do not agree.
    pub share: f64,
    /// The number of pixels in the largest cluster.
    pub cluster: u32,
}

impl Tolerance {
    /// Whether the pictures have the same size and differ no more than allowed.
    pub fn accepts(&self, expected: &Film, got: &Film) -> bool {
        if !same_size(expected, got) {
            return false;
        }
        let found = self.disagreement(expected, got);
        found.share <= self.share && found.cluster <= self.cluster
    }

    /// The disagreement of two pictures of the same size.
    pub fn disagreement(&self, expected: &Film, got: &Film) -> Disagreement {
        let mut apart = HashSet::new();
        for (i, (a, b)) in expected.to_f32().zip(got.to_f32()).enumerate() {
            if (0..3).any(|c| !within(a[c], b[c], self.relative, self.floor)) {
                let (x, y) = (i as i64 % i64::from(got.width()), i as i64 / i64::from(got.width()));
                apart.insert((x, y));
            }
        }
        let pixels = f64::from(got.width()) * f64::from(got.height());
        Disagreement { share: apart.len() as f64 / pixels, cluster: largest_cluster(apart) }
    }
}

/// The size of the largest set of pixels connected by sides or corners.
fn largest_cluster(mut pixels: HashSet<(i64, i64)>) -> u32 {
    let mut largest = 0;
    while let Some(&start) = pixels.iter().next() {
        pixels.remove(&start);
        let (mut size, mut border) = (0, vec![start]);
        while let Some((x, y)) = border.pop() {
            size += 1;
            for (dx, dy) in [(-1, -1), (0, -1), (1, -1), (-1, 0), (1, 0), (-1, 1), (0, 1), (1, 1)] {
                let next = (x + dx, y + dy);
                if pixels.remove(&next) {
                    border.push(next);
                }
            }
        }
        largest = largest.max(size);
    }
    largest
}

#[cfg(test)]
mod tests {
    use super::*;
    use groundtruth::rgb::Rgb;

    fn grey(value: f64) -> Film {
        let mut film = Film::new(8, 6);
        (0..48).for_each(|i| film.set([i % 8, i / 8], Rgb::grey(value)));
        film
    }

    #[test]
    fn drift_ends_at_one_millionth_of_the_larger_value() {
        // single precision near 1 steps by 1.2e-7: eight steps are 9.5e-7, nine are 1.07e-6
        let step = f64::from(f32::EPSILON);
        assert_eq!(verdict(&grey(1.0), &grey(1.0)), Verdict::Same);
        assert_eq!(verdict(&grey(1.0), &grey(1.0 + step)), Verdict::Drift);
        assert_eq!(verdict(&grey(1.0), &grey(1.0 + 8.0 * step)), Verdict::Drift);
        assert_eq!(verdict(&grey(1.0), &grey(1.0 + 9.0 * step)), Verdict::Changed);
    }

    #[test]
    fn one_channel_of_one_pixel_decides() {
        let mut film = grey(0.5);
        film.set([7, 5], Rgb::new(0.5, 0.5, 0.5 + 1e-3));
        assert_eq!(verdict(&grey(0.5), &film), Verdict::Changed);
        let found = differences(&grey(0.5), &film);
        assert_eq!(found.len(), 1);
        assert_eq!(found[0].pixel, [7, 5]);
    }

    #[test]
    fn what_is_not_a_number_is_never_drift_and_is_the_worst() {
        let mut film = grey(0.5);
        film.set([1, 2], Rgb::grey(9.0));
        film.set([3, 0], Rgb::new(0.5, f64::NAN, 0.5));
        assert_eq!(verdict(&grey(0.5), &film), Verdict::Changed);
        assert_eq!(verdict(&film, &film), Verdict::Same, "bits are compared, not values");
        let found: Vec<_> = differences(&grey(0.5), &film).iter().map(|d| d.pixel).collect();
        assert_eq!(found, [[3, 0], [1, 2]]);
    }

    #[test]
    fn pictures_of_other_sizes_are_changed() {
        let other = Film::new(6, 8);
        assert_eq!(verdict(&Film::new(8, 6), &other), Verdict::Changed);
        let tolerance = Tolerance { relative: 1.0, floor: 1.0, share: 1.0, cluster: u32::MAX };
        assert!(!tolerance.accepts(&Film::new(8, 6), &other));
    }

    /// Law: the allowed difference is a part of the larger value, and of the floor where both are below it; which
    /// picture is expected makes no difference. Oracle: values to either side of the limits by hand.
    #[test]
    fn the_tolerance_is_symmetric_and_has_a_floor() {
        let tolerance = Tolerance { relative: 0.25, floor: 0.5, share: 0.0, cluster: 0 };
        // ¼ of 4 is 1; ¼ of the floor is 0.125
        let pairs = [
            (3.0, 4.0, true),
            (2.9, 4.0, false),
            (0.0, 0.125, true),
            (0.0, 0.126, false),
            (0.375, 0.5, true),
        ];
        for (a, b, agree) in pairs {
            assert_eq!(tolerance.accepts(&grey(a), &grey(b)), agree, "{a} and {b}");
            assert_eq!(tolerance.accepts(&grey(b), &grey(a)), agree, "{b} and {a}");
        }
    }

    #[test]
    fn a_thin_line_is_a_cluster_though_few_pixels_differ() {
        let tolerance = Tolerance { relative: 0.01, floor: 1e-3, share: 0.2, cluster: 3 };
        let mut scattered = grey(0.5);
        let mut line = grey(0.5);
        for i in 0..4 {
            scattered.set([2 * i, 0], Rgb::grey(0.6));
            line.set([i, i], Rgb::grey(0.6)); // connected by corners
        }
        assert!(tolerance.accepts(&grey(0.5), &scattered));
        assert!(!tolerance.accepts(&grey(0.5), &line));
        assert_eq!(tolerance.disagreement(&grey(0.5), &line).cluster, 4);
    }
}
