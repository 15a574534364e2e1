//! Laws of the program as cases: each file of the folder `cases` holds laws, and each law the lines of a shell with what they
//! print. CONTRIBUTING.md says how they are written.

use std::collections::BTreeMap;

use serde::Deserialize;

use super::kit::{Folder, Run, has, names_in, root, run, text_of};

/// A file of laws.
#[derive(Deserialize)]
struct Cases {
    /// What each law's folder holds at first, by name.
    #[serde(default)]
    files: BTreeMap<String, String>,
    /// Variables of the shell.
    #[serde(default)]
    env: BTreeMap<String, String>,
    /// Steps that each law begins with.
    #[serde(default)]
    before: String,
    /// Each under its sentence.
    #[serde(flatten)]
    laws: BTreeMap<String, Law>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Law {
    /// A program without which it is not tried.
    needs: Option<String>,
    #[serde(default)]
    files: BTreeMap<String, String>,
    #[serde(default)]
    env: BTreeMap<String, String>,
    /// What is expected of each command whose status is not 0.
    each: Option<String>,
    steps: String,
    /// The names of the files that are there in the end.
    left: Option<Vec<String>>,
}

/// What is wrong with what a line printed, by the expectation beneath it: `None` if nothing is.
fn problem(expected: &str, run: &Run) -> Option<String> {
    let (mark, words) = expected.split_once(' ').unwrap_or((expected, ""));
    let text = if mark.starts_with('>') { &run.stdout } else { &run.stderr };
    let is_met = match mark {
        ">" | "!" => text.contains(words),
        ">*" => words.split_whitespace().all(|word| text.contains(word)),
        ">1" | "!1" => text.lines().next() == Some(words),
        ">>" | "!!" => text.lines().last() == Some(words),
        ">0" | "!0" => text.is_empty(),
        "~" => !run.stdout.contains(words) && !run.stderr.contains(words),
        _ => return Some(format!("`{expected}` is neither a command nor an expectation")),
    };
    (!is_met).then(|| format!("expected {expected}"))
}

/// The status that a step expects, and its line; `None` for an expectation.
fn command(step: &str) -> Option<(i32, &str)> {
    let (status, line) = step.split_once("$ ")?;
    let status = if status.is_empty() { Some(0) } else { status.parse().ok() };
    Some((status?, line))
}

/// Runs the steps, up to the first that does something else than it should.
fn problem_of(cases: &Cases, law: &Law) -> Option<String> {
    let folder = Folder::new();
    cases.files.iter().chain(&law.files).for_each(|(name, text)| folder.write(name, text));
    let mut done: Option<(&str, Run)> = None;
    // a line that ends with a backslash goes on
    let text = format!("{}\n{}", cases.before, law.steps).replace("\\\n", " ");
    let steps = text.lines().map(str::trim_start);
    for step in steps.filter(|step| !step.is_empty() && !step.starts_with('#')) {
        let problem = match (command(step), &done) {
            (Some((status, line)), _) => {
                let run = run(line, folder.command(line).envs(&cases.env).envs(&law.env));
                let is_met = run.status == Some(status);
                let of_each =
                    law.each.as_ref().filter(|_| status != 0).and_then(|it| problem(it, &run));
                let status = format!("expected status {status}, found {:?}", run.status);
                done = Some((step, run));
                if is_met { of_each } else { Some(status) }
            }
            (None, Some((_, run))) => problem(step, run),
            (None, None) => Some(format!("`{step}` stands beneath no command")),
        };
        if let (Some(problem), Some((step, run))) = (problem, &done) {
            let Run { stdout, stderr, .. } = run;
            return Some(format!(
                "{step}\n{problem}\nfound on standard output:\n{stdout}\non standard error:\n{stderr}"
            ));
        }
    }
    let left = law.left.as_ref().filter(|left| **left != folder.names())?;
    Some(format!("expected the files {left:?}, found {:?}", folder.names()))
}

/// Holds the laws of a file.
fn hold(name: &str) {
    let text = text_of(&format!("harness/tests/cases/{name}.toml"));
    let cases: Cases = toml::from_str(&text).unwrap_or_else(|e| panic!("cases/{name}.toml: {e}"));
    let mut wrong = String::new();
    for (sentence, law) in &cases.laws {
        assert!(sentence.contains(" Oracle: "), "cases/{name}.toml: {sentence}");
        if law.needs.as_deref().is_none_or(has) {
            let problem = problem_of(&cases, law);
            wrong += &problem.map_or(String::new(), |it| format!("\n{sentence}\n{it}"));
        }
    }
    if !wrong.is_empty() {
        panic!("cases/{name}.toml: {wrong}");
    }
}

macro_rules! files_of_cases {
    ($($name:ident)*) => {
        $(
            #[test]
            fn $name() {
                hold(stringify!($name));
            }
        )*

        /// Law: each file of cases is a test. Oracle: the folder.
        #[test]
        fn every_file_is_held() {
            let mut files = vec![$(concat!(stringify!($name), ".toml").to_owned()),*];
            files.sort();
            assert_eq!(names_in(&root().join("harness/tests/cases")), files);
        }
    };
}

files_of_cases!(conform errors exercise explain export goldens help laws list merge processes ranges render renderers verify);
