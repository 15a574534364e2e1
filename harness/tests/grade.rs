//! The example that gives points to a class: it is tried where there is Python.

use serde_json::Value;

use crate::kit::{Folder, Run, has, text_of};

const GRADE: &str = "python3 $ROOT/examples/grade/grade.py";

/// Grades a program by a table.
fn grade(folder: &Folder, arguments: &str, program: &str) -> Run {
    folder.run(&format!("{GRADE} {arguments} --groundtruth $(command -v groundtruth) -- {program}"))
}

/// A folder with a table of these lines.
fn with_table(lines: &str) -> Folder {
    let folder = Folder::new();
    let head = "name,points,conform,pictures,references,options";
    folder.write("table.csv", format!("{head}\n{lines}"));
    folder
}

/// Law: the command that docs/grade.md shows prints what it shows, and a right program gets all points. Oracle: the document.
#[test]
fn the_document_shows_what_is_printed() {
    if !has("python3") {
        return;
    }
    let page = text_of("docs/grade.md");
    let (_, block) = page.split_once("$ python3 examples/grade/grade.py ").expect("a command");
    let (line, rest) = block.split_once('\n').expect("a line");
    let (shown, _) = rest.split_once("…\n").expect("what is left out");
    let (table, program) = line.split_once(" -- ").expect("a program");
    let (folder, here) = (Folder::new(), "cd $ROOT; python3 examples/grade/grade.py");
    let of = |program: &str| {
        let groundtruth = "--groundtruth $(command -v groundtruth)";
        folder.run(&format!("{here} {table} {groundtruth} -- {program}"))
    };
    let told = of(program).expect(1, &[]).stdout;
    assert!(told.starts_with(shown), "{told}");
    of("groundtruth probe").expect(0, &[]);
}

/// Law: each line of a table gives its points, also with line breaks in a name and of equal names; pictures are held to the
/// teacher's; files have what is printed, and no cell is a formula. Oracle: points by hand; pictures of one value.
#[test]
fn every_line_counts_and_files_have_the_points() {
    if !has("python3") {
        return;
    }
    let folder = with_table(
        "\"Glass,\nboth ways\",10,fresnel.cosine,,,--cases 2\nA hall,7,,mine.ppm,teacher.ppm,\n\
         A hall,5,,mine.ppm,other.ppm,\nA hall,3,,absent.ppm,teacher.ppm,\n",
    );
    for (name, value) in [("mine.ppm", 9), ("teacher.ppm", 9), ("other.ppm", 200)] {
        folder.write(name, format!("P3 2 1 255\n9 9 9 {value} 9 9\n"));
    }
    let files = "--folder . --results results.json --class class.csv";
    let arguments = format!("table.csv --seed 7 {files} --student =1+1");
    for (program, points) in [("groundtruth probe", 10.0), ("false", 0.0)] {
        grade(&folder, &arguments, program).expect(1, &[]);
        let found: Value = serde_json::from_str(&folder.text("results.json")).expect("JSON");
        let tests = found["tests"].as_array().expect("tests");
        let scores: Vec<_> = tests.iter().map(|test| test["score"].as_f64()).collect();
        assert_eq!(scores, [points, 7.0, 0.0, 0.0].map(Some));
        assert_eq!(found["score"], points + 7.0);
        assert_eq!(found["tests"][0]["name"], "Glass,\nboth ways");
    }
    let expected = "student,total,\"Glass,\nboth ways\",A hall,A hall,A hall\n'=1+1,17,10,7,0,0\n'=1+1,7,0,7,0,0\n";
    assert_eq!(folder.text("class.csv").replace("\r\n", "\n").replace(".0", ""), expected);
}

/// Law: a wrong table or word ends with 2, and the message names the place. Oracle: the messages.
#[test]
fn wrong_tables_are_refused() {
    if !has("python3") {
        return;
    }
    for (lines, problem) in [
        ("Glass,ten,fresnel,,,\n", "line 2: write a name, points above 0"),
        ("Glass,10,,,,\n", "line 2: write what to ask"),
        ("Glass,10,fresnle,,,\n", "fresnle"),
        ("", "there is no part"),
    ] {
        grade(&with_table(lines), "table.csv --seed 7", "groundtruth probe").expect(2, &[problem]);
    }
}
