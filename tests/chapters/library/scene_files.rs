//! Scene files that are wrong: each gets one error with file, line, object, field and the valid values;
//! never a panic, a hang or gigabytes of memory.

mod hostile_names;
mod light_bounds;
mod lists;
mod mesh_lists;
mod meshes;
mod not_finite;
mod places;
mod too_deep;

use super::check_refused;
use crate::prelude::*;

/// A valid scene.
const SCENE: &str = include_str!("scene_files/scene.toml");

/// The error of a scene text in `scene.toml`, without its pointer to the documentation.
fn error_of(text: &str) -> String {
    match scenefile::from_toml(text, Path::new("scene.toml")) {
        Err(error) => error.to_string().split("; see `").next().unwrap_or_default().to_owned(),
        Ok(_) => format!("this scene is read without an error:\n{text}"),
    }
}

/// The scene with one part replaced.
fn with(part: &str, replacement: &str) -> String {
    assert!(SCENE.contains(part), "{part} is in the scene");
    SCENE.replacen(part, replacement, 1)
}

/// Law: a scene that is wrong has one error, with line, object and field, and what would fit. Oracle: the table of texts.
#[test]
fn errors_name_line_object_and_field_and_say_what_would_fit() {
    check_refused(include_str!("scene_files/refused.toml"), |part, by| {
        error_of(&with(part, by)).replacen("scene.toml:", "", 1)
    });
}

/// Law: what an error of [`errors_name_line_object_and_field_and_say_what_would_fit`] says to write is a scene.
#[test]
fn what_an_error_says_to_write_is_right() {
    let mended = with("radius = 1", "radius = 1.2").replace("\"red\"", r"'C:\Users\me'");
    scenefile::from_toml(&mended, Path::new("scene.toml")).expect("it is right");
}

/// Law: a scene with both settings of the textbook's routines, its own and an object's, is written and read back
/// unchanged.
#[test]
fn epsilon_is_written_and_read_back() {
    let text = with("about = \"x\"\n", "about = \"x\"\nepsilon = 0.25\n");
    let textbook = "name = \"ball\"\nintersect = \"textbook\"\nepsilon = 0.125\n";
    let text = text.replacen("name = \"ball\"\n", textbook, 1);
    let read =
        |text: &str| scenefile::from_toml(text, Path::new("scene.toml")).expect("it is right").0;
    let written = scenefile::to_toml(&read(&text)).expect("plain data");
    for line in ["epsilon = 0.25", "intersect = \"textbook\"", "epsilon = 0.125"] {
        assert_eq!(written.matches(line).count(), 1, "{line}: {written}");
    }
    assert_eq!(scenefile::to_toml(&read(&written)).expect("plain data"), written);
}

/// Law: one scale factor means the same as three equal ones. Oracle: the form with three.
#[test]
fn a_scale_is_one_factor_or_three() {
    for (one, three) in [("0.75", "[0.75, 0.75, 0.75]"), ("-2", "[-2, -2, -2]")] {
        let step = |text: &str| -> Vec<groundtruth::math::Step> {
            let table: toml::Table =
                toml::from_str(&format!("s = [{{ scale = {text} }}]")).unwrap();
            table["s"].clone().try_into().unwrap()
        };
        assert_eq!(step(one), step(three));
    }
}

/// Law: a file that is not UTF-8 text gets the line and the byte in it, from 1. Oracle: where the test put it.
#[test]
fn bytes_that_are_no_text_get_line_and_byte() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("scene.toml");
    let utf16: Vec<u8> =
        std::iter::once(0xfeff).chain(SCENE.encode_utf16()).flat_map(u16::to_le_bytes).collect();
    let latin1 = with("\"x\"", "\"ü x\"").replacen("red", "§ed", 1);
    let latin1: Vec<u8> = latin1.chars().map(|c| c as u8).collect();
    let deep: Vec<u8> =
        with("eye", "# \u{1}ye").bytes().map(|b| if b == 1 { 0xff } else { b }).collect();
    for (bytes, error) in [
        (
            latin1,
            "scene.toml:1: byte 10 of the line, 0xfc, is not UTF-8: save the file as UTF-8 text",
        ),
        (
            deep,
            "scene.toml:12: byte 3 of the line, 0xff, is not UTF-8: save the file as UTF-8 text",
        ),
        (
            utf16,
            "scene.toml:1: byte 1 of the line, 0xff, is not UTF-8: the file is UTF-16 text; save it as UTF-8",
        ),
        (
            [0x89, b'P', b'N', b'G', b'\r', b'\n'].to_vec(),
            "scene.toml:1: byte 1 of the line, 0x89, is not UTF-8: the file is a picture; name a scene",
        ),
    ] {
        std::fs::write(&path, bytes).expect("written");
        let found = scenefile::read(&path).expect_err("it is no text").to_string();
        assert!(found.ends_with(error), "{found}");
    }
}
