//! The adapter that is wrong on purpose.

use serde_json::Value;

use super::{ANSWERED, text_of_example};
use crate::kit::{Folder, has};

/// The mistakes of `wrong.py`.
fn planted() -> Vec<[&'static str; 4]> {
    let rows = include_str!("planted.csv").lines().skip(1);
    rows.map(|row| {
        let cells: Vec<&str> = row.split(';').collect();
        cells.try_into().expect("four columns")
    })
    .collect()
}

/// Law: each mistake fails its families and no other, and is named where the answers give it away; the exit status
/// is 1. Oracle: the comments that mark the mistakes.
#[test]
fn each_mistake_of_the_wrong_adapter_is_found() {
    let wrong = text_of_example("wrong.py");
    let comments: Vec<&str> =
        wrong.lines().filter_map(|line| Some(line.split_once("# mistake: ")?.1)).collect();
    let mut expected: Vec<&str> = planted().iter().map(|row| row[0]).collect();
    let mut found = comments.clone();
    expected.sort_unstable();
    found.sort_unstable();
    assert_eq!(found, expected);
    if !has("python3") {
        return;
    }
    let program = "python3 $ROOT/examples/conform/wrong.py";
    let words = ANSWERED.join(" ");
    let run =
        Folder::new().run(&format!("groundtruth conform --json --cases 16 {words} -- {program}"));
    let card = run.expect(1, &[]).json();
    let families = card["families"].as_array().expect("a list");
    let failed: Vec<&Value> = families.iter().filter(|row| row["counts"]["wrong"] != 0).collect();
    let is = |row: &Value, name: &str| row["family"] == name;
    for row in &failed {
        let name = row["family"].as_str().expect("a name");
        let is_meant = |row: &[&str; 4]| row[1].split(' ').any(|it| name.starts_with(it));
        assert!(planted().iter().any(is_meant), "{name} fails, and no mistake spoils it: {row}");
    }
    for [comment, _, surely, name] in planted() {
        let row = failed.iter().find(|row| is(row, surely));
        let row = row.unwrap_or_else(|| panic!("{surely} does not fail: {comment}"));
        let names: Vec<&str> = row["names"]
            .as_array()
            .into_iter()
            .flatten()
            .filter_map(|name| name.as_str()?.split(" (").next())
            .collect();
        assert!(name.is_empty() || names.contains(&name), "{surely}: {comment}: {names:?}");
    }
}
