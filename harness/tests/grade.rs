//! The example that gives points to a class: it is tried where there is Python.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use serde_json::Value;

use super::structure::{read, root};

const GROUNDTRUTH: &str = env!("CARGO_BIN_EXE_groundtruth");

/// Started where the repository is; nothing where there is no Python.
fn grade(arguments: &[&str]) -> Option<Output> {
    let split = arguments.iter().position(|word| *word == "--").unwrap_or(arguments.len());
    let mut command = Command::new("python3");
    command.current_dir(root()).arg("examples/grade/grade.py").args(&arguments[..split]);
    command.args(["--groundtruth", GROUNDTRUTH]).args(&arguments[split..]);
    command.output().map_err(|_| eprintln!("not tried: there is no python3")).ok()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

/// A table of these lines.
fn table(folder: &Path, lines: &str) -> String {
    let path = folder.join("table.csv");
    fs::write(&path, format!("name,points,conform,pictures,references,options\n{lines}"))
        .expect("it is written");
    path.display().to_string()
}

/// Law: the command that docs/grade.md shows prints what it shows, and a right program gets all points. Oracle: the document.
#[test]
fn the_document_shows_what_is_printed() {
    let page = read(&root().join("docs/grade.md"));
    let (_, block) = page.split_once("$ python3 examples/grade/grade.py ").expect("a command");
    let (line, rest) = block.split_once('\n').expect("a line");
    let (shown, _) = rest.split_once("…\n").expect("what is left out");
    let arguments: Vec<&str> = line.split(' ').collect();
    let Some(output) = grade(&arguments) else { return };
    assert!(text(&output.stdout).starts_with(shown), "{}", text(&output.stdout));
    assert_eq!(output.status.code(), Some(1));
    let right =
        grade(&[&arguments[..4], &[GROUNDTRUTH, "probe"]].concat()).expect("Python is there");
    assert_eq!(right.status.code(), Some(0), "{}", text(&right.stdout));
}

/// Law: each line of a table gives its points, also with line breaks in a name and of equal names; pictures are held to the
/// teacher's; files have what is printed, and no cell is a formula. Oracle: points by hand; pictures of one value.
#[test]
fn every_line_counts_and_files_have_the_points() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = |name: &str| folder.path().join(name).display().to_string();
    for (name, value) in [("mine.ppm", 9), ("teacher.ppm", 9), ("other.ppm", 200)] {
        fs::write(at(name), format!("P3 2 1 255\n9 9 9 {value} 9 9\n")).expect("it is written");
    }
    let lines = format!(
        "\"Glass,\nboth ways\",10,fresnel.cosine,,,--cases 2\nA hall,7,,mine.ppm,{0},\nA hall,5,,mine.ppm,{1},\n\
         A hall,3,,absent.ppm,{0},\n",
        at("teacher.ppm"),
        at("other.ppm")
    );
    let (table, results, class) =
        (table(folder.path(), &lines), at("results.json"), at("class.csv"));
    let place = folder.path().display().to_string();
    let options = [
        "--seed",
        "7",
        "--folder",
        &place,
        "--results",
        &results,
        "--class",
        &class,
        "--student",
        "=1+1",
    ];
    let of =
        |program: &[&str]| grade(&[&[table.as_str()], &options[..], &["--"], program].concat());
    for (program, points) in [(&[GROUNDTRUTH, "probe"][..], 10.0), (&["false"], 0.0)] {
        let Some(output) = of(program) else { return };
        assert_eq!(output.status.code(), Some(1), "{}", text(&output.stderr));
        let found: Value = serde_json::from_str(&read(Path::new(&results))).expect("JSON");
        let scores =
            found["tests"].as_array().expect("tests").iter().map(|test| test["score"].as_f64());
        assert_eq!(scores.collect::<Vec<_>>(), [points, 7.0, 0.0, 0.0].map(Some));
        assert_eq!(found["score"], points + 7.0);
        assert_eq!(found["tests"][0]["name"], "Glass,\nboth ways");
    }
    let class = read(Path::new(&class));
    let expected = "student,total,\"Glass,\nboth ways\",A hall,A hall,A hall\n'=1+1,17.0,10.0,7.0,0,0\n'=1+1,7.0,0,7.0,0,0\n";
    let plain = class.replace("\r\n", "\n").replace(".0", "");
    assert_eq!(plain, expected.replace(".0", ""));
}

/// Law: a wrong table or word ends with 2, and the message names the place. Oracle: the messages.
#[test]
fn wrong_tables_are_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    for (lines, problem) in [
        ("Glass,ten,fresnel,,,\n", "line 2: write a name, points above 0"),
        ("Glass,10,,,,\n", "line 2: write what to ask"),
        ("Glass,10,fresnle,,,\n", "fresnle"),
        ("", "there is no part"),
    ] {
        let table = table(folder.path(), lines);
        let Some(output) = grade(&[&table, "--seed", "7", "--", GROUNDTRUTH, "probe"]) else {
            return;
        };
        assert_eq!(output.status.code(), Some(2), "{lines}");
        assert!(text(&output.stderr).contains(problem), "{}", text(&output.stderr));
    }
}
