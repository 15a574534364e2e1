//! What was found, counted.

use std::collections::BTreeMap;
use std::fmt::Write;

use serde::{Deserialize, Serialize};
use statrs::distribution::{Beta, ContinuousCDF};

/// What became of one change.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Row {
    /// The change.
    pub name: String,
    /// The package that it is in: the folder of its `src`.
    pub package: String,
    /// Whether it means the same, so that nothing should find it.
    pub decoy: bool,
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
    let quantile = |a: usize, b: usize, p: f64| Beta::new(a as f64, b as f64).map_or(p, |it| it.inverse_cdf(p));
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

/// The table: a row a package, tracer and harness summed; then what nothing or only a text found, and decoys that failed.
pub fn table(rows: &[Row]) -> String {
    let mut counts: BTreeMap<&str, Counts> = BTreeMap::new();
    let mistakes = rows.iter().filter(|it| !it.decoy);
    for row in mistakes.clone() {
        let sum = if row.package.starts_with("tracer") { "**tracer**" } else { "**all others**" };
        for key in [row.package.as_str(), sum, "**together**"] {
            let counts = counts.entry(key).or_default();
            counts.all += 1;
            counts.laws += usize::from(row.law.is_some());
            counts.texts += usize::from(row.text.is_some());
        }
    }
    let mut out = String::from(
        "| where | mistakes | found by laws | 95 % interval | by a text or golden alone | by nothing |\n| --- | --- | --- | --- | --- | --- |\n",
    );
    for (key, it) in &counts {
        let (low, high) = interval(it.laws, it.all);
        let share = 100.0 * it.laws as f64 / it.all as f64;
        let _ = writeln!(
            out,
            "| {key} | {} | {} ({share:.0} %) | {:.0} to {:.0} % | {} | {} |",
            it.all,
            it.laws,
            100.0 * low,
            100.0 * high,
            it.texts,
            it.all - it.laws - it.texts
        );
    }
    let expected = mistakes.clone().filter_map(|it| it.expected);
    let (named, hit) = expected.fold((0, 0), |(all, hit), it| (all + 1, hit + usize::from(it)));
    if named > 0 {
        let _ = writeln!(out, "\nThe law that was expected found {hit} of {named}.");
    }
    let said = mistakes.clone().filter(|it| it.law.is_some()).filter_map(|it| it.message.as_deref());
    let (all, full) = said.fold((0, 0), |(all, full), it| (all + 1, full + usize::from(says_all(it))));
    let _ = writeln!(out, "\nOf {all} first messages of laws {full} say what was found and what was expected.");
    let decoys: Vec<_> = rows.iter().filter(|it| it.decoy).collect();
    let failed: Vec<_> = decoys.iter().filter(|it| it.law.is_some() || it.text.is_some()).collect();
    let _ = writeln!(out, "\nDecoys: {}, of which {} failed a test.", decoys.len(), failed.len());
    for row in failed {
        let by = row.law.as_ref().or(row.text.as_ref()).map_or("", String::as_str);
        let _ = writeln!(out, "- decoy {}: `{by}`", row.name);
    }
    let _ = writeln!(out, "\nNot found by a law:\n");
    for row in mistakes.filter(|it| it.law.is_none()) {
        let by = row.text.as_ref().map_or_else(|| "nothing".to_owned(), |it| format!("`{it}` alone"));
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
