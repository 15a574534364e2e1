//! Layers by `render`.

use std::collections::BTreeMap;
use std::path::Path;

use exr::prelude::{FlatSamples, ReadChannels, ReadLayers, read};
use groundtruth::film::read_exr;

use super::{files_in, run_in};

const SCENE: &[&str] = &["render", "ch28/glass-sphere", "--size", "24x16", "--samples", "2"];

/// Law: all layers are one file whose R, G and B are the picture's, also of a crop and with a mistake. Oracle: the picture
/// that `render` writes without them.
#[test]
fn all_layers_hold_the_picture() {
    let folder = tempfile::tempdir().expect("a folder");
    for more in [&[][..], &["--crop", "5,3,9x7"], &["--mistake", "no-eta-squared"]] {
        for (file, layers) in [("all.exr", &["--layers"][..]), ("picture.exr", &[])] {
            let run = run_in(folder.path(), &[SCENE, more, layers, &["-o", file]].concat());
            assert_eq!(run.status, Some(0), "{more:?}: {}", run.stderr);
            let names = "channels R, G, B, N.X, N.Y, N.Z, Ns.X";
            assert_eq!(run.stderr.contains(names), !layers.is_empty(), "{}", run.stderr);
        }
        let [all, picture] = ["all.exr", "picture.exr"]
            .map(|file| read_exr(&folder.path().join(file)).expect("it was written"));
        assert_eq!(all, picture, "{more:?}");
    }
}

/// Law: each colour of a false-colour picture is in its legend, if the legend names objects. Oracle: the pixels of the file
/// and the printed lines.
#[test]
fn the_legend_names_the_colours() {
    let folder = tempfile::tempdir().expect("a folder");
    let run = run_in(folder.path(), &[SCENE, &["--layer", "object", "-o", "a.png"]].concat());
    assert_eq!(run.status, Some(0), "{}", run.stderr);
    let rows = run.stderr.lines().filter_map(|line| line.trim().split_once(' '));
    let rows: Vec<_> = rows.filter(|(color, _)| color.starts_with('#')).collect();
    let picture = image::open(folder.path().join("a.png")).expect("it was written").into_rgb8();
    let mut seen: Vec<String> = picture
        .pixels()
        .map(|image::Rgb([r, g, b])| format!("#{r:02x}{g:02x}{b:02x}"))
        .filter(|color| color != "#181818")
        .collect();
    seen.sort();
    seen.dedup();
    let mut named: Vec<&str> = rows.iter().map(|(color, _)| *color).collect();
    named.sort_unstable();
    assert_eq!(seen, named, "{}", run.stderr);
    assert!(rows.iter().any(|(_, name)| name.contains("sphere")), "{}", run.stderr);
}

/// Law: what cannot be written is refused with what to write, and no file is left. Oracle: texts by hand.
#[test]
fn impossible_layers_are_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    for (arguments, hint) in [
        (&["--layer", "normals", "-o", "a.png"][..], "did you mean `normal`?"),
        (&["--layer", "light:nobody", "-o", "a.png"], "the scene's lights are"),
        (&["--layer", "normal", "-o", "a.pfm"], "written as .exr"),
        (&["--layers", "-o", "a.png"], "end its name with .exr"),
        (&["--layers", "--layer", "normal", "-o", "a.exr"], "cannot be used with"),
        (&["--layers", "--stereo", "anaglyph", "-o", "a.exr"], "cannot be used with"),
        (&["--layers", "--replicas", "2", "-o", "a.sums"], "cannot be used with"),
        (&["--layer", "z", "-o", "a.png"], "--against IMAGE"),
        (&["--layer", "difference", "-o", "a.exr"], "--against IMAGE"),
        (&["--against", "no.exr", "-o", "a.exr"], "add --layer difference"),
        (&["--layer", "normal", "--against", "no.exr", "-o", "a.exr"], "difference or z, not"),
        (&["--layer", "z", "--against", "no.exr", "-o", "a.pfm"], "written as .exr"),
        (&["--layers", "--against", "no.exr", "-o", "a.png"], "end its name with .exr"),
    ] {
        let run = run_in(folder.path(), &[SCENE, arguments].concat());
        assert_eq!(run.status, Some(2), "{arguments:?}: {}", run.stderr);
        assert!(run.stderr.contains(hint), "{arguments:?}: {}", run.stderr);
    }
    assert_eq!(files_in(folder.path()), [""; 0]);
}

/// The channels of an EXR file, by another program than ours: the crate's own reader.
fn channels(file: &Path) -> BTreeMap<String, Vec<f32>> {
    let image = read().no_deep_data().largest_resolution_level().all_channels();
    let image = image.first_valid_layer().all_attributes().from_file(file).expect("an EXR file");
    let channels = image.layer_data.channel_data.list.into_iter();
    let values = channels.map(|channel| match channel.sample_data {
        FlatSamples::F32(values) => (channel.name.to_string(), values),
        _ => panic!("{} is not in single precision", channel.name),
    });
    values.collect()
}

/// A picture in the scene's own shape.
const WHOLE: &[&str] = &["render", "ch28/glass-sphere", "--size", "24x24", "--samples", "2"];

/// Law: `difference` is their picture less ours, `z` has its sign and says what `verify` says, and `--layers` has both and all
/// others. Oracles: two files by `render`, subtracted by hand; the verdict of `verify`; the layers without another picture.
#[test]
fn layers_against_a_picture_are_its_difference() {
    let folder = tempfile::tempdir().expect("a folder");
    let run = |arguments: &[&str]| {
        let run = run_in(folder.path(), arguments);
        assert_eq!(run.status, Some(0), "{arguments:?}: {}", run.stderr);
        run
    };
    run(&[WHOLE, &["-o", "ours.exr"]].concat());
    run(&[WHOLE, &["--mistake", "fresnel-transmits-all", "--seed", "7", "-o", "theirs.exr"]]
        .concat());
    let scene: &[&str] = &["render", "ch28/glass-sphere", "--samples", "2"];
    let against = |more: &[&str]| run(&[scene, &["--against", "theirs.exr"], more].concat());

    against(&["--layer", "difference", "-o", "difference.exr"]);
    let [ours, theirs] = ["ours.exr", "theirs.exr"]
        .map(|file| read_exr(&folder.path().join(file)).expect("it was written"));
    let difference = channels(&folder.path().join("difference.exr"));
    let mut largest = 0.0_f64;
    for (index, name) in ["difference.R", "difference.G", "difference.B"].into_iter().enumerate() {
        let wanted = ours.pixels().iter().zip(theirs.pixels());
        let wanted = wanted.map(|(a, b)| b.to_array()[index] - a.to_array()[index]);
        for (found, wanted) in difference[name].iter().zip(wanted) {
            largest = largest.max(wanted.abs());
            // both pictures and the layer are in single precision
            let is_near = (f64::from(*found) - wanted).abs() <= 1e-6 * wanted.abs();
            assert!(is_near, "a value of {name}: {found}, not {wanted}");
        }
    }
    assert!(largest > 0.01, "the largest difference by the mistake: {largest}, not above 0.01");
    assert_eq!(difference.len(), 3, "channels of the difference");

    let told = against(&["--layer", "z", "-o", "z.exr"]).stderr;
    let verify =
        run_in(folder.path(), &["verify", "ch28/glass-sphere", "--samples", "2", "theirs.exr"]);
    let sentence = verify.stdout.lines().next().expect("a verdict").trim();
    assert!(told.contains(sentence), "no `{sentence}` in {told}");
    let z = channels(&folder.path().join("z.exr"));
    let (mut alike, mut far) = (0, 0);
    for (pixel, z) in z["z"].iter().enumerate().filter(|(_, z)| z.abs() > 3.0) {
        let sum: f32 = difference.values().map(|values| values[pixel]).sum();
        far += 1;
        // ours is one picture with its own noise
        alike += usize::from((sum > 0.0) == (*z > 0.0));
    }
    assert!(far >= 10 && 10 * alike >= 9 * far, "{alike} of {far} have the sign of the difference");
    against(&["--layer", "z", "-o", "z.png"]);
    let map = image::open(folder.path().join("z.png")).expect("it was written").into_rgb8();
    for (pixel, z) in map.pixels().zip(&z["z"]) {
        let grey = 255.0 * (0.5 + z / 12.0).clamp(0.0, 1.0);
        // half a byte is the rounding
        let is_near = pixel.0.iter().all(|byte| (f32::from(*byte) - grey).abs() <= 0.51);
        assert!(is_near, "the grey of z = {z}: {pixel:?}, not {grey}");
    }

    against(&["--layers", "-o", "all.exr"]);
    run(&[WHOLE, &["--layers", "-o", "ours-all.exr"]].concat());
    let mut wanted = channels(&folder.path().join("ours-all.exr"));
    wanted.extend(difference);
    wanted.extend(z);
    let found = channels(&folder.path().join("all.exr"));
    for (name, wanted) in &wanted {
        assert!(found.get(name) == Some(wanted), "the channel {name} of --layers is another");
    }
    assert_eq!(found.len(), wanted.len(), "channels of --layers");
}

/// Law: the picture of a difference is grey where there is none. Oracle: a picture of our own.
#[test]
fn our_own_picture_has_no_difference() {
    let folder = tempfile::tempdir().expect("a folder");
    for arguments in [
        [WHOLE, &["-o", "ours.exr"]].concat(),
        [
            "render",
            "ch28/glass-sphere",
            "--samples",
            "2",
            "--layer",
            "difference",
            "--against",
            "ours.exr",
            "-o",
            "a.png",
        ]
        .to_vec(),
    ] {
        let run = run_in(folder.path(), &arguments);
        assert_eq!(run.status, Some(0), "{arguments:?}: {}", run.stderr);
    }
    let picture = image::open(folder.path().join("a.png")).expect("it was written").into_rgb8();
    for (x, y, pixel) in picture.enumerate_pixels() {
        assert_eq!(pixel.0, [128; 3], "the colour of no difference at {x}, {y}");
    }
}
