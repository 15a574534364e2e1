//! Nothing is there that nobody calls; the compiler says so of what is private to a package alone.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use super::{read, rust_files, without_comments};

/// The folders of all code of the repository.
const FOLDERS: [&str; 10] = [
    "src",
    "formats",
    "gallery",
    "harness",
    "oracle/src",
    "inspector",
    "tests",
    "benches",
    "fuzz",
    "examples",
];

/// The words of a text of code; of strings, those that are one word, as attributes name functions.
fn words(code: &str) -> impl Iterator<Item = &str> {
    let parts = code.lines().flat_map(|line| line.split('"').enumerate());
    let parts = parts.filter(|(index, part)| index % 2 == 0 || !part.contains(' '));
    let is_apart = |c: char| !(c.is_alphanumeric() || c == '_');
    parts.flat_map(move |(_, part)| part.split(is_apart)).filter(|word| !word.is_empty())
}

/// The names of the public functions of a text of code.
fn public_functions(code: &str) -> BTreeSet<&str> {
    let named =
        |line: &'_ str| line.split_once("pub ").is_some_and(|(before, _)| before.trim().is_empty());
    code.lines()
        .filter(|line| named(line))
        .filter_map(|line| words(line.split_once(" fn ")?.1).next())
        .collect()
}

/// Law: the name of each public function is somewhere else than where it is defined. Oracle: the words of all code, without
/// comments.
#[test]
fn every_public_function_is_called() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let files = FOLDERS.iter().flat_map(|folder| rust_files(&root.join(folder)));
    let files = files.filter(|path| !path.components().any(|part| part.as_os_str() == "target"));
    let code: Vec<_> = files.map(|path| (without_comments(&read(&path)), path)).collect();
    let mut count: BTreeMap<&str, usize> = BTreeMap::new();
    code.iter()
        .flat_map(|(code, _)| words(code))
        .for_each(|word| *count.entry(word).or_default() += 1);
    let mut dead = Vec::new();
    for (code, path) in &code {
        let unused = public_functions(code).into_iter().filter(|name| count[name] == 1);
        dead.extend(unused.map(|name| format!("{}: {name}", path.display())));
    }
    assert!(dead.is_empty(), "nobody calls:\n{}", dead.join("\n"));
}
