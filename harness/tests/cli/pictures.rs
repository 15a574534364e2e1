//! The files of `render`: how they were made, legends, stereo pairs, and scenes that show all of a mesh.

use formats::images;
use groundtruth::film::{Film, anaglyph, read_exr};

use crate::kit::{Folder, position};

const SMALL: &str = "groundtruth render --size 12x8 --samples 4 --seed 7";

fn film(folder: &Folder, name: &str) -> Film {
    read_exr(&folder.path().join(name)).expect("it was written")
}

/// Law: a PNG file has its making as text chunks and its gamma, before the data; our reader, which checks every
/// checksum, reads it. Oracle: the layout of a chunk, by hand.
#[test]
fn a_png_file_says_how_it_was_made() {
    let folder = Folder::new();
    folder.good(&format!("{SMALL} ch28/glass-sphere -o a.png --tracer whitted --max-depth 3"));
    let bytes = folder.bytes("a.png");
    let data = position(&bytes, b"IDAT").expect("it has data");
    let version = format!("Software\0groundtruth {}", env!("CARGO_PKG_VERSION"));
    for text in [
        &*version,
        "Scene\0ch28/glass-sphere",
        "Size\x0012x8",
        "Samples\x004",
        "Seed\x007",
        "Tracer\0whitted",
        "MaxDepth\x003",
    ] {
        let chunk = [&(text.len() as u32).to_be_bytes()[..], b"tEXt", text.as_bytes()].concat();
        assert!(position(&bytes, &chunk).is_some_and(|at| at < data), "{text:?}");
    }
    // gamma 1, as in the book: the values are radiance to the power 1
    let gamma = [&4_u32.to_be_bytes()[..], b"gAMA", &100_000_u32.to_be_bytes()].concat();
    assert_eq!(position(&bytes, &gamma), Some(33));
    let texels = images::decode(&bytes, None, 1000).expect("it is a PNG file");
    assert_eq!([texels.width(), texels.height()], [12, 8]);
}

/// Law: gamma 2.2 of a scene is 1/2.2 in its PNG file, and `render` says so; a name that is no ASCII is
/// UTF-8 text, without characters that end it; a scene that says nothing is named by its digest. Oracle: the layout of a
/// chunk, by hand.
#[test]
fn gamma_and_names_are_written_as_png_wants_them() {
    let folder = Folder::new();
    let export = folder.good("groundtruth export ch03/single-sphere");
    let (about, rest) = export.split_once('\n').expect("its first line says what it is");
    assert!(about.starts_with("about = ") && rest.contains("gamma = 1.0"), "{export}");
    let scene = rest.replace("gamma = 1.0", "gamma = 2.2");
    folder.write("a.toml", format!("about = \"eine Kügel\\u0000\"\n{scene}"));
    folder.write("unnamed.toml", scene);
    let said = |words: &str| folder.run(&format!("{SMALL} {words}")).expect(0, &[]).stderr;
    let of_png = said("a.toml -o a.png");
    let bytes = folder.bytes("a.png");
    let gamma = [&4_u32.to_be_bytes()[..], b"gAMA", &45_455_u32.to_be_bytes()].concat();
    assert_eq!(position(&bytes, &gamma), Some(33));
    assert!(position(&bytes, "iTXtScene\0\0\0\0\0eine Kügel\\u{0}".as_bytes()).is_some());
    images::decode(&bytes, None, 1000).expect("it is a PNG file");
    said("unnamed.toml -o b.png");
    assert!(position(&folder.bytes("b.png"), b"tEXtScene\0sha256:").is_some());
    for (said, words) in [
        (of_png, "radiance to the power 1/2.2; the file says so (gAMA)"),
        (said("a.toml -o a.ppm"), "radiance to the power 1/2.2; compare with --encoding gamma=2.2"),
        (said("a.toml -o a.exr"), "a.exr: values are linear radiance"),
    ] {
        assert!(said.contains(words), "{said}");
    }
}

/// Law: each colour of a false-colour picture is in its legend, if the legend names objects. Oracle: the pixels of the file
/// and the printed lines.
#[test]
fn the_legend_names_the_colours() {
    let folder = Folder::new();
    let render = "groundtruth render ch28/glass-sphere --size 24x16 --samples 2";
    let told = folder.run(&format!("{render} --layer object -o a.png")).expect(0, &[]).stderr;
    let rows = told.lines().filter_map(|line| line.trim().split_once(' '));
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
    assert_eq!(seen, named, "{told}");
    assert!(rows.iter().any(|(_, name)| name.contains("sphere")), "{told}");
}

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

/// Law: a pair is written as one picture side by side, as two files with the two images, or as an anaglyph
/// of both. Oracle: columns of the first picture, chosen by hand: the right eye's image is on the left.
#[test]
fn a_pair_is_written_in_three_ways() {
    let folder = Folder::new();
    folder.write("pair.toml", PAIR);
    for arguments in [
        "both.exr",
        "same.exr --stereo side-by-side",
        "a.b.exr --stereo two-files",
        "glasses.exr --stereo anaglyph",
        "part.exr --crop 10,0,8x8",
    ] {
        folder.good(&format!("groundtruth render pair.toml -o {arguments}"));
    }
    let names = "a.b-left.exr a.b-right.exr both.exr glasses.exr pair.toml part.exr same.exr";
    assert_eq!(folder.names().join(" "), names);
    let both = film(&folder, "both.exr");
    assert_eq!((both.width(), both.height()), (27, 8));
    assert_eq!(film(&folder, "same.exr"), both);
    let [left, right] = ["a.b-left.exr", "a.b-right.exr"].map(|name| film(&folder, name));
    assert_eq!(right, both.columns(0, 12));
    assert_eq!(left, both.columns(15, 12));
    assert!(left != right);
    assert_eq!(film(&folder, "glasses.exr"), anaglyph(&left, &right));
    assert_eq!(film(&folder, "part.exr"), both.columns(10, 8));
}
