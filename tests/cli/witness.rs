//! Other renderers on the command line: what cannot be said, and a program that is missing.

use std::path::Path;

use super::run_in;

/// Law: all that cannot be said is printed, a line each, with exit status 2, and no file is written;
/// without these terms it is. Oracle: figure 15.8 has four materials with highlights.
#[test]
fn an_export_that_cannot_be_said_lists_why() {
    let folder = tempfile::tempdir().expect("a folder");
    let arguments = ["export", "ch15/set", "--format", "pov", "-o", "scene.pov"];
    let run = run_in(folder.path(), &arguments);
    assert_eq!(run.status, Some(2), "{}", run.stderr);
    let highlights = run.stderr.lines().filter(|line| line.contains(": recipe.phong.ks: "));
    assert_eq!(highlights.count(), 4, "{}", run.stderr);
    assert!(!folder.path().join("scene.pov").exists());
    let run = run_in(folder.path(), &[&arguments[..], &["--without", "phong"]].concat());
    assert_eq!(run.status, Some(0), "{}", run.stderr);
    assert!(folder.path().join("scene.pov").exists());
}

/// Law: without the program the status is 2, and the message names what to write.
#[test]
fn a_missing_program_is_named() {
    let sphere = ["verify", "ch03/single-sphere", "--by", "pov", "--size", "8x8", "--program"];
    let missing = [&sphere[..], &["no/such/povray"]].concat();
    let run = run_in(Path::new("."), &missing);
    assert_eq!(run.status, Some(2), "{}", run.stderr);
    assert!(
        run.stderr.contains("--program no/such/povray: there is no such file"),
        "{}",
        run.stderr
    );
}

/// Law: so for pbrt, which has neither ambient light nor lights without shadows. Oracle: figure 14.1 has one of each.
#[test]
fn an_export_to_pbrt_lists_why_or_is_written() {
    let folder = tempfile::tempdir().expect("a folder");
    let arguments =
        ["export", "ch14/page-one", "--size", "40x40", "--format", "pbrt", "-o", "scene.pbrt"];
    let run = run_in(folder.path(), &arguments);
    assert_eq!(run.status, Some(2), "{}", run.stderr);
    assert!(
        run.stderr.starts_with("error: 1 thing in this scene cannot be said to pbrt:\n"),
        "{}",
        run.stderr
    );
    assert!(run.stderr.contains("source.ambient: "), "{}", run.stderr);
    assert!(!folder.path().join("scene.pbrt").exists());
    let run =
        run_in(folder.path(), &[&arguments[..], &["--without", "ambient,shadowless"]].concat());
    assert_eq!(run.status, Some(0), "{}", run.stderr);
    let text = std::fs::read_to_string(folder.path().join("scene.pbrt")).expect("it is written");
    assert!(text.contains("Film \"rgb\" \"integer xresolution\" [ 40 ]"), "{text}");
}
