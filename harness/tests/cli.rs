//! The command line: exit statuses, error texts, and that no unfinished file is left.

mod announced;
mod bounds;
mod columns_of_text;
mod errors;
mod exercise;
mod explain_json;
mod export;
#[cfg(unix)]
mod full_disk;
mod goldens;
#[cfg(unix)]
mod interrupt;
mod kept;
mod layers;
mod list;
mod provenance;
mod ranges;
mod stereo;
mod why_not;
mod witness;

use rayon::prelude::*;
use std::path::Path;
use std::process::{Command, Stdio};

const GROUNDTRUTH: &str = env!("CARGO_BIN_EXE_groundtruth");

/// The result of a run of the program.
struct Run {
    status: Option<i32>,
    stdout: String,
    stderr: String,
}

/// Runs the program in a folder.
fn run_in(folder: &Path, arguments: &[&str]) -> Run {
    let output = Command::new(GROUNDTRUTH)
        .current_dir(folder)
        .args(arguments)
        .stdin(Stdio::null())
        .output()
        .expect("it starts");
    let text = |bytes| String::from_utf8(bytes).expect("UTF-8");
    Run { status: output.status.code(), stdout: text(output.stdout), stderr: text(output.stderr) }
}

fn files_in(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).expect("it is a folder");
    let name = |entry: std::io::Result<std::fs::DirEntry>| entry.expect("readable").file_name();
    entries.map(|entry| name(entry).to_string_lossy().into_owned()).collect()
}

#[test]
fn good_commands_have_status_0() {
    let folder = tempfile::tempdir().expect("a folder");
    let small = ["--size", "16x12"];
    for arguments in [
        &["list"][..],
        &["list", "--json"],
        &["kinds"],
        &["list", "ch24", "ch28"],
        &["mistakes"],
        &["mistakes", "ch28"],
        &["mistakes", "ch28/glass-sphere"],
        &["mistakes", "no-fall-off", "-o", "c.png"],
        // the commands that it prints
        &["render", "ch18/fake-spherical", "--mistake", "no-fall-off", "-o", "d.png"],
        &["explain", "ch18/fake-spherical", "9,9", "--size", "16x16", "--mistake", "no-fall-off"],
        &["mistakes", "--page"],
        &["render", "ch03/single-sphere", "-o", "a.png", small[0], small[1]],
        &["render", "ch03/single-sphere", "-o", "b.exr", small[0], small[1], "--crop", "8,6,8x6"],
        &["render", "ch03/single-sphere", "-o", "a.png", small[0], small[1], "--threads", "1"],
        &["explain", "ch03/single-sphere", "100", "100"],
        &["explain", "ch28/glass-sphere", "300", "300", "--all", "--json"],
        &["export", "ch14/page-one"],
        &["describe", "ch14/page-one", small[0], small[1], "--samples", "4"],
        &["--help"],
        &["--version"],
        &["probe"],
    ] {
        let run = run_in(folder.path(), arguments);
        assert_eq!(run.status, Some(0), "{arguments:?}: {}", run.stderr);
    }
    let mut files = files_in(folder.path());
    files.sort();
    assert_eq!(files, ["a.png", "b.exr", "c.png", "d.png"]);
}

/// Law: `--version` says the version, and the commit of the source and its date. Oracle: git; where there is none, the words
/// that say so.
#[test]
fn the_version_says_the_commit() {
    let said = run_in(Path::new("."), &["--version"]).stdout;
    let log = ["log", "-1", "--format=%h of %cs"];
    let git = std::process::Command::new("git").args(log).output().ok();
    let source = git.filter(|git| git.status.success());
    let source = source.map_or("unknown source".to_owned(), |git| {
        String::from_utf8_lossy(&git.stdout).trim().to_owned()
    });
    assert_eq!(said, format!("groundtruth {} ({source})\n", env!("CARGO_PKG_VERSION")));
}

#[test]
fn help_speaks_of_every_option() {
    let scene = ["--size", "--samples", "--tracer", "--max-depth", "--seed", "<SCENE>"];
    for (command, options) in [
        ("list", &["--json"][..]),
        ("bounds", &["<SCENE>", "bunny.ply"]),
        (
            "render",
            &["--output", "--format", "--crop", "--stereo", "--threads", "--replicas", "--part"],
        ),
        ("merge", &["--output", "--standard-error", "not one picture"]),
        (
            "explain",
            &["<X,Y>", "--sample", "--all", "--min-share", "--largest", "--json", "--columns"],
        ),
        ("export", &["--output", "--replace"]),
        ("describe", &["another renderer", "formulas"]),
        ("kinds", &["--page", "--schema", "docs/scene.md"]),
        ("mistakes", &["--page", "--table", "--output", "docs/mistakes.md"]),
        ("probe", &["docs/probe.md"]),
    ] {
        let run = run_in(Path::new("."), &[command, "--help"]);
        assert_eq!(run.status, Some(0));
        let scene =
            if matches!(command, "list" | "kinds" | "mistakes" | "probe" | "merge" | "bounds") {
                &[][..]
            } else {
                &scene
            };
        for option in scene.iter().chain(options) {
            assert!(run.stdout.contains(option), "{command}: {option} in\n{}", run.stdout);
        }
        let whole = run_in(Path::new("."), &["--help"]).stdout;
        assert!(whole.contains(&format!("  {command} ")), "{command} in\n{whole}");
    }
}

/// Law: a chapter's scenes are those whose names begin with it. Oracle: the whole list.
#[test]
fn list_of_a_chapter_is_its_part_of_the_list() {
    let list = |chapters: &[&str]| {
        let run = run_in(Path::new("."), &[&["list", "--json"], chapters].concat());
        let lines: Vec<serde_json::Value> = serde_json::from_str(&run.stdout).expect("it is JSON");
        lines.into_iter().map(|line| line["name"].to_string()).collect::<Vec<_>>()
    };
    let mut expected = list(&[]);
    expected.retain(|name| name.starts_with("\"ch24/") || name.starts_with("\"ch28/"));
    assert!(expected.len() > 2);
    assert_eq!(list(&["ch28", "ch24"]), expected);
}

/// Law: it is no error if the reader of standard output closes the pipe.
#[test]
fn a_closed_pipe_is_no_error() {
    for arguments in [&["list"][..], &["export", "ch14/page-one"]] {
        let mut child = Command::new(GROUNDTRUTH)
            .args(arguments)
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .expect("it starts");
        drop(child.stdout.take());
        let output = child.wait_with_output().expect("it ends");
        assert_eq!(output.status.code(), Some(0), "{arguments:?}");
        assert!(output.stderr.is_empty(), "{arguments:?}");
    }
}

/// Law: the exported file of every gallery scene renders the same picture, bit for bit.
#[test]
fn an_exported_scene_renders_the_same_bits() {
    let scenes: Vec<gallery::Entry> = gallery::scenes().collect();
    scenes.into_par_iter().for_each(|entry| {
        let folder = tempfile::tempdir().expect("a folder");
        let render = |scene: &str, file: &str| {
            let size_and_threads = ["--size", "24x16", "--threads", "1"];
            let arguments = [&["render", scene, "-o", file][..], &size_and_threads].concat();
            let run = run_in(folder.path(), &arguments);
            assert_eq!(run.status, Some(0), "{scene}: {}", run.stderr);
            std::fs::read(folder.path().join(file)).expect("it was written")
        };
        let export = run_in(folder.path(), &["export", entry.name]);
        assert_eq!(export.status, Some(0), "{}: {}", entry.name, export.stderr);
        std::fs::write(folder.path().join("scene.toml"), export.stdout).expect("it can be written");
        assert!(render(entry.name, "a.exr") == render("scene.toml", "b.exr"), "{}", entry.name);
    });
}
