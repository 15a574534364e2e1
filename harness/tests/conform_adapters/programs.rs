//! Adapters of programs that people use, and the document of their cards.

use serde_json::Value;

use super::document::blocks;
use crate::kit::{Folder, has, names_in, root, text_of};

/// The adapters of programs that people use.
fn of_programs() -> Vec<String> {
    let mut names = names_in(&root().join("examples/conform/programs"));
    names.retain(|name| name.starts_with("ask_"));
    names
}

/// Law: each adapter of a program is run by `scripts/cards.sh`, and named in the document of its card. Oracle: the
/// folder.
#[test]
fn the_programs_have_cards() {
    let [script, document] = ["scripts/cards.sh", "docs/cards.md"].map(text_of);
    let names = of_programs();
    assert_eq!(names.len(), 6, "{names:?}");
    for name in names {
        let short = name.split('.').next().expect("a name");
        assert!(script.contains(short), "scripts/cards.sh does not run {name}");
        let link = format!("](../examples/conform/programs/{name})");
        assert!(document.contains(&link), "docs/cards.md does not name {name}");
    }
}

/// Law: the adapter that reads a whole window gives each line one reply, under its id, and asks POV-Ray nothing
/// where it knows that there is no answer. Oracle: the protocol.
#[test]
fn the_adapter_of_povray_answers_a_whole_window() {
    if !has("python3") {
        return;
    }
    let ray = r#""ray": {"origin": [0, 0, 9], "direction": [0, 0, -1]}"#;
    let sphere = r#""shape": {"sphere": {"center": [0, 0, 0], "radius": 1}}"#;
    let lines = [
        r#"{"id": 1, "noise": {"point": [0, 0, 0]}}"#.to_owned(),
        format!(r#"{{"id": 2, "intersect": {{"shape": {{"rosette": {{}}}}, {ray}}}}}"#),
        format!(r#"{{"id": 3, "intersect": {{{sphere}, {ray}, "all": true}}}}"#),
    ];
    let folder = Folder::new();
    folder.write("lines", lines.join("\n") + "\n");
    let told = folder.good("python3 $ROOT/examples/conform/programs/ask_povray.py < lines");
    let replies: Vec<Value> =
        told.lines().map(|line| serde_json::from_str(line).expect("JSON")).collect();
    let whys = ["noise", "rosette", "scenes, lists of shapes, all hits, or a part of a ray"];
    assert_eq!(replies.len(), whys.len(), "{replies:?}");
    for (reply, (why, id)) in replies.iter().zip(whys.into_iter().zip(1..)) {
        assert_eq!((&reply["id"], &reply["unsupported"]), (&id.into(), &why.into()));
    }
}

/// Law: what docs/cards.md calls right is what we answer. Oracle: the probe, which the report's judges check.
#[test]
fn the_right_answers_in_the_document_of_cards_are_right() {
    let document = text_of("docs/cards.md");
    let mut count = 0;
    for (_, block) in blocks(&document).into_iter().filter(|(language, _)| *language == "text") {
        let line = |name: &str| block.lines().find_map(|line| line.trim().strip_prefix(name));
        let Some(asked) = line("asked") else { continue };
        let question: Value = serde_json::from_str(asked).expect("a question");
        let expected =
            line("expected").unwrap_or_else(|| panic!("{asked}: what is expected?")).trim();
        let ours = conform::ours(&question).expect("an answer");
        count += 1;
        if expected == "null" {
            assert!(ours.is_null(), "{asked}: {ours}");
            continue;
        }
        let (t, normal) = expected.split_once(", normal ").unwrap_or((expected, "null"));
        let t: f64 = t.strip_prefix("t = ").expect("a distance").parse().expect("a number");
        let found = ours["t"].as_f64().expect("a hit");
        assert!((found - t).abs() <= SAME * t.abs(), "{asked}: {found}");
        let normal: Value = serde_json::from_str(normal).expect("a list");
        for (i, x) in normal.as_array().into_iter().flatten().enumerate() {
            let off =
                (ours["normal"][i].as_f64().expect("a number") - x.as_f64().expect("one")).abs();
            assert!(off <= SAME, "{asked}: {ours}");
        }
    }
    assert!(count >= 6, "found only {count} questions: the search for them is broken");
}

/// Numbers of the document have at least this many digits in common with ours: cards print the exact ones, and our
/// answer is right to 100 u·cond.
const SAME: f64 = 1e-9;
