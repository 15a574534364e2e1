//! How many lines each package may have: a budget that only ever falls.

use super::{read, root, rust_files};

/// For each folder, its lines of Rust.
const BUDGETS: &str = include_str!("budget.csv");

/// A budget is at most so much above what is there, so that what a cut has saved is not spent again.
const ROOM: usize = 60;

/// Law: no folder has more lines than its budget, and no budget has room for many more than there are. Oracle: the files. A
/// commit may lower a number and never raise it, but for what was asked to be added.
#[test]
fn packages_keep_to_their_budgets() {
    let mut wrong = Vec::new();
    for line in BUDGETS.lines().skip(1) {
        let (folder, budget) = line.split_once(',').expect("two columns");
        let budget: usize = budget.parse().expect("a number");
        let files = rust_files(&root().join(folder));
        let count: usize = files.iter().map(|file| read(file).lines().count()).sum();
        if count > budget || count + ROOM < budget {
            wrong.push(format!("{folder} has {count} lines, its budget is {budget}"));
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// Law: no doc line of the tracer has more than 100 columns; the formatter does not wrap them. Oracle: the files.
#[test]
fn doc_lines_of_the_tracer_fit_100_columns() {
    let mut wide = Vec::new();
    for file in rust_files(&root().join("src")) {
        let text = read(&file);
        let is_doc =
            |line: &&str| ["///", "//!"].contains(&line.trim_start().get(..3).unwrap_or(""));
        let docs = text.lines().filter(is_doc);
        wide.extend(docs.filter(|line| line.chars().count() > 100).map(str::to_owned));
    }
    assert!(wide.is_empty(), "{wide:#?}");
}
