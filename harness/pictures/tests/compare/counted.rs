//! What a comparison counts and measures, against slow definitions; and pictures of every size.

use groundtruth::math::Pcg32;
use pictures::compare::{Comparison, Picture, some_pixels};

use super::compared;
use crate::verbs::{between, equal, near};

/// Rounding of sums of a thousand numbers of magnitude 1.
const ROUNDING: f64 = 1e-12;

/// Sizes at which a loop may end too early or begin too late.
const SIZES: [[u32; 2]; 7] = [[1, 1], [1, 7], [8, 1], [2, 2], [5, 3], [16, 9], [33, 31]];

/// A picture of few different values, some of them no radiance.
fn picture([width, height]: [u32; 2], random: &mut Pcg32) -> Picture {
    let mut value = || match random.below(24) {
        0 => f32::NAN,
        1 => f32::INFINITY,
        2 => -0.25,
        other => (other / 8) as f32 * 0.5,
    };
    let pixels = (0..3 * width * height).map(|_| value());
    Picture::of_radiance(&pixels.collect::<Vec<f32>>(), [width, height])
}

/// Whether two pixels differ: by definition.
fn differ(a: [f32; 3], b: [f32; 3]) -> bool {
    a.iter().zip(b).any(|(a, b)| a.is_nan() || b.is_nan() || *a != b)
}

/// The label of each pixel that differs: that of the first pixel of its region. Labels spread until none changes.
fn labels(differs: &[bool], width: usize) -> Vec<usize> {
    let mut labels: Vec<usize> = (0..differs.len()).collect();
    let is_near = |a: usize, b: usize| {
        (a % width).abs_diff(b % width) <= 1 && (a / width).abs_diff(b / width) <= 1
    };
    loop {
        let before = labels.clone();
        for a in (0..labels.len()).filter(|at| differs[*at]) {
            for b in (0..labels.len()).filter(|at| differs[*at] && is_near(a, *at)) {
                labels[a] = labels[a].min(labels[b]);
            }
        }
        if labels == before {
            return labels;
        }
    }
}

/// Law: counts of NaN, infinite and negative values, means, root mean square, differing pixels and their regions agree with
/// their definitions, for pictures of every size. Oracle: loops over all pixels, and labels that spread from pixel to pixel.
#[test]
fn what_is_counted_is_there() {
    let random = &mut Pcg32::new(1, 21);
    for size in SIZES {
        for _ in 0..12 {
            let (a, mut b) = (picture(size, random), picture(size, random));
            // most pixels are equal, so that there are regions
            for (own, other) in b.values.iter_mut().zip(&a.values) {
                if random.below(4) > 0 && other.iter().all(|it| it.is_finite()) {
                    *own = *other;
                }
            }
            check(&a, &b, &compared(&a, &b));
        }
    }
}

fn check(a: &Picture, b: &Picture, found: &Comparison) {
    for (index, picture) in [a, b].into_iter().enumerate() {
        let count = |is_it: &dyn Fn(f32) -> bool| {
            picture.values.iter().flatten().filter(|value| is_it(**value)).count() as u64
        };
        let expected = [count(&f32::is_nan), count(&f32::is_infinite), count(&|it| it < 0.0)];
        let it = found.unusual[index];
        equal("NaN, infinite and negative values", [it.nan, it.infinite, it.negative], expected);
    }
    let finite = || {
        let both = a.values.iter().zip(&b.values);
        both.filter(|(a, b)| a.iter().chain(*b).all(|value| value.is_finite()))
    };
    let count = (finite().count() as f64).max(1.0);
    let mut squares = 0.0;
    for channel in 0..3 {
        let means = [0, 1].map(|side| {
            let of = |(a, b): (&[f32; 3], &[f32; 3])| f64::from([a, b][side][channel]);
            finite().map(of).sum::<f64>() / count
        });
        for side in [0, 1] {
            near("mean of a channel", found.means[side][channel], means[side], ROUNDING);
        }
        let apart = |(a, b): (&[f32; 3], &[f32; 3])| f64::from(b[channel]) - f64::from(a[channel]);
        squares += finite().map(apart).map(|it| it * it).sum::<f64>();
    }
    near("root mean square", found.root_mean_square, (squares / (3.0 * count)).sqrt(), ROUNDING);

    let width = a.size[0] as usize;
    let differs: Vec<bool> = a.values.iter().zip(&b.values).map(|(a, b)| differ(*a, *b)).collect();
    equal("differing pixels", found.differing, differs.iter().filter(|it| **it).count() as u64);
    let labels = labels(&differs, width);
    let is_first = |at: &usize| differs[*at] && labels[*at] == *at;
    let mut regions: Vec<(u64, [u32; 4])> = (0..labels.len())
        .filter(is_first)
        .map(|first| {
            let its = || (0..labels.len()).filter(|at| differs[*at] && labels[*at] == first);
            let [x, y] = [|at: usize, width: usize| at % width, |at, width| at / width]
                .map(|along| its().map(|at| along(at, width) as u32).collect::<Vec<u32>>());
            let ends =
                |all: &[u32]| [all.iter().min(), all.iter().max()].map(|it| *it.expect("some"));
            let ([left, right], [top, bottom]) = (ends(&x), ends(&y));
            (its().count() as u64, [left, top, right - left + 1, bottom - top + 1])
        })
        .collect();
    regions.sort_unstable();
    let mut listed: Vec<(u64, [u32; 4])> =
        found.regions.iter().map(|region| (region.pixels, region.bounds)).collect();
    equal("number of regions", listed.len(), regions.len().min(10));
    assert!(
        found.regions.windows(2).all(|two| two[0].pixels >= two[1].pixels),
        "the largest region comes first: found {listed:?}"
    );
    if regions.len() <= 10 {
        listed.sort_unstable();
        equal("regions", listed, regions);
    }
    let apart = |at: usize| {
        let channels = a.values[at].into_iter().zip(b.values[at]);
        let of = |(a, b): (f32, f32)| {
            if a == b {
                0.0
            } else {
                Some(f64::from((a - b).abs())).filter(|it| !it.is_nan()).unwrap_or(f64::INFINITY)
            }
        };
        channels.map(of).fold(0.0, f64::max)
    };
    let most = (0..labels.len()).filter(|at| differs[*at]).map(apart).fold(0.0, f64::max);
    near("largest difference", found.worst.map_or(0.0, |it| it.difference), most, 0.0);
    if let Some(worst) = found.worst {
        near("difference of the worst pixel", apart(a.index(worst.worst)), most, 0.0);
    }
}

/// Law: the sizes, the numbers of pixels and values, the shares and the means that are printed are those that were counted.
/// Oracle: the text, read by a person beside the values, of which each picture has sixteen.
#[test]
fn what_is_printed_was_counted() {
    let random = &mut Pcg32::new(2, 21);
    let texts = [[4, 4], [1, 16], [16, 1]].map(|size| {
        let [a, b] = [0, 1].map(|_| picture(size, random));
        format!("A {:?}\nB {:?}\n{}", a.values, b.values, compared(&a, &b))
    });
    insta::assert_snapshot!("printed", texts.join("\n"));
}

/// Law: channels are equal up to the tolerance, relative to the larger one, and differ at the next number beyond, in both
/// orders and with either sign. Oracle: 3 and 4 are a quarter of 4 apart.
#[test]
fn the_tolerance_is_a_border() {
    let one = |value: f32| Picture::of_radiance(&[0.0, value, 0.0], [1, 1]);
    for sign in [1.0, -1.0] {
        let three = 3.0_f32;
        for (far, count) in [(4.0_f32, 0), (4.0_f32.next_up(), 1), (4.0_f32.next_down(), 0)] {
            for (a, b) in [(three, far), (far, three)].map(|(a, b)| (sign * a, sign * b)) {
                let found = Comparison::of(&one(a), &one(b), 0.25).expect("one size");
                equal(format!("pixels of {a} and {b} that differ"), found.differing, count);
            }
        }
    }
}

/// Law: of any size, the pixels that are tried are in the picture, once each and in order, about as many as are asked for
/// (all, if there are fewer), and some are in odd and even columns and rows. Oracle: counts.
#[test]
fn the_pixels_that_are_tried_are_everywhere() {
    for size @ [width, height] in [
        [1, 1],
        [1, 300],
        [300, 1],
        [64, 64],
        [100, 41],
        [256, 256],
        [512, 512],
        [640, 360],
        [1024, 7],
    ] {
        for most in [1, 16, 256, 1 << 10, 1 << 12, 1 << 16] {
            let all: Vec<[u32; 2]> = some_pixels(size, most).collect();
            let (count, whole) = (all.len() as f64, f64::from(width * height));
            let expected = whole.min(most as f64);
            let what = format!("{width} × {height}, {most} asked for");
            between(
                format!("{what}: pixels"),
                count,
                [0.5 * expected, (2.0 * expected).min(whole)],
            );
            let index = |[x, y]: [u32; 2]| y * width + x;
            assert!(all.iter().all(|[x, y]| *x < width && *y < height), "{what}: outside");
            assert!(
                all.windows(2).all(|two| index(two[0]) < index(two[1])),
                "{what}: out of order"
            );
            if count >= 64.0 {
                for (axis, side) in [width, height].into_iter().enumerate() {
                    let odd = all.iter().filter(|at| at[axis] % 2 == 1).count() as f64;
                    let share = f64::from(side / 2) / f64::from(side);
                    near(format!("{what}: odd along axis {axis}"), odd / count, share, 0.1);
                }
            }
        }
    }
}
