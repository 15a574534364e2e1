//! The tests of the scratch copy, each in a process of its own, so that it is known which changes it reaches.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use anyhow::{Context, Result};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use crate::scratch::Program;

/// A test that passes while nothing is planted.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Test {
    /// The program and the name, as `chapters ch03::spheres`.
    pub name: String,
    program: PathBuf,
    folder: PathBuf,
    /// How long it takes, alone in its process.
    pub seconds: f64,
    /// The numbers of the changes that it reaches.
    pub reached: BTreeSet<usize>,
}

/// How a test ended while a change was on.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum End {
    /// It passed.
    Passed,
    /// It failed, with this first message.
    Failed(String),
}

/// All tests of the programs that pass, each run once with nothing on; those that fail are named on standard error.
///
/// # Errors
/// A program that cannot be run.
pub fn reach(programs: &[Program], notes: &Path) -> Result<Vec<Test>> {
    std::fs::create_dir_all(notes)?;
    let mut names: Vec<(&Program, String)> = Vec::new();
    for program in programs {
        let ignored = listed(program, &["--list", "--ignored"])?;
        let all = listed(program, &["--list"])?;
        names.extend(all.difference(&ignored).map(|name| (program, name.clone())));
    }
    eprintln!("{} tests, each run once with nothing planted", names.len());
    let tests: Vec<Result<Option<Test>>> = names
        .par_iter()
        .enumerate()
        .map(|(index, (program, name))| {
            first_run(program, name, &notes.join(format!("{index}.txt")))
        })
        .collect();
    Ok(tests.into_iter().collect::<Result<Vec<_>>>()?.into_iter().flatten().collect())
}

/// The names of tests that a program lists.
fn listed(program: &Program, arguments: &[&str]) -> Result<BTreeSet<String>> {
    let mut command = Command::new(&program.path);
    let output = command.args(arguments).current_dir(&program.folder).output();
    let output = output.with_context(|| format!("{}", program.path.display()))?;
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    Ok(text.lines().filter_map(|it| it.strip_suffix(": test").map(str::to_owned)).collect())
}

fn first_run(program: &Program, name: &str, notes: &Path) -> Result<Option<Test>> {
    std::fs::write(notes, "")?;
    let mut test = Test {
        name: format!("{} {name}", program.name),
        program: program.path.clone(),
        folder: program.folder.clone(),
        seconds: 0.0,
        reached: BTreeSet::new(),
    };
    let start = Instant::now();
    let end = test.run(&[("PLANTED_REACHED", notes.as_os_str())], Duration::from_secs(900))?;
    test.seconds = start.elapsed().as_secs_f64();
    if let End::Failed(message) = end {
        eprintln!("not counted, it fails with nothing planted: {}: {message}", test.name);
        return Ok(None);
    }
    test.reached =
        std::fs::read_to_string(notes)?.lines().filter_map(|it| it.parse().ok()).collect();
    std::fs::remove_file(notes)?;
    Ok(Some(test))
}

impl Test {
    /// The test of this name, as `chapters ch03::spheres`, of which nothing else is known.
    ///
    /// # Errors
    /// No program of its first word.
    pub fn named(programs: &[Program], name: &str) -> Result<Self> {
        let program = name.split(' ').next().unwrap_or("");
        let program = programs.iter().find(|it| it.name == program);
        let program = program.with_context(|| format!("no program of the test {name}"))?;
        let (folder, path) = (program.folder.clone(), program.path.clone());
        Ok(Self { folder, program: path, ..Self::timed(name, 60.0) })
    }

    /// A test of no program that takes so many seconds.
    pub fn timed(name: &str, seconds: f64) -> Self {
        let (program, folder) = (PathBuf::new(), PathBuf::new());
        Self { name: name.to_owned(), program, folder, seconds, reached: BTreeSet::new() }
    }

    /// Runs the test while change `number` is on; a test that takes 20 times as long as it did is taken to have failed.
    ///
    /// # Errors
    /// A program that cannot be started.
    pub fn with(&self, number: usize) -> Result<End> {
        let limit = Duration::from_secs_f64(30.0 + 20.0 * self.seconds);
        self.run(&[("PLANTED", number.to_string().as_ref())], limit)
    }

    fn run(&self, variables: &[(&str, &std::ffi::OsStr)], limit: Duration) -> Result<End> {
        let name = self.name.split_once(' ').map_or("", |(_, name)| name);
        let output = Command::new("timeout")
            .args(["--kill-after=5", &limit.as_secs().max(1).to_string(), "sh", "-c"])
            // a mistake may ask for memory without end
            .args([
                "ulimit -v 16000000; exec \"$0\" --exact \"$1\"",
                &self.program.display().to_string(),
                name,
            ])
            .current_dir(&self.folder)
            .env("CARGO_MANIFEST_DIR", &self.folder)
            // a trace of calls is no message
            .env("RUST_BACKTRACE", "0")
            .envs(variables.iter().copied())
            .stdin(Stdio::null())
            .output()
            .context("timeout")?;
        if output.status.success() {
            return Ok(End::Passed);
        }
        let text =
            String::from_utf8_lossy(&output.stdout) + String::from_utf8_lossy(&output.stderr);
        Ok(End::Failed(first_message(&text)))
    }
}

/// What a failing test says first, without the place in the file: after the head of a panic, or the line of its name.
fn first_message(text: &str) -> String {
    let panicked = text.split_once("panicked at ").and_then(|(_, rest)| rest.split_once('\n'));
    let rest = panicked.or_else(|| text.split_once(" ----\n")).map_or(text, |(_, rest)| rest);
    let lines = rest
        .lines()
        .take_while(|line| !line.starts_with("note: run with") && !line.starts_with("failures:"));
    lines.take(12).collect::<Vec<_>>().join("\n").chars().take(1000).collect()
}
