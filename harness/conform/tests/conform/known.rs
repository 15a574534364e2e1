//! Failures that are known, beside a card.

use std::collections::BTreeSet;

use conform::{KnownFailures, suite};

use super::cards::{Outcome, Plan, card};

/// Law: with a list of known failures, those that fail beside it are new, and those on it that were asked and did not fail have
/// passed (docs/conform.md). Oracle: membership, for all lists of four families.
#[test]
fn known_failures_are_compared_one_by_one() {
    let names: Vec<String> = suite::all().iter().take(4).map(|it| it.name.clone()).collect();
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("known");
    let has = |set: usize, i: usize| set >> i & 1 == 1;
    let known: Vec<KnownFailures> = (0..16)
        .map(|listed| {
            let lines =
                (0..4).filter(|i| has(listed, *i)).map(|i| format!("{} # known\n", names[i]));
            std::fs::write(&path, lines.collect::<String>()).expect("it is written");
            KnownFailures::read(&path).expect("families")
        })
        .collect();
    for failing in 0..16_usize {
        let plans: Vec<Plan> = (0..4)
            .map(|i| {
                let outcome = if has(failing, i) { Outcome::Wrong } else { Outcome::Right };
                // the last one has no cases, and is not asked
                let outcomes = if i == 3 { Vec::new() } else { vec![(outcome, 200.0)] };
                Plan { name: names[i].clone(), chapter: "ch03", outcomes }
            })
            .collect();
        let card = card(&plans).expect("it answers");
        let failed = |i: usize| i < 3 && has(failing, i);
        let written: BTreeSet<String> =
            KnownFailures::of(&card).to_string().lines().map(str::to_owned).collect();
        let expected: BTreeSet<String> =
            (0..4).filter(|i| failed(*i)).map(|i| names[i].clone()).collect();
        assert_eq!(written, expected, "what failed, as a list");
        for (listed, known) in known.iter().enumerate() {
            let all = |is: &dyn Fn(usize) -> bool| -> Vec<String> {
                (0..4).filter(|i| is(*i)).map(|i| names[i].clone()).collect()
            };
            // new ones by name, as they are written; passed ones in the order of the card
            let mut new = all(&|i| failed(i) && !has(listed, i));
            new.sort();
            let passed = all(&|i| i < 3 && !failed(i) && has(listed, i));
            let found = known.compare(&card);
            assert_eq!(
                found,
                (new, passed),
                "new and passed: {failing:04b} fail, {listed:04b} listed"
            );
        }
    }
}
