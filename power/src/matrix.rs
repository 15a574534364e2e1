//! The kill matrix: which tests find which change, and how few of them would find all.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;

use anyhow::Result;
use serde::{Deserialize, Serialize};

use crate::run::{End, Test};

/// All tests that find one change.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Kills {
    /// The change.
    pub change: String,
    /// The tests that fail while it is on.
    pub by: BTreeSet<String>,
    /// The tests that reach it and were not run, because there was no time.
    pub left: usize,
}

/// Runs every test that reaches change `number`, quick ones first, until they would have taken `budget` seconds.
///
/// # Errors
/// A program that cannot be started.
pub fn kills(change: &str, number: usize, tests: &[Test], budget: f64) -> Result<Kills> {
    let mut reaching: Vec<&Test> = tests.iter().filter(|it| it.reached.contains(&number)).collect();
    reaching.sort_by(|a, b| a.seconds.total_cmp(&b.seconds));
    let mut kills = Kills { change: change.to_owned(), by: BTreeSet::new(), left: reaching.len() };
    let mut seconds = 0.0;
    for test in reaching {
        seconds += test.seconds;
        if seconds > budget {
            break;
        }
        kills.left -= 1;
        if test.with(number)? != End::Passed {
            kills.by.insert(test.name.clone());
        }
    }
    Ok(kills)
}

/// A row a test, as CSV: its seconds, how many changes it reaches and finds, how many of them no other test finds, and
/// whether it is of the [`smallest`] set.
pub fn table(kills: &[Kills], tests: &[Test]) -> String {
    let smallest = smallest(kills, tests);
    let mut out = String::from("test,seconds,reached,found,alone,kept\n");
    for test in tests {
        let found: Vec<&Kills> = kills.iter().filter(|it| it.by.contains(&test.name)).collect();
        let alone = found.iter().filter(|it| it.by.len() == 1).count();
        let kept = if smallest.contains(test.name.as_str()) { "yes" } else { "" };
        let _ = writeln!(
            out,
            "{},{:.2},{},{},{alone},{kept}",
            test.name,
            test.seconds,
            test.reached.len(),
            found.len()
        );
    }
    out
}

/// Few tests that find all that any test finds: the test that finds most of what is left for its seconds, again and
/// again (Chvátal, 1979).
pub fn smallest<'a>(kills: &'a [Kills], tests: &[Test]) -> BTreeSet<&'a str> {
    let seconds: BTreeMap<&str, f64> =
        tests.iter().map(|it| (it.name.as_str(), it.seconds)).collect();
    let mut left: Vec<&BTreeSet<String>> = kills.iter().map(|it| &it.by).collect();
    left.retain(|by| !by.is_empty());
    let mut kept = BTreeSet::new();
    while !left.is_empty() {
        let mut finds: BTreeMap<&str, f64> = BTreeMap::new();
        for test in left.iter().copied().flatten() {
            *finds.entry(test).or_default() += 1.0;
        }
        // a process takes a hundredth of a second
        let worth = |test: &str, found: f64| found / (0.01 + seconds.get(test).unwrap_or(&0.0));
        let best = finds.into_iter().max_by(|a, b| worth(a.0, a.1).total_cmp(&worth(b.0, b.1)));
        let Some((best, _)) = best else { break };
        kept.insert(best);
        left.retain(|by| !by.contains(best));
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Law: the smallest set finds all, prefers quick tests, and leaves out what finds nothing new. Oracle: by hand.
    #[test]
    fn the_smallest_set_finds_all() {
        let tests = [("a", 1.0), ("b", 9.0), ("c", 1.0), ("d", 5.0)];
        let tests = tests.map(|(name, seconds)| Test::timed(name, seconds));
        let kills = ["a b", "c", "c", "", "c d"].map(|by| Kills {
            change: by.to_owned(),
            by: by.split_terminator(' ').map(str::to_owned).collect(),
            left: 0,
        });
        let kept: Vec<&str> = smallest(&kills, &tests).into_iter().collect();
        assert_eq!(kept, ["a", "c"]);
        let table = table(&kills, &tests);
        let rows: Vec<&str> = table.lines().skip(1).collect();
        assert_eq!(
            rows,
            ["a,1.00,0,1,0,yes", "b,9.00,0,1,0,", "c,1.00,0,3,2,yes", "d,5.00,0,1,0,"]
        );
    }
}
