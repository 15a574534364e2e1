//! Changes of whole pictures: each is named by what was done, and applied to each pixel.

use pictures::compare::{Change, Decoded, Picture, Transfer};

use super::{compared, mapped};
use crate::verbs::{between, equal, near};

/// Rounding of values near 1 in single precision, also if a curve makes it a few times as large.
const SINGLE: f64 = 1e-5;

/// A picture without symmetry.
fn ramp(side: u32) -> Picture {
    let value = |at: u32, by: u32| 0.1 + (at * by % 97) as f32 / 97.0 + at as f32 * 1e-6;
    let pixels = (0..side * side).flat_map(|at| [7, 11, 29].map(|by| value(at, by)));
    Picture::of_radiance(&pixels.collect::<Vec<f32>>(), [side; 2])
}

/// Law: of pictures that differ in odd columns alone, or even ones, half of the pixels differ, all of them in one of these
/// columns, and no change of the whole picture explains it; if both do, it is named. So for small pictures as for large
/// ones. Oracle: the change that was made.
#[test]
fn odd_columns_count_as_even_ones() {
    for side in [32, 512] {
        let ours = ramp(side);
        let halved = |is_wanted: &dyn Fn(usize) -> bool| {
            let mut theirs = ours.clone();
            for (at, color) in theirs.values.iter_mut().enumerate() {
                if is_wanted(at % side as usize) {
                    *color = color.map(|value| 0.5 * value);
                }
            }
            theirs
        };
        for parity in [0, 1] {
            let theirs = halved(&|column| column % 2 == parity);
            let found = compared(&ours, &theirs);
            let what = format!("side {side}, columns of parity {parity}");
            equal(format!("{what}: differing"), found.differing, u64::from(side * side / 2));
            equal(format!("{what}: explanations"), found.explained_by, vec![]);
            let worst = found.worst.expect("it differs").worst[0];
            equal(format!("{what}: parity of the worst column"), worst as usize % 2, parity);
        }
        let both = compared(&ours, &halved(&|_| true));
        let named = both.explained_by.first().map(|it| it.what.clone());
        equal(format!("side {side}: explanation"), named.as_deref(), Some("B is A divided by 2"));
    }
}

/// Law: each orientation, shift by a pixel, order of channels and factor is named by what was done to B, in a picture made of
/// numbers and in that of a scene. Oracle: the words, from how B was made.
#[test]
fn every_change_is_named() {
    for ours in [ramp(40), super::picture()] {
        let [width, height] = ours.size.map(i64::from);
        let mut cases: Vec<(Picture, String)> = Vec::new();
        let mut case = |theirs: Picture, words: &str| cases.push((theirs, words.to_owned()));
        let moved = |from: &dyn Fn(i64, i64) -> [i64; 2]| super::moved(&ours, from);
        case(moved(&|x, y| [x, height - 1 - y]), "the rows of B are upside down");
        case(
            moved(&|x, y| [width - 1 - x, y]),
            "left and right of B are exchanged (if its axes are left-handed: negate z in the scene)",
        );
        case(moved(&|x, y| [width - 1 - x, height - 1 - y]), "B is turned by 180°");
        if width == height {
            case(moved(&|x, y| [y, x]), "rows and columns of B are exchanged");
        }
        let steps = [-1, 0, 1].into_iter().flat_map(|x| [-1, 0, 1].map(|y| [x, y]));
        for [dx, dy] in steps.filter(|step| *step != [0, 0]) {
            let along = |step: i64, [less, more]: [&str; 2]| match step {
                0 => None,
                step => Some(format!("one pixel too far {}", if step < 0 { less } else { more })),
            };
            let words = [along(dx, ["left", "right"]), along(dy, ["up", "down"])];
            let words: Vec<String> = words.into_iter().flatten().collect();
            // what B shows lies so far from where A shows it
            case(moved(&|x, y| [x - dx, y - dy]), &format!("B is {}", words.join(" and ")));
        }
        let names = ["red", "green", "blue"];
        for order in [[2, 1, 0], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1]] {
            // the first channel of B is that of this name, and so on
            let theirs = mapped(&ours, |color| order.map(|channel| color[channel]));
            let words = order.map(|channel| names[channel]).join(", ");
            case(theirs, &format!("the channels of B are in the order {words}"));
        }
        let pixels = Change::of_pixels(ours.size).len();
        for (factor, name) in [(std::f32::consts::PI, "1/π"), (0.5, "2"), (1.25, "0.8000")] {
            let theirs = mapped(&ours, |color| color.map(|value| factor * value));
            case(theirs, &format!("B is A divided by {name}"));
        }
        equal("changes that are tried", cases.len() - 3, pixels);
        for (theirs, words) in cases {
            let found = compared(&ours, &theirs).explained_by;
            equal("explanation", found.first().map(|it| it.what.clone()), Some(words));
            // nothing is left but for what a shift repeats at the border
            between("what is left", found[0].left, [0.0, 0.02]);
        }
    }
}

/// Law: a changed picture has the radiance that the change gives each pixel, of floats and of integers by any curve; where the
/// change takes a value from outside, it has none. Oracle: the change of single pixels.
#[test]
fn a_changed_picture_is_changed_in_each_pixel() {
    let floats = ramp(9);
    let curves = [Transfer::Linear, Transfer::Srgb, Transfer::Gamma(2.2)];
    let integers = |transfer| Picture {
        transfer,
        step: Some(1.0 / 255.0),
        ..mapped(&floats, |color| color.map(|it| (255.0 * it.min(1.0)).round() / 255.0))
    };
    let mut changes = Change::of_pixels([9, 9]);
    changes.extend([Change::Same, Change::Scaled(0.5), Change::Scaled(0.9)]);
    changes.extend(curves.map(Change::Decoded));
    for picture in curves.map(integers).into_iter().chain([floats.clone()]) {
        let decoded = Decoded::new(&picture);
        for change in &changes {
            let changed = change.applied(&picture);
            for at in 0..81_u32 {
                let pixel = [i64::from(at % 9), i64::from(at / 9)];
                let expected = change.at(&decoded, pixel);
                let stored = changed.values[at as usize];
                let found = (!stored[0].is_nan())
                    .then(|| stored.map(|it| changed.transfer.decoded(it.into())));
                equal(
                    format!("{change:?}: pixel {pixel:?} is inside"),
                    found.is_some(),
                    expected.is_some(),
                );
                for (found, expected) in
                    found.into_iter().flatten().zip(expected.into_iter().flatten())
                {
                    let what = format!("{change:?} of {}, {pixel:?}", picture.transfer);
                    near(what, found, expected, SINGLE);
                }
            }
        }
    }
}

/// Law: a factor is named from a thousandth on. Oracle: factors on both sides.
#[test]
fn factors_begin_at_a_thousandth() {
    let ours = ramp(32);
    for (factor, is_named) in
        [(1.0009, false), (1.0011, true), (0.9991, false), (0.9989, true), (1.02, true)]
    {
        let theirs = mapped(&ours, |color| color.map(|it| (f64::from(it) / factor) as f32));
        let found = compared(&ours, &theirs).explained_by;
        equal(
            format!("{factor} is named"),
            found.iter().any(|it| it.what.contains("divided by")),
            is_named,
        );
    }
}
