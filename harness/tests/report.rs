//! The command: files, errors, interruption.

use std::path::Path;
use std::process::{Command, Output, Stdio};

const GROUNDTRUTH: &str = env!("CARGO_BIN_EXE_groundtruth");

fn report(folder: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new(GROUNDTRUTH);
    command.current_dir(folder).arg("report").args(arguments).stdin(Stdio::null());
    command.output().expect("it starts")
}

fn files_in(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).expect("it is a folder");
    let name = |entry: std::io::Result<std::fs::DirEntry>| entry.expect("readable").file_name();
    let mut names: Vec<String> =
        entries.map(|entry| name(entry).to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

const TINY: [&str; 7] = ["--quick", "--cases", "3", "--objects", "100", "--samples", "4"];

/// Law: the command creates the folder with two files and nothing else; a second report replaces the
/// first.
#[test]
fn a_report_is_two_files() {
    let folder = tempfile::tempdir().expect("a folder");
    for only in ["intersections", "acceleration", "samplers", "light", "textures"] {
        let run = report(folder.path(), &[&["-o", "a/b", "--only", only][..], &TINY].concat());
        let stderr = String::from_utf8_lossy(&run.stderr).into_owned();
        assert_eq!(run.status.code(), Some(0), "{stderr}");
        assert!(stderr.starts_with("a/b/index.html and a/b/report.json: measured in "), "{stderr}");
        assert_eq!(files_in(folder.path()), ["a"]);
        let inside = folder.path().join("a/b");
        assert_eq!(files_in(&inside), ["index.html", "report.json"]);
        let text = std::fs::read_to_string(inside.join("report.json")).expect("a file");
        let json: serde_json::Value = serde_json::from_str(&text).expect("JSON");
        let pages: Vec<&String> = json["pages"].as_object().expect("pages").keys().collect();
        assert_eq!(pages, [only]);
    }
}

/// Law: an impossible request gets its error before anything is measured, and no file is written.
#[test]
fn errors_are_said_at_once_and_leave_nothing() {
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::write(folder.path().join("file"), "text").expect("a file");
    std::fs::create_dir_all(folder.path().join("taken/index.html")).expect("a folder");
    for (arguments, error) in [
        (
            &["-o", "a", "--only", "intersection"][..],
            "error: no page `intersection`; the pages are: intersections, acceleration, samplers, light, textures",
        ),
        (&["-o", "file"], "error: file: cannot be written: file is a file"),
        (&["-o", "file/a"], "error: file/a: cannot be written: file is a file"),
        (&["-o", "taken"], "error: taken/index.html: cannot be written: it is a folder"),
        (
            &["-o", "a", "--cases", "0"],
            "error: invalid value '0' for '--cases <N>': write a whole number from 1 to 1000000",
        ),
        (
            &["-o", "a", "--objects", "99"],
            "error: invalid value '99' for '--objects <N>': write a whole number from 100 to 1000000",
        ),
        (&[], "error: the following required arguments were not provided:"),
    ] {
        let run = report(folder.path(), arguments);
        let stderr = String::from_utf8_lossy(&run.stderr).into_owned();
        assert_eq!(run.status.code(), Some(2), "{arguments:?}: {stderr}");
        assert_eq!(stderr.lines().next(), Some(error), "{arguments:?}");
        assert_eq!(files_in(folder.path()), ["file", "taken"], "{arguments:?}");
    }
}

/// Law: an interrupted report ends soon with status 130 and a message, and leaves no file.
#[cfg(unix)]
#[test]
fn an_interrupted_report_leaves_nothing() {
    let folder = tempfile::tempdir().expect("a folder");
    let child = Command::new(GROUNDTRUTH)
        .current_dir(folder.path())
        .args(["report", "-o", "a", "--cases", "1000000", "--only", "intersections"])
        .stderr(Stdio::piped())
        .spawn()
        .expect("it starts");
    // by then the signal handler is installed, and the million cases take much longer
    std::thread::sleep(std::time::Duration::from_millis(1000));
    let kill = Command::new("kill").args(["-INT", &child.id().to_string()]).status();
    assert!(kill.expect("kill starts").success());
    let output = child.wait_with_output().expect("it ends");
    assert_eq!(output.status.code(), Some(130));
    assert_eq!(String::from_utf8_lossy(&output.stderr), "interrupted; nothing was written\n");
    assert_eq!(files_in(folder.path()), [""; 0]);
}

#[test]
fn help_speaks_of_every_option_and_page() {
    let run = report(Path::new("."), &["--help"]);
    let text = String::from_utf8_lossy(&run.stdout).into_owned();
    let options = ["--output", "--only", "--quick", "--cases", "--objects", "--seed", "--threads"];
    let pages = report::PAGES.iter().map(|page| page.name);
    for word in options.into_iter().chain(pages) {
        assert!(text.contains(word), "{word} in\n{text}");
    }
}
