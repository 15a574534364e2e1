//! `groundtruth compare`: what cases cannot say.

#[path = "../pictures/tests/compare/films.rs"]
#[allow(dead_code)] // the laws of pictures use the rest of it
mod films;

use groundtruth::film::{self, Tone};

use self::films::{film_through, world};
use crate::kit::{Folder, repaint};

const HALL: &str = "ch24/hall-of-mirrors";

/// A folder with a picture, and one half as bright in every format.
fn pictures() -> Folder {
    let folder = Folder::new();
    folder.good(&format!(
        "for end in exr pfm; do groundtruth render {HALL} --size 60x40 --samples 4 -o film.$end; done"
    ));
    for end in ["exr", "pfm", "png", "ppm"] {
        repaint(&folder, "film.exr", &format!("dim.{end}"), &|_, color| {
            assert!(color.max() <= 2.0, "display formats hold it");
            0.5 * color
        });
    }
    folder
}

/// Law: the exit status is 0 for equal pictures, 1 for different ones, and 2 if they cannot be compared; formats
/// agree with each other. Oracle: files written from one film.
#[test]
fn the_exit_status_answers() {
    let folder = pictures();
    folder.write("text.png", "no picture");
    folder.good("groundtruth render ch14/set --size 45x30 --samples 1 -o pair.exr");
    let compare = |line: &str| folder.run(&format!("groundtruth compare {line}"));
    for (line, status) in [
        ("dim.exr dim.pfm", 0),
        ("dim.exr dim.png --encoding linear", 0),
        ("dim.ppm dim.exr --encoding linear", 0),
        ("dim.png dim.ppm", 0),
        ("dim.exr film.exr", 1),
        // the file says that its values are linear
        ("dim.exr dim.png", 0),
        ("dim.exr dim.png --encoding srgb", 1),
        ("film.exr ch24/hall-of-mirrors --tolerance 0.5", 1),
        // 60 columns less 5 are no two images
        ("dim.exr ch12/three-spheres", 2),
        ("dim.exr text.png", 2),
        ("dim.exr missing.png", 2),
        ("dim.exr no/such-scene", 2),
        ("dim.exr dim.pfm --encoding cie", 2),
    ] {
        let found = compare(line);
        assert_eq!(found.status, Some(status), "{line}: {found:?}");
    }
    // the image of each eye has (45 − 5)/2 columns
    compare("pair.exr ch12/three-spheres").expect(1, &["--size 20x30"]);
    let json = compare("dim.exr film.exr --json").expect(1, &[]).json();
    assert_eq!(json["explained_by"][0]["what"], "film.exr is dim.exr divided by 1/2");
}

/// Law: the page needs no other file, shows both pictures at three scales and two crops for each region, and says why they
/// differ and which commands come next. Oracle: counts; a picture that is shifted by half a pixel, and one half as bright.
#[test]
fn the_page_says_what_the_text_says() {
    let folder = pictures();
    folder.run("groundtruth compare dim.exr film.exr -o diff.html").expect(1, &[]);
    let html = folder.text("diff.html");
    assert!(html.matches("data:image/png;base64,iVBOR").count() >= 7, "{html}");
    assert!(html.contains("film.exr is dim.exr divided by 1/2"), "the page says why");
    for link in ["http:", "https:", "href=", "url(", "<script src", "<link"] {
        assert!(!html.contains(link), "the page needs {link}");
    }
    let regions = html.matches("the worst at (").count();
    assert_eq!(html.matches("% of the differences are within").count(), 3);
    let crops = html.matches("<i style=").count();
    assert_eq!(crops, 2 * (regions / 2), "in the text and in a row each");
    let name = "ch03/three-objects";
    let shifted = folder.path().join("shifted.exr");
    film::write(&film_through(&world(name), [0.0, 0.0]), &Tone::PLAIN, &shifted).expect("written");
    let window = format!("inspector {name} --compare shifted.exr");
    let told = folder.run(&format!("groundtruth compare shifted.exr {name} -o shifted.html"));
    let why = "explained: yours is half a pixel too far right and half a pixel too far up";
    let told = told.expect(1, &[why, &format!("to look: {window}\n")]).stdout;
    let html = folder.text("shifted.html");
    let commands: Vec<&str> =
        told.lines().filter_map(|line| line.strip_prefix("  groundtruth explain")).collect();
    assert!(!commands.is_empty(), "{told}");
    for words in commands.into_iter().chain([&*window]) {
        assert!(html.contains(words), "the page lacks {words}");
    }
}

/// Law: in whichever order they are given, a difference is yours − ours, and one of files or of two scenes is the second − the
/// first; for a scene with noise the last line is the command that judges it. Oracle: a picture half as bright.
#[test]
fn signs_have_one_direction() {
    let folder = pictures();
    let compare = |both: &str| folder.run(&format!("groundtruth compare {both}")).stdout;
    let text = compare(&format!("dim.pfm {HALL}"));
    assert_eq!(text, compare(&format!("{HALL} dim.pfm")));
    let red = text.lines().find(|line| line.starts_with("mean red: yours ")).expect("the mean");
    let percent: f64 =
        red.rsplit_once('−').expect("darker").1.trim_end_matches(" %").parse().expect("a number");
    assert!((percent - 50.0).abs() < 5.0 && red.contains(", ours "), "{red}");
    let last = text.lines().last().expect("lines");
    assert!(last.ends_with(&format!("groundtruth verify {HALL} dim.pfm")), "{last}");
    for (name, background) in [("dark.toml", 0.25), ("bright.toml", 0.5)] {
        let camera = "camera = { eye = [0, 0, 5], lens = { pinhole = { distance = 8 } } }";
        let image = "image = { width = 4, height = 4 }";
        folder.write(name, format!("{image}\n{camera}\nbackground = {background}\n"));
    }
    for [dark, bright] in [["dim.pfm", "film.pfm"], ["dark.toml", "bright.toml"]] {
        assert!(compare(&format!("{bright} {dark}")).contains(", −50.00 %"));
        assert!(compare(&format!("{dark} {bright}")).contains(", +100.00 %"));
    }
}
