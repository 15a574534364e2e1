//! Stereo pairs as files.

use std::path::Path;

use groundtruth::film::{anaglyph, read_exr};

use super::{files_in, run_in};

const PAIR: &str = r#"
image = { width = 12, height = 8, pixel_size = 0.5 }
background = 0.25

[camera]
eye = [0, 0, 10]
lens = { pinhole = { distance = 10 } }
stereo = { viewing = "transverse", gap = 3, separation = 20 }

[[materials]]
name = "white"
recipe = { emissive = {} }

[[objects]]
name = "ball"
material = "white"
shape = { sphere = { center = [0, 0, 3], radius = 1 } }
"#;

fn render(folder: &Path, more: &[&str]) -> super::Run {
    std::fs::write(folder.join("pair.toml"), PAIR).expect("it can be written");
    run_in(folder, &[&["render", "pair.toml"], more].concat())
}

/// Law: a pair is written as one picture side by side, as two files with the two images, or as an anaglyph
/// of both. Oracle: columns of the first picture, chosen by hand: the right eye's image is on the left.
#[test]
fn a_pair_is_written_in_three_ways() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = |name: &str| read_exr(&folder.path().join(name)).expect("it was written");
    for arguments in [
        &["-o", "both.exr"][..],
        &["-o", "same.exr", "--stereo", "side-by-side"],
        &["-o", "a.b.exr", "--stereo", "two-files"],
        &["-o", "glasses.exr", "--stereo", "anaglyph"],
        &["-o", "part.exr", "--crop", "10,0,8x8"],
    ] {
        let run = render(folder.path(), arguments);
        assert_eq!(run.status, Some(0), "{arguments:?}: {}", run.stderr);
    }
    let mut files = files_in(folder.path());
    files.sort();
    let expected = [
        "a.b-left.exr",
        "a.b-right.exr",
        "both.exr",
        "glasses.exr",
        "pair.toml",
        "part.exr",
        "same.exr",
    ];
    assert_eq!(files, expected);
    let both = at("both.exr");
    assert_eq!((both.width(), both.height()), (27, 8));
    assert_eq!(at("same.exr"), both);
    let (left, right) = (at("a.b-left.exr"), at("a.b-right.exr"));
    assert_eq!(right, both.columns(0, 12));
    assert_eq!(left, both.columns(15, 12));
    assert!(left != right);
    assert_eq!(at("glasses.exr"), anaglyph(&left, &right));
    assert_eq!(at("part.exr"), both.columns(10, 8));
}

/// Law: impossible options are refused before anything is rendered, and leave no file.
#[test]
fn impossible_stereo_options_are_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let refused = |run: super::Run, error: &str| {
        assert_eq!(run.status, Some(2), "{}", run.stderr);
        assert_eq!(run.stderr.lines().next(), Some(error));
        assert_eq!(files_in(folder.path()), ["pair.toml"]);
    };
    refused(
        render(folder.path(), &["-o", "a.png", "--stereo", "anaglyph", "--crop", "0,0,4x4"]),
        "error: --crop gives a part of the picture side by side; it goes with no other --stereo",
    );
    refused(
        render(folder.path(), &["-o", "a.png", "--crop", "20,0,8x8"]),
        "error: --crop 20,0,8x8 reaches beyond the picture of 27x8",
    );
    refused(
        run_in(
            folder.path(),
            &["render", "ch03/single-sphere", "-o", "a.png", "--stereo", "two-files"],
        ),
        "error: --stereo needs a scene whose camera has `stereo`; this one has one eye",
    );
    refused(
        run_in(folder.path(), &["explain", "pair.toml", "27", "0"]),
        "error: pixel (27, 0) is outside the picture of 27x8",
    );
}
