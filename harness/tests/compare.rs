//! `groundtruth compare`.

#[path = "../pictures/tests/compare/films.rs"]
mod films;

use std::process::Command;

use groundtruth::film::{self, Film, Tone};
use groundtruth::rgb::Rgb;

use self::films::{film_through, rendered, world};

/// Law: the exit status is 0 for equal pictures, 1 for different ones, and 2 if they cannot be compared; formats
/// agree with each other. Oracle: files written from one film.
#[test]
fn the_exit_status_answers() {
    let folder = tempfile::tempdir().expect("a folder");
    let film = rendered("ch24/hall-of-mirrors", 1);
    let mut dim = Film::new(film.width(), film.height());
    for y in 0..film.height() {
        for x in 0..film.width() {
            dim.set([x, y], 0.5 * film.get([x, y]));
        }
    }
    let brighter = |pixel: &Rgb| pixel.max() > 1.0;
    assert!(!dim.pixels().iter().any(brighter), "display formats hold it");
    for format in ["exr", "pfm", "png", "ppm"] {
        film::write(&dim, &Tone::PLAIN, &folder.path().join(format!("dim.{format}")))
            .expect("written");
    }
    film::write(&film, &Tone::PLAIN, &folder.path().join("film.exr")).expect("written");
    std::fs::write(folder.path().join("text.png"), "no picture").expect("written");
    let status = |arguments: &[&str]| {
        let program = env!("CARGO_BIN_EXE_groundtruth");
        let output = Command::new(program)
            .arg("compare")
            .args(arguments)
            .current_dir(folder.path())
            .output();
        let output = output.expect("it starts");
        let text = [output.stdout, output.stderr].concat();
        (output.status.code(), String::from_utf8(text).expect("UTF-8"))
    };
    film::write(&Film::new(45, 30), &Tone::PLAIN, &folder.path().join("pair.exr"))
        .expect("written");
    let expected: [(&[&str], i32); 15] = [
        (&["dim.exr", "dim.pfm"], 0),
        (&["dim.exr", "dim.png", "--encoding", "linear"], 0),
        (&["dim.ppm", "dim.exr", "--encoding", "linear"], 0),
        (&["dim.png", "dim.ppm"], 0),
        (&["dim.exr", "film.exr"], 1),
        (&["dim.exr", "film.exr", "--json"], 1),
        // the file says that its values are linear
        (&["dim.exr", "dim.png"], 0),
        (&["dim.exr", "dim.png", "--encoding", "srgb"], 1),
        (&["film.exr", "ch24/hall-of-mirrors", "--tolerance", "0.5"], 1),
        (&["pair.exr", "ch12/three-spheres"], 1),
        // 60 columns less 5 are no two images
        (&["dim.exr", "ch12/three-spheres"], 2),
        (&["dim.exr", "text.png"], 2),
        (&["dim.exr", "missing.png"], 2),
        (&["dim.exr", "no/such-scene"], 2),
        (&["dim.exr", "dim.pfm", "--encoding", "cie"], 2),
    ];
    for (arguments, code) in expected {
        let (found, text) = status(arguments);
        assert_eq!(found, Some(code), "{arguments:?}: {text}");
    }
    let (found, _) = status(&["dim.exr", "film.exr", "-o", "diff.html"]);
    let html = std::fs::read_to_string(folder.path().join("diff.html")).expect("the page");
    assert_eq!((found, html.matches("data:image/png;base64,iVBOR").count() >= 7), (Some(1), true));
    assert!(html.contains("film.exr is dim.exr divided by 1/2"), "the page says why");
    for link in ["http:", "https:", "href=", "url(", "<script src", "<link"] {
        assert!(!html.contains(link), "the page needs {link}");
    }
    // the image of each eye has (45 − 5)/2 columns
    let (_, text) = status(&["pair.exr", "ch12/three-spheres"]);
    assert!(text.contains("--size 20x30"), "{text}");
    // three scales, and two crops for each region
    let regions = html.matches("the worst at (").count();
    assert_eq!(html.matches("% of the differences are within").count(), 3);
    assert_eq!(
        html.matches("<i style=").count(),
        2 * (regions / 2),
        "in the text and in a row each"
    );
    let name = "ch03/three-objects";
    let shifted = folder.path().join("shifted.exr");
    film::write(&film_through(&world(name), [0.0, 0.0]), &Tone::PLAIN, &shifted).expect("written");
    let (found, text) = status(&["shifted.exr", name, "-o", "shifted.html"]);
    let expected = "explained: yours is half a pixel too far right and half a pixel too far up";
    assert!(found == Some(1) && text.contains(expected), "{text}");
    let html = std::fs::read_to_string(folder.path().join("shifted.html")).expect("the page");
    let commands: Vec<&str> =
        text.lines().filter_map(|line| line.strip_prefix("  groundtruth explain")).collect();
    assert!(!commands.is_empty());
    let window = "inspector ch03/three-objects --compare shifted.exr";
    assert!(text.contains(&format!("to look: {window}\n")) && html.contains(window), "{text}");
    for command in commands {
        assert!(html.contains(command), "the page lacks {command}");
    }
    let (_, json) = status(&["dim.exr", "film.exr", "--json"]);
    let json: serde_json::Value = serde_json::from_str(&json).expect("JSON");
    assert_eq!(json["explained_by"][0]["what"], "film.exr is dim.exr divided by 1/2");
}

/// Law: in whichever order they are given, a difference is yours − ours, and one of files or of two scenes is the second − the
/// first; for a scene with noise the last line is the command that judges it. Oracle: a picture half as bright.
#[test]
fn signs_have_one_direction() {
    let folder = tempfile::tempdir().expect("a folder");
    let (film, scene) = (rendered("ch24/hall-of-mirrors", 1), "ch24/hall-of-mirrors");
    let mut dim = Film::new(film.width(), film.height());
    for y in 0..film.height() {
        for x in 0..film.width() {
            dim.set([x, y], 0.5 * film.get([x, y]));
        }
    }
    for (film, name) in [(&dim, "dim.pfm"), (&film, "whole.pfm")] {
        film::write(film, &Tone::PLAIN, &folder.path().join(name)).expect("written");
    }
    let compare = |both: [&str; 2]| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_groundtruth"));
        let output = command.arg("compare").args(both).current_dir(folder.path()).output();
        String::from_utf8(output.expect("it runs").stdout).expect("UTF-8")
    };
    let text = compare(["dim.pfm", scene]);
    assert_eq!(text, compare([scene, "dim.pfm"]));
    let red = text.lines().find(|line| line.starts_with("mean red: yours ")).expect("the mean");
    let percent: f64 =
        red.rsplit_once('−').expect("darker").1.trim_end_matches(" %").parse().expect("a number");
    assert!((percent - 50.0).abs() < 5.0 && red.contains(", ours "), "{red}");
    let last = text.lines().last().expect("lines");
    assert!(last.ends_with("groundtruth verify ch24/hall-of-mirrors dim.pfm"), "{last}");
    assert!(compare(["whole.pfm", "dim.pfm"]).contains(", −50.00 %"));
    assert!(compare(["dim.pfm", "whole.pfm"]).contains(", +100.00 %"));
    for (name, background) in [("dark.toml", 0.25), ("bright.toml", 0.5)] {
        let scene = format!(
            "image = {{ width = 4, height = 4 }}\nbackground = {background}\n\
             camera = {{ eye = [0, 0, 5], lens = {{ pinhole = {{ distance = 8 }} }} }}\n"
        );
        std::fs::write(folder.path().join(name), scene).expect("written");
    }
    assert!(compare(["bright.toml", "dark.toml"]).contains(", −50.00 %"));
    assert!(compare(["dark.toml", "bright.toml"]).contains(", +100.00 %"));
}

/// Law: the tolerance is from 0 to below 1, and a difference as large as it is none. Oracle: pictures of 3 and 4, a quarter of
/// 4 apart.
#[test]
fn the_tolerance_has_a_range() {
    let folder = tempfile::tempdir().expect("a folder");
    for (name, value) in [("three.pfm", 3.0), ("four.pfm", 4.0)] {
        let mut film = Film::new(1, 1);
        film.set([0, 0], Rgb::grey(value));
        film::write(&film, &Tone::PLAIN, &folder.path().join(name)).expect("written");
    }
    for (tolerance, expected) in
        [("0", 1), ("0.2499", 1), ("0.25", 0), ("0.999", 0), ("1", 2), ("-0.1", 2), ("nan", 2)]
    {
        let mut command = Command::new(env!("CARGO_BIN_EXE_groundtruth"));
        command.args(["compare", "three.pfm", "four.pfm", &format!("--tolerance={tolerance}")]);
        let output = command.current_dir(folder.path()).output().expect("it runs");
        let text = String::from_utf8_lossy(&output.stdout);
        assert_eq!(output.status.code(), Some(expected), "--tolerance {tolerance}: {text}");
    }
}
