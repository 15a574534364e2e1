//! A small program of somebody else, `tests/small.py`: what chapters 14 to 16 bring is asked of it, and its mistakes are named
//! rightly or not at all.

use ask::{Limits, Program};
use std::sync::Arc;
use std::time::Duration;

use conform::{Card, Profile, Status, card};
use rayon::prelude::*;
use testkit::as_many;

use super::altered::card_with;

fn run(arguments: &[&str], words: &[&str], cases: usize) -> Option<Card> {
    let script = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/small.py");
    let python = std::process::Command::new("python3").arg("--version").output();
    if !python.is_ok_and(|it| it.status.success()) {
        eprintln!("without python3, nothing is tested");
        return None;
    }
    let command = ["python3", script].iter().chain(arguments).map(|it| (*it).to_owned()).collect();
    let limits = Limits { answer: Duration::from_secs(60), start: Duration::from_secs(60) };
    let mut program = Program::new(command, limits, Arc::default());
    Some(card_with(&mut program, words, Profile::Careful, cases, false))
}

/// Law: each of chapters 14 to 16 has families of scenes that a tracer with spheres, planes, matte and Phong surfaces, point and
/// directional lights can answer to their end. Oracle: a program that has only these, and no mistake.
#[test]
fn chapters_14_to_16_ask_what_a_tracer_of_these_chapters_has() {
    let Some(card) = run(&[], &["scenes", "materials"], 48) else { return };
    for chapter in ["ch14", "ch15", "ch16"] {
        let rows = card.rows.iter().filter(|row| row.chapter == chapter);
        let whole = rows.filter(|row| row.count(Status::Pass) == row.cases).count();
        assert!(whole >= 2, "{chapter}: {whole} families\n{card}");
    }
    assert!(!card.is_failed(), "{card}");
}

/// Law: where nothing can be judged, the card says why in the program's words, each with its number. Oracle: the same program,
/// asked for mirrors.
#[test]
fn nothing_to_judge_has_reasons() {
    let Some(card) = run(&[], &["scenes/mirror"], 48) else { return };
    let said = card::verdict(&card, false);
    assert!(
        said.starts_with("nothing to judge: all 5 families are unsupported; the program says: ")
    );
    assert!(said.contains("\"tracer `whitted`\" (40)"), "{said}");
}

/// Mistakes of the program, each with words of the names that are right for it; without words, it has no name.
const MISTAKES: &str = include_str!("../small.txt");

/// Law: of the names that stand on the cards of this program with mistakes, nine of ten are right, and at least half of the
/// mistakes that are found have a right one. Oracle: the mistakes, planted in a program that shares nothing with ours.
#[test]
fn names_of_a_foreign_program_are_right() {
    let (mut found, mut named, mut right, mut all) = (0, 0, 0, 0);
    let mut wrong = Vec::new();
    let run = |(mistake, _): &(&str, &str)| run(&[*mistake], &["scenes/basics"], 24);
    let lines = MISTAKES.lines().step_by(as_many(2, 1));
    let some: Vec<_> = lines.map(|line| line.split_once(": ").unwrap_or((line, ""))).collect();
    let cards: Vec<Option<Card>> = some.par_iter().map(run).collect();
    for ((mistake, words), card) in some.into_iter().zip(cards) {
        let Some(card) = card else { return };
        let names = card.rows.iter().flat_map(|row| row.names.iter().map(ToString::to_string));
        let names: Vec<String> = names.collect();
        let words: Vec<&str> = words.split(" | ").filter(|word| !word.is_empty()).collect();
        let is_right = |name: &&String| words.iter().any(|word| name.contains(word));
        let of_these = names.iter().filter(is_right).count();
        found += usize::from(card.is_failed());
        named += usize::from(of_these > 0);
        (right, all) = (right + of_these, all + names.len());
        let others = names.iter().filter(|name| !is_right(name));
        wrong.extend(others.map(|name| format!("{mistake}: {name}")));
        if of_these == 0 && !words.is_empty() {
            wrong.push(format!("{mistake}: found {}, not named", card.is_failed()));
        }
    }
    let summary = format!("{named} of {found} named, {right} of {all} right\n{}", wrong.join("\n"));
    eprintln!("{summary}");
    assert!(found >= as_many(12, 25), "{summary}");
    assert!(100 * right >= 90 * all && 2 * named >= found, "{summary}");
}
