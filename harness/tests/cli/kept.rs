//! `explain -o` and `explain --test`: what is kept of a pixel.

use std::path::Path;

use serde_json::Value;

use super::{files_in, run_in};

const KNOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../scenes/knot.ply");
const SMALL: [&str; 5] = ["explain", "ch28/glass-sphere", "20,15", "--size", "40x40"];

fn written(folder: &Path, file: &str) -> String {
    let run = run_in(folder, &[&SMALL[..], &["-o", file]].concat());
    assert_eq!((run.status, &*run.stdout), (Some(0), ""), "{file}: {}", run.stderr);
    std::fs::read_to_string(folder.join(file)).expect("it was written")
}

/// Law: the end of the name says what is written, and nothing else is left in the folder. Oracle: what each format begins
/// with; the JSON is that of --json.
#[test]
fn each_format_is_written_by_its_name() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    assert!(written(folder, "a.html").starts_with("<!DOCTYPE html>"));
    assert!(written(folder, "a.svg").starts_with("<svg "));
    let obj = written(folder, "a.OBJ");
    let about = "# the rays of pixel (20, 15) of ch28/glass-sphere\ng camera\n";
    assert!(obj.starts_with(about), "{obj}");
    let json = run_in(folder, &[&SMALL[..], &["--json"]].concat()).stdout;
    assert_eq!(written(folder, "a.json"), json);
    let mut files = files_in(folder);
    files.sort();
    assert_eq!(files, ["a.OBJ", "a.html", "a.json", "a.svg"]);
}

/// Law: a page shows the section of the ray that is asked for. Oracle: the words over it.
#[test]
fn the_page_shows_the_section_that_is_asked_for() {
    let folder = tempfile::tempdir().expect("a folder");
    let run = run_in(folder.path(), &[&SMALL[..], &["-o", "a.html", "--ray", "2"]].concat());
    assert_eq!(run.status, Some(0), "{}", run.stderr);
    let html = std::fs::read_to_string(folder.path().join("a.html")).expect("it was written");
    assert!(html.contains("<figcaption>Ray 2 at "));
}

/// Law: a file that the scene is made of is not written over. Oracle: its bytes.
#[test]
fn a_file_of_the_scene_is_not_written_over() {
    let folder = tempfile::tempdir().expect("a folder");
    let export = run_in(folder.path(), &["export", "ch16/shadows", "-o", "a.toml"]);
    assert_eq!(export.status, Some(0), "{}", export.stderr);
    let before = std::fs::read(folder.path().join("a.toml")).expect("it was written");
    let run = run_in(folder.path(), &["explain", "a.toml", "20,15", "--test", "-o", "./a.toml"]);
    assert_eq!(run.status, Some(2));
    assert!(run.stderr.contains("is read by this command"), "{}", run.stderr);
    assert_eq!(std::fs::read(folder.path().join("a.toml")).expect("it is there"), before);
}

fn radiance(folder: &Path, command: &[&str]) -> Value {
    let run = run_in(folder, &[command, &["--json"]].concat());
    assert_eq!(run.status, Some(0), "{}", run.stderr);
    let json: Value = serde_json::from_str(&run.stdout).expect("it is JSON");
    json["radiance"].clone()
}

/// Law: a reduced scene in another folder finds the mesh that the scene names, and the command that is printed gives the
/// radiance that is printed, which is that of the whole scene. Oracle: `explain` of both scenes.
#[test]
fn a_reduced_scene_gives_the_same_from_another_folder() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    std::fs::create_dir(folder.join("kept")).expect("created");
    std::fs::copy(KNOT, folder.join("knot.ply")).expect("copied");
    let mesh = run_in(folder, &["bounds", "knot.ply"]).stdout;
    let material = mesh.split("material = \"").nth(1).and_then(|rest| rest.split('"').next());
    let material = material.expect("the mesh has a material");
    let ball = format!(
        "\n[[objects]]\nname = \"far ball\"\nmaterial = \"{material}\"\n\
         shape.sphere = {{ center = [0, 0, 1e6], radius = 1 }}\n"
    );
    std::fs::write(folder.join("a.toml"), mesh.clone() + &ball).expect("written");
    let command = ["explain", "a.toml", "200,150"];
    let reduced = run_in(folder, &[&command[..], &["--test", "-o", "kept/b.toml"]].concat());
    assert_eq!(reduced.status, Some(0), "{}", reduced.stderr);
    let lines: Vec<&str> = reduced.stdout.lines().collect();
    assert!(lines[0].starts_with("1 of 2 objects, "), "{}", reduced.stdout);
    let scene = std::fs::read_to_string(folder.join("kept/b.toml")).expect("it was written");
    assert!(scene.contains("file = \"../knot.ply\""), "{scene}");
    let next: Vec<&str> =
        lines[2].strip_prefix("next: groundtruth ").expect("a command").split(' ').collect();
    let found = radiance(folder, &next);
    assert_eq!(found, radiance(folder, &command));
    let printed: Value =
        serde_json::from_str(lines[1].strip_prefix("radiance: ").expect("it")).expect("JSON");
    assert_eq!(found, printed);
}

/// Law: `--test` prints a test with the file's path, whose bits are those of `--json`. Oracle: the JSON.
#[test]
fn a_test_is_printed_with_the_bits_of_the_pixel() {
    let folder = tempfile::tempdir().expect("a folder");
    let command = ["explain", "ch16/shadows", "210,160"];
    let run = run_in(folder.path(), &[&command[..], &["--test"]].concat());
    assert_eq!(run.status, Some(0), "{}", run.stderr);
    let radiance = radiance(folder.path(), &command);
    let bits = |channel: &Value| format!("{:#018x}", channel.as_f64().expect("a number").to_bits());
    let expected =
        radiance.as_array().expect("a colour").iter().map(bits).collect::<Vec<_>>().join(", ");
    assert!(run.stdout.contains(&format!("let expected = [{expected}];")), "{}", run.stdout);
    assert!(run.stdout.contains("fn pixel_210_160_of_ch16_shadows()"));
    let file = run_in(folder.path(), &[&command[..], &["--test", "-o", "a.rs"]].concat());
    assert_eq!(file.status, Some(0), "{}", file.stderr);
    assert_eq!(std::fs::read_to_string(folder.path().join("a.rs")).expect("written"), run.stdout);
}
