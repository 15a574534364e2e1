//! All families: what `conform` asks.

use super::family::Family;
use super::{cases, intersections};
use groundtruth::similar::did_you_mean;

/// Every family, by chapter.
pub fn all() -> Vec<Family> {
    let mut all = intersections::families();
    all.extend(cases::families());
    all.sort_by_key(|family| family.chapter);
    all
}

/// The error text for a word that selects nothing.
pub fn unknown(word: &str, families: &[Family]) -> String {
    let hint = similar(word, families);
    format!("nothing is called `{word}`{hint} (chapters are ch03, ch04 …)")
}

/// `; did you mean …?` with words that select families and are like a mistyped one, the shortest first.
pub fn similar(word: &str, families: &[Family]) -> String {
    let words = families.iter().flat_map(|Family { chapter, about, name, .. }| {
        let beginnings = name.match_indices(['.', '_']).map(|(end, _)| &name[..end]);
        [*chapter, about, name].into_iter().chain(beginnings)
    });
    let mut known: Vec<&str> = words.collect();
    known.sort_by_key(|word| (word.len(), *word));
    known.dedup();
    did_you_mean(word, &known)
}
