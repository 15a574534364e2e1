//! The scratch copy: a clone of the last commit in `target/power`, with all changes in it, built once.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use anyhow::{Context, Result, ensure};
use serde_json::Value;

use crate::change::{self, Change, Places};

/// A test program of the scratch copy.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Program {
    /// Its name, as `chapters`.
    pub name: String,
    /// The executable.
    pub path: PathBuf,
    /// The folder of its package, in which it runs.
    pub folder: PathBuf,
}

/// The scratch copy, built.
pub struct Scratch {
    /// Its test programs.
    pub programs: Vec<Program>,
    /// The changes that no compiler takes (another type, a moved value).
    pub refused: BTreeSet<usize>,
}

/// A clone of the last commit of the repository `root` at `tree`, anew.
///
/// # Errors
/// What git and the file system say.
pub fn clone(root: &Path, tree: &Path) -> Result<()> {
    if tree.exists() {
        std::fs::remove_dir_all(tree)?;
    }
    let status = Command::new("git").args(["clone", "--quiet"]).arg(root).arg(tree).status()?;
    ensure!(status.success(), "git clone failed");
    Ok(())
}

/// Writes the changes into the tree and builds its tests, leaving out what the compiler refuses.
///
/// # Errors
/// A tree that does not compile although no change is where the compiler points.
pub fn build(tree: &Path, changes: &[Change]) -> Result<Scratch> {
    add_switch(tree)?;
    let originals: BTreeMap<&str, String> = changes
        .iter()
        .map(|it| Ok((it.file.as_str(), std::fs::read_to_string(tree.join(&it.file))?)))
        .collect::<Result<_>>()?;
    let mut refused = change::crossing(changes);
    loop {
        for (file, text) in &originals {
            std::fs::write(tree.join(file), text)?;
        }
        let places = change::write(tree, changes, &refused)?;
        // checked first: where a change does not compile, that is seen sooner
        let wrong =
            blamed(&compiled(tree, &["check", "--bins", "--tests", "--keep-going"])?, &places);
        if wrong.is_empty() {
            let messages = compiled(tree, &["test", "--no-run"])?;
            ensure!(
                messages.last().is_some_and(|it| it["success"] == true),
                "the tests do not compile"
            );
            let programs = programs(&messages);
            return Ok(Scratch { programs, refused });
        }
        for &index in &wrong {
            eprintln!("left out, because it does not compile: {}", changes[index].name);
        }
        refused.extend(wrong);
    }
}

/// The package of the switch, and every package of a product uses it.
fn add_switch(tree: &Path) -> Result<()> {
    let package = tree.with_file_name("planted");
    std::fs::create_dir_all(package.join("src"))?;
    std::fs::write(package.join("src/lib.rs"), include_str!("switch.rs"))?;
    std::fs::write(
        package.join("Cargo.toml"),
        "[package]\nname = \"planted\"\nversion = \"0.0.0\"\nedition = \"2024\"\n\n[workspace]\n",
    )?;
    let listed =
        Command::new("git").args(["ls-files", "*Cargo.toml"]).current_dir(tree).output()?;
    for manifest in String::from_utf8(listed.stdout)?.lines() {
        let path = tree.join(manifest);
        let text = std::fs::read_to_string(&path)?;
        let own = text.contains("\n[workspace]\n") && manifest != "Cargo.toml";
        if own || text.contains("\"planted\"") || !text.contains("\n[dependencies]\n") {
            continue;
        }
        let line = format!("\n[dependencies]\nplanted = {{ path = \"{}\" }}\n", package.display());
        std::fs::write(&path, text.replacen("\n[dependencies]\n", &line, 1))?;
    }
    Ok(())
}

/// What the compiler says.
fn compiled(tree: &Path, command: &[&str]) -> Result<Vec<Value>> {
    let output = Command::new("cargo")
        .args(command)
        .args(["--workspace", "--message-format=json"])
        .current_dir(tree)
        .env("CARGO_TARGET_DIR", tree.with_file_name("build"))
        .env("CARGO_INCREMENTAL", "0")
        .env("CARGO_PROFILE_DEV_DEBUG", "0")
        .stderr(Stdio::inherit())
        .output()
        .context("cargo")?;
    let lines = String::from_utf8_lossy(&output.stdout).into_owned();
    Ok(lines.lines().filter_map(|line| serde_json::from_str(line).ok()).collect())
}

/// The changes at which errors of the compiler point: the innermost one there, or else the nearest one of the file, since
/// an error of a function's result points at its head.
fn blamed(messages: &[Value], places: &BTreeMap<String, Places>) -> BTreeSet<usize> {
    let mut wrong = BTreeSet::new();
    for message in messages.iter().map(|it| &it["message"]).filter(|it| it["level"] == "error") {
        let spans = message["spans"].as_array().into_iter().flatten();
        let at = |mut span: &Value| {
            // in the text of a macro: where it is used
            while span["expansion"].is_object() {
                span = &span["expansion"]["span"];
            }
            let at = span["byte_start"].as_u64().unwrap_or(0) as usize;
            Some((places.get(span["file_name"].as_str()?)?, at))
        };
        let spans: Vec<(&Places, usize)> = spans.filter_map(at).collect();
        let holding = |(places, at): &(&Places, usize)| {
            let holds = places.iter().filter(|(range, _)| range.contains(at));
            holds.min_by_key(|(range, _)| range.len()).map(|(_, number)| *number)
        };
        let nearest = |(places, at): &(&Places, usize)| {
            let nearest = places.iter().min_by_key(|(range, _)| range.start.abs_diff(*at));
            nearest.map(|(_, number)| *number)
        };
        let held: Vec<usize> = spans.iter().filter_map(holding).collect();
        wrong.extend(if held.is_empty() {
            spans.iter().filter_map(nearest).collect()
        } else {
            held
        });
    }
    wrong
}

fn programs(messages: &[Value]) -> Vec<Program> {
    let mut programs: Vec<Program> = Vec::new();
    for message in messages {
        let (Some(path), Some(true)) =
            (message["executable"].as_str(), message["profile"]["test"].as_bool())
        else {
            continue;
        };
        let name = message["target"]["name"].as_str().unwrap_or("").to_owned();
        let manifest = PathBuf::from(message["manifest_path"].as_str().unwrap_or(""));
        let folder = manifest.parent().unwrap_or(Path::new("")).to_owned();
        programs.push(Program { name, path: path.into(), folder });
    }
    programs.sort();
    programs
}
