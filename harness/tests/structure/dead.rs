//! Nothing is there that nobody calls; the compiler says so of what is private to a package alone.

use std::collections::BTreeMap;
use std::path::Path;

use super::{read, rust_files, without_comments};

/// The folders of all code of the repository.
const FOLDERS: [&str; 13] = [
    "src",
    "explain",
    "formats",
    "gallery",
    "harness",
    "kind",
    "oracle/src",
    "inspector",
    "scenefile",
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

/// What has a name of its own that others can use; `fn` before `const`, as in `pub const fn`.
const ITEMS: [&str; 7] = [" fn ", " struct ", " enum ", " trait ", " type ", " static ", " const "];

/// The name of the public item that begins on this line of code, if one does.
fn public_item(line: &str) -> Option<&str> {
    let (before, _) = line.split_once("pub ")?;
    let (_, rest) = ITEMS.iter().find_map(|item| line.split_once(item))?;
    words(rest).next().filter(|_| before.trim().is_empty())
}

/// Law: the name of each public function, type and constant is somewhere else than where it is defined. Oracle: the words
/// of all code, without comments.
#[test]
fn every_public_item_is_used() {
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
        let unused = code.lines().filter_map(public_item).filter(|name| count[name] == 1);
        dead.extend(unused.map(|name| format!("{}: {name}", path.display())));
    }
    assert!(dead.is_empty(), "nobody uses:\n{}", dead.join("\n"));
}
