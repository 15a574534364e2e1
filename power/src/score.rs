//! What was found, counted.

use std::collections::BTreeMap;
use std::fmt::Write;

use serde::{Deserialize, Serialize};
use statrs::distribution::{Beta, ContinuousCDF};

/// Where a change comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Kind {
    /// A planted mistake.
    Planted,
    /// Planted, but it means the same, so that nothing should find it.
    Decoy,
    /// One that cargo-mutants lists.
    Mutant,
}

/// What became of one change.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Row {
    /// The change.
    pub name: String,
    /// The package that it is in: the folder of its `src`.
    pub package: String,
    /// Where it comes from.
    pub kind: Kind,
    /// How many tests reach it.
    pub reached: usize,
    /// The law that found it first.
    pub law: Option<String>,
    /// Whether that is the law that was expected to; none where none was named.
    pub expected: Option<bool>,
    /// If no law did: the golden or text that found it.
    pub text: Option<String>,
    /// What that test said first.
    pub message: Option<String>,
    /// Whether tests are left that were not tried.
    #[serde(default)]
    pub given_up: bool,
}

/// The package of a file: what is above `src`, or the first folder of the tracer in it.
pub fn package(file: &str) -> String {
    match file.split_once("src/") {
        Some(("", rest)) => format!("tracer, {}", rest.split(['/', '.']).next().unwrap_or("")),
        Some((folder, _)) => folder.trim_end_matches('/').to_owned(),
        None => file.rsplit_once('/').map_or("", |(folder, _)| folder).to_owned(),
    }
}

/// The interval of a share after Clopper and Pearson (1934), at 95 %.
fn interval(found: usize, of: usize) -> (f64, f64) {
    let quantile = |a: usize, b: usize, p: f64| {
        Beta::new(a as f64, b as f64).map_or(p, |it| it.inverse_cdf(p))
    };
    let low = if found == 0 { 0.0 } else { quantile(found, of - found + 1, 0.025) };
    let high = if found == of { 1.0 } else { quantile(found + 1, of - found, 0.975) };
    (low, high)
}

#[derive(Default)]
struct Counts {
    all: usize,
    laws: usize,
    texts: usize,
}

/// Both tables, of planted mistakes and of mutants; then the decoys that failed a test.
pub fn tables(rows: &[Row]) -> String {
    let mut out = String::new();
    for (kind, title) in [(Kind::Planted, "Planted mistakes"), (Kind::Mutant, "Mutants")] {
        let rows: Vec<&Row> = rows.iter().filter(|it| it.kind == kind).collect();
        if !rows.is_empty() {
            let _ = writeln!(out, "{title}\n\n{}", table(&rows));
        }
    }
    let decoys: Vec<&Row> = rows.iter().filter(|it| it.kind == Kind::Decoy).collect();
    let failed: Vec<&&Row> =
        decoys.iter().filter(|it| it.law.is_some() || it.text.is_some()).collect();
    let _ = writeln!(out, "Decoys: {}, of which {} failed a test.", decoys.len(), failed.len());
    for row in failed {
        let by = row.law.as_ref().or(row.text.as_ref()).map_or("", String::as_str);
        let _ = writeln!(out, "- {}: `{by}`", row.name);
    }
    out
}

/// A row a package, tracer and harness summed; then what nothing or only a text found.
fn table(rows: &[&Row]) -> String {
    let mut counts: BTreeMap<&str, Counts> = BTreeMap::new();
    for row in rows {
        let sum = if row.package.starts_with("tracer") { "**tracer**" } else { "**harness**" };
        for key in [row.package.as_str(), sum, "**together**"] {
            let counts = counts.entry(key).or_default();
            counts.all += 1;
            counts.laws += usize::from(row.law.is_some());
            counts.texts += usize::from(row.text.is_some());
        }
    }
    let mut out = String::from(
        "| where | mistakes | found by laws | 95 % interval | by a text or golden alone | by nothing |\n\
         | --- | --- | --- | --- | --- | --- |\n",
    );
    for (key, it) in &counts {
        let (low, high) = interval(it.laws, it.all);
        let [share, low, high] = [it.laws as f64 / it.all as f64, low, high].map(|it| 100.0 * it);
        let Counts { all, laws, texts } = it;
        let missed = all - laws - texts;
        let _ = writeln!(
            out,
            "| {key} | {all} | {laws} ({share:.0} %) | {low:.0} to {high:.0} % | {texts} | {missed} |"
        );
    }
    let expected: Vec<bool> = rows.iter().filter_map(|it| it.expected).collect();
    if !expected.is_empty() {
        let hit = expected.iter().filter(|it| **it).count();
        let _ = writeln!(out, "\nThe law that was expected found {hit} of {}.", expected.len());
    }
    let said = rows.iter().filter(|it| it.law.is_some()).filter_map(|it| it.message.as_deref());
    let (all, full) =
        said.fold((0, 0), |(all, full), it| (all + 1, full + usize::from(says_all(it))));
    let _ = writeln!(
        out,
        "\nOf {all} first messages of laws {full} say what was found and what was expected."
    );
    let _ = writeln!(out, "\nNot found by a law:\n");
    for row in rows.iter().filter(|it| it.law.is_none()) {
        let by = row.text.as_ref().map(|it| format!("`{it}` alone"));
        let by = by.unwrap_or_else(|| if row.given_up { "given up" } else { "nothing" }.to_owned());
        let _ = writeln!(out, "- {}: {by}, of {} tests that reach it", row.name, row.reached);
    }
    out
}

/// Whether a message has both sides: found and expected, or left and right with a name before them.
fn says_all(message: &str) -> bool {
    let message = message.to_lowercase();
    let named = |side: &str| message.contains(side);
    (named("expected") && (named("found") || named(" is ") || named(" has ") || named(" was ")))
        || (named("left:") && !message.starts_with("assertion `left == right` failed\n"))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Law: to show 90 % takes 281 of 300; none of 10 may be up to 30.8 %, all of 10 at least 69.2 %. Oracle: published
    /// tables of the exact binomial interval.
    #[test]
    fn the_interval_is_the_exact_one() {
        let low = |found| interval(found, 300).0;
        assert!(
            low(281) >= 0.9 && low(280) < 0.9,
            "found {} and {}, expected 0.9 between",
            low(281),
            low(280)
        );
        for (found, expected) in [(0, (0.0, 0.308)), (10, (0.692, 1.0))] {
            let (low, high) = interval(found, 10);
            assert!(
                (low - expected.0).abs() < 6e-4 && (high - expected.1).abs() < 6e-4,
                "found {low} to {high}, expected {expected:?}"
            );
        }
    }
}
