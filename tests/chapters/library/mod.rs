//! Laws of the library that belong to no single chapter: files that it reads, ray trees, paths of hits, regressions.

mod exact;
mod explain;
mod files;
mod hit_path;
mod image_file;
mod mesh_file;
mod regressions;
mod scene_files;
mod similar;

use std::collections::BTreeMap;

/// Compares the errors of a table: heads, what follows a head or stands in its place, and the error; `…` ends one that goes
/// on.
pub fn check_refused(table: &str, error_of: impl Fn(&str, &str) -> String) {
    let table: BTreeMap<String, BTreeMap<String, String>> = toml::from_str(table).expect("a table");
    let mut wrong = Vec::new();
    for (head, by, expected) in
        table.iter().flat_map(|(head, rows)| rows.iter().map(move |(by, it)| (head, by, it)))
    {
        let found = error_of(head, by);
        let is_right = match expected.strip_suffix('…') {
            Some(start) => found.starts_with(start),
            None => found == *expected,
        };
        if !is_right {
            wrong.push(format!("{head} -> {by}\n   found {found}\nexpected {expected}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
