//! Layers by `render`.

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
    ] {
        let run = run_in(folder.path(), &[SCENE, arguments].concat());
        assert_eq!(run.status, Some(2), "{arguments:?}: {}", run.stderr);
        assert!(run.stderr.contains(hint), "{arguments:?}: {}", run.stderr);
    }
    assert_eq!(files_in(folder.path()), [""; 0]);
}
