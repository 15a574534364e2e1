//! The structure of the library and of the window: which module may name which, and that every kind's file has an entry.
//!
//! The tests read the source text: `crate::` paths outside comments, `mod` lines and lists.

mod arrows;
mod budget;
mod dead;
mod features;
mod kinds;
mod packages;

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use crate::kit::root;

fn sources() -> PathBuf {
    root().join("src")
}

fn read(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

/// The Rust files of a folder and its subfolders.
pub fn rust_files(folder: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).expect("the folder is there") {
        let path = entry.expect("its entries can be read").path();
        if path.is_dir() {
            files.extend(rust_files(&path));
        } else if path.extension().is_some_and(|e| e == "rs") {
            files.push(path);
        }
    }
    files.sort();
    files
}

/// The code of the files of a crate's sources, by module: `src/shapes/disk.rs` is `shapes`. Comments are left
/// out: documentation may name anything. The command line is not a module of the library.
fn code_by_module(sources: &Path) -> BTreeMap<String, Vec<(PathBuf, String)>> {
    let mut modules: BTreeMap<String, Vec<(PathBuf, String)>> = BTreeMap::new();
    for path in rust_files(sources) {
        let inside = path.strip_prefix(sources).expect("it is a source").to_owned();
        let first = inside.iter().next().expect("it has a name").to_string_lossy();
        let module = first.trim_end_matches(".rs").to_owned();
        if !["lib", "main", "cli"].contains(&module.as_str()) {
            modules.entry(module).or_default().push((inside, without_comments(&read(&path))));
        }
    }
    modules
}

fn without_comments(text: &str) -> String {
    let code = |line: &str| line.split_once("//").map_or(line, |(code, _)| code).to_owned();
    text.lines().map(code).collect::<Vec<_>>().join("\n")
}
