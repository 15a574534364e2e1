//! The picture of a scene, and beside it that of a program with a mistake.

use std::path::Path;

use groundtruth::render;
use groundtruth::rgb::Rgb;
use groundtruth::world::{DEFAULT_SEED, World};
use judge::mistakes::{self, Beside, Mistaken};

use super::stage::small;

/// Law: the right picture is on the left, the wrong one on the right behind a white gap, and no pixel changes by more
/// than the one that is said to change most. Oracle: both programs, and the difference over the larger of value and mean.
#[test]
fn the_wrong_picture_is_on_the_right() {
    let scene = small("ch14/attenuated-set", 16, 1);
    let mistake = mistakes::find("no-fall-off").expect("it is known");
    let folder = Path::new("");
    let beside = Beside::of(mistake, &scene, folder, DEFAULT_SEED).expect("valid").expect("shown");
    let right = render::render(&World::build(&scene).expect("valid"));
    let mistaken = Mistaken::new(mistake, &scene, folder, DEFAULT_SEED).expect("valid");
    let wrong = render::render(&mistaken.expect("it applies"));
    let (both, width) = (beside.joined(), right.width());
    let gap = both.width() - 2 * width;
    assert!(gap > 0);
    assert_eq!(both.columns(0, width), right);
    assert_eq!(both.columns(width + gap, width), wrong);
    assert!(both.columns(width, gap).pixels().iter().all(|pixel| *pixel == Rgb::WHITE));

    let mean = right.pixels().iter().map(|it| (it.r + it.g + it.b) / 3.0).sum::<f64>()
        / right.pixels().len() as f64;
    let change = |at: [u32; 2]| {
        let (a, b) = (right.get(at).to_array(), wrong.get(at).to_array());
        (0..3).map(|k| (b[k] - a[k]).abs() / a[k].max(mean)).fold(0.0, f64::max)
    };
    let most = change(beside.most_changed());
    let all = (0..right.height()).flat_map(|y| (0..width).map(move |x| [x, y]));
    assert!(most > 0.1 && all.into_iter().all(|at| change(at) <= most));
}

/// Law: a mistake that changes nothing has no picture. Oracle: a scene without point lights.
#[test]
fn what_changes_nothing_has_no_picture() {
    let mistake = mistakes::find("no-fall-off").expect("it is known");
    let scene = small("ch18/environment", 8, 1);
    assert!(Beside::of(mistake, &scene, Path::new(""), DEFAULT_SEED).expect("valid").is_none());
}
