//! The command line of `grade`: exit statuses, files, programs in single precision, and its document.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};
use std::time::Duration;

use serde_json::Value;

use super::structure::{read, root};

const GROUNDTRUTH: &str = env!("CARGO_BIN_EXE_groundtruth");
const TABLE: &str = "examples/grade/table.toml";

/// Started where the repository is.
fn grade(arguments: &[&str]) -> Output {
    let mut command = Command::new(GROUNDTRUTH);
    command.current_dir(root()).arg("grade").args(arguments).output().expect("it starts")
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

fn file(folder: &Path, name: &str) -> (PathBuf, String) {
    let path = folder.join(name);
    let shown = path.to_str().expect("text").to_owned();
    (path, shown)
}

/// Law: the commands that docs/grade.md shows print what it shows. Oracle: the document.
#[test]
fn the_document_shows_what_is_printed() {
    let page = read(&root().join("docs/grade.md"));
    let blocks: Vec<&str> = page.split("$ groundtruth grade ").skip(1).collect();
    assert_eq!(blocks.len(), 2, "a right program, and a wrong one");
    for (block, status) in blocks.into_iter().zip([0, 1]) {
        let (line, rest) = block.split_once('\n').expect("a line");
        let (shown, _) = rest.split_once("```").expect("the end of the block");
        let arguments: Vec<&str> = line.split(' ').collect();
        let output = grade(&arguments);
        assert_eq!(output.status.code(), Some(status), "{}", text(&output.stderr));
        let printed = text(&output.stdout);
        let (first, last) = shown.split_once("…\n").unwrap_or((shown, ""));
        assert!(printed.starts_with(first) && printed.ends_with(last), "{printed}");
        assert!(shown.contains('…') || printed == shown, "{printed}");
    }
}

/// Law: a program that computes in single precision gets all points. Oracle: the adapter in C++, in which each `double`
/// is a `float`.
#[test]
fn a_program_in_floats_loses_no_point() {
    if Command::new("g++").arg("--version").output().is_err() {
        return eprintln!("not tried: there is no g++");
    }
    let folder = tempfile::tempdir().expect("a folder");
    let source = read(&root().join("examples/conform/adapter.cpp"));
    let (path, shown) = file(folder.path(), "float.cpp");
    fs::write(path, source.replace("double", "float").replace(", 0.0)", ", 0.0f)"))
        .expect("it is written");
    let (_, program) = file(folder.path(), "float");
    let built = Command::new("g++").args(["-std=c++17", "-o", &program, &shown]).output();
    let built = built.expect("it runs");
    assert!(built.status.success(), "{}", text(&built.stderr));
    let output = grade(&[TABLE, "--", &program]);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stdout));
    let conform =
        Command::new(GROUNDTRUTH).args(["conform", "intersect.sphere", "--", &program]).output();
    assert_eq!(conform.expect("it starts").status.code(), Some(1), "floats are not doubles");
}

/// Law: the files have what is printed; a program that answers nothing gets 0 points in both files, the reason in the
/// table of the class, and status 2. Oracle: programs of one line.
#[test]
fn files_have_the_points_and_programs_that_fail_get_none() {
    let folder = tempfile::tempdir().expect("a folder");
    let ((results, shown_results), (class, shown_class)) =
        (file(folder.path(), "results.json"), file(folder.path(), "class.csv"));
    let of = |student: &str, program: &[&str]| {
        let files = ["--results", &shown_results, "--class", &shown_class, "--student", student];
        let limits = ["--timeout", "0.2", "--start-timeout", "0.2"];
        let output = grade(&[&[TABLE], &files[..], &limits, &["--"], program].concat());
        let results: Value = serde_json::from_str(&read(&results)).expect("JSON");
        (output, results)
    };
    for (student, program) in
        [("ends", "exit 3"), ("hangs", "sleep 9"), ("talks", "echo hello; cat")]
    {
        let (output, results) = of(student, &["sh", "-c", program]);
        assert_eq!(output.status.code(), Some(2), "{program}");
        assert_eq!(results["score"], 0.0);
        assert!(text(&output.stdout).contains("Your program answered no question"));
    }
    let (absent, _) = of("absent", &["./no-such-program"]);
    assert_eq!(absent.status.code(), Some(2));
    let (probe, results) = of("right", &[GROUNDTRUTH, "probe"]);
    assert_eq!(probe.status.code(), Some(0), "{}", text(&probe.stdout));
    assert_eq!(results["score"], 100.0);
    assert_eq!(results["stdout_visibility"], "hidden");
    let tests = results["tests"].as_array().expect("tests");
    let sum: f64 = tests.iter().filter_map(|test| test["max_score"].as_f64()).sum();
    assert_eq!((tests.len(), sum), (6, 100.0));
    let class = read(&class);
    let begins = |line: &str| class.lines().any(|found| found.starts_with(line));
    assert!(begins("right,100,30,20,15,15,10,10,0,0,"), "{class}");
    for student in ["ends", "hangs", "talks", "absent"] {
        let line = format!("{student},0,0,0,0,0,0,0,0,0,answered no question: ");
        assert!(begins(&line) || begins(&line.replace(",answered", ",\"answered")), "{class}");
    }
}

/// Law: what `--init` prints is a table, with another seed each time; a bad table, a missing program and a file that would be
/// lost end with 2. Oracle: the statuses.
#[test]
fn a_table_to_start_from_is_one_and_bad_ones_are_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let tables: Vec<String> = (0..2).map(|_| text(&grade(&["--init"]).stdout)).collect();
    assert_ne!(tables[0], tables[1]);
    let (path, shown) = file(folder.path(), "table.toml");
    fs::write(&path, &tables[0]).expect("it is written");
    let probe = ["--", GROUNDTRUTH, "probe"];
    let right = grade(&[&[shown.as_str()], &probe[..]].concat());
    assert_eq!(right.status.code(), Some(0), "{}", text(&right.stderr));
    let lost = grade(&[&[shown.as_str(), "--results", &shown], &probe[..]].concat());
    assert_eq!(lost.status.code(), Some(2));
    assert_eq!(read(&path), tables[0]);
    fs::write(&path, tables[0].replace("points = 30", "pionts = 30")).expect("it is written");
    let wrong = grade(&[&[shown.as_str()], &probe[..]].concat());
    assert_eq!(wrong.status.code(), Some(2));
    assert!(text(&wrong.stderr).contains("did you mean `points`?"), "{}", text(&wrong.stderr));
    assert_eq!(grade(&[TABLE]).status.code(), Some(2), "a program is needed");
}

/// Law: a run that is interrupted ends with status 130 and writes no file. Oracle: a program that makes a file when it is
/// asked the first question, and never answers.
#[test]
#[cfg(unix)]
fn an_interrupted_run_has_status_130_and_writes_nothing() {
    let folder = tempfile::tempdir().expect("a folder");
    let ((results, shown_results), (class, shown_class)) =
        (file(folder.path(), "results.json"), file(folder.path(), "class.csv"));
    let (asked, shown_asked) = file(folder.path(), "asked");
    let program = format!("read line; touch '{shown_asked}'; exec sleep 60");
    let mut command = Command::new(GROUNDTRUTH);
    command.current_dir(root()).args(["grade", TABLE, "--results", &shown_results]);
    command.args(["--class", &shown_class, "--student", "one", "--", "sh", "-c", &program]);
    let child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("it starts");
    while !asked.exists() {
        std::thread::sleep(Duration::from_millis(10));
    }
    let kill = Command::new("kill").args(["-INT", &child.id().to_string()]).status();
    assert!(kill.expect("kill starts").success());
    let output = child.wait_with_output().expect("it ends");
    assert_eq!(output.status.code(), Some(130), "{}", text(&output.stderr));
    assert!(!results.exists() && !class.exists());
}

/// Law: students who are graded at once are all in the table of their class. Oracle: their names.
#[test]
fn writers_at_once_lose_no_row() {
    let folder = tempfile::tempdir().expect("a folder");
    let (class, shown) = file(folder.path(), "class.csv");
    let students: Vec<String> = (0..6).map(|number| format!("student {number}")).collect();
    let limits = ["--timeout", "0.2", "--start-timeout", "0.2"];
    let start = |student: &String| {
        let mut command = Command::new(GROUNDTRUTH);
        command.current_dir(root()).args(["grade", TABLE, "--class", &shown, "--student", student]);
        command.args(limits).args(["--", "sh", "-c", "exit 3"]);
        command.stdout(Stdio::null()).stderr(Stdio::piped()).spawn().expect("it starts")
    };
    let running: Vec<Child> = students.iter().map(start).collect();
    for child in running {
        let output = child.wait_with_output().expect("it ends");
        assert_eq!(output.status.code(), Some(2), "{}", text(&output.stderr));
    }
    let class = read(&class);
    let found: Vec<&str> = class.lines().skip(1).filter_map(|row| row.split(',').next()).collect();
    assert_eq!(found, students);
}
