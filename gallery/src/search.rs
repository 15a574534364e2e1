//! Finding scenes by chapter, and by words of their names and descriptions, such as the book's figures.

use std::sync::LazyLock;

use super::{Entry, scenes};

/// Every scene with its description, built when it is first needed.
static DESCRIBED: LazyLock<Vec<(Entry, String)>> =
    LazyLock::new(|| scenes().map(|entry| (entry, (entry.build)().about)).collect());

/// The description of a scene, with the book's figure if it has one.
pub fn about(entry: Entry) -> &'static str {
    let found = DESCRIBED.iter().find(|(described, _)| described.name == entry.name);
    found.map_or("", |(_, about)| about)
}

/// The scenes that fit these words, by chapter; all if there are none.
///
/// `ch28` and `28` choose a chapter, several words several chapters. Every other word, such as `fresnel` or `26.12`, is
/// in the name or in the description, in small or capital letters; a number does not begin inside another.
pub fn search<'a>(words: impl IntoIterator<Item = &'a str>) -> Vec<Entry> {
    let words = words.into_iter().map(str::to_lowercase);
    let (chapters, words): (Vec<String>, Vec<String>) =
        words.partition(|word| chapter(word).is_some());
    let chapters: Vec<&str> = chapters.iter().filter_map(|word| chapter(word)).collect();
    let is_wanted =
        |entry: &Entry| chapters.is_empty() || chapters.contains(&chapter_of(entry.name));
    if words.is_empty() {
        return scenes().filter(is_wanted).collect();
    }
    let fits = |(entry, about): &&(Entry, String)| {
        let about = about.to_lowercase();
        is_wanted(entry) && words.iter().all(|word| has(entry.name, word) || has(&about, word))
    };
    DESCRIBED.iter().filter(fits).map(|(entry, _)| *entry).collect()
}

/// The scenes that fit the typed words, the likeliest first: those whose name begins with a word or has one that does, the
/// shortest name first; then those whose description does; last those that have it inside another word.
pub fn ranked(typed: &str) -> Vec<Entry> {
    let typed = typed.to_lowercase();
    let words = || typed.split_whitespace();
    let mut found = search(words());
    let rank = |entry: &Entry| -> usize {
        words().filter(|word| chapter(word).is_none()).map(|word| rank(*entry, word)).sum()
    };
    found.sort_by_cached_key(rank);
    found
}

/// How far from the first of a list a scene is for a word that it has.
fn rank(entry: Entry, word: &str) -> usize {
    let name = entry.name.split_once('/').map_or("", |(_, name)| name);
    let begins = |text: &str| {
        text.match_indices(word).any(|(at, _)| !text[..at].ends_with(char::is_alphanumeric))
    };
    match [name == word, begins(entry.name), begins(&about(entry).to_lowercase())] {
        [true, ..] => 0,
        [_, true, _] => name.len(),
        [_, _, true] => 1000,
        _ => 2000,
    }
}

/// The chapter `chNN` that has this name or number, if it has scenes.
fn chapter(word: &str) -> Option<&'static str> {
    let number: u32 = word.strip_prefix("ch").unwrap_or(word).parse().ok()?;
    let wanted = format!("ch{number:02}");
    scenes().map(|entry| chapter_of(entry.name)).find(|chapter| **chapter == wanted)
}

fn chapter_of(name: &'static str) -> &'static str {
    name.split_once('/').map_or("", |(chapter, _)| chapter)
}

/// Whether a text has a word; one that begins with a digit does not begin after another digit.
fn has(text: &str, word: &str) -> bool {
    let is_digit = |letter: Option<char>| letter.is_some_and(|letter| letter.is_ascii_digit());
    text.match_indices(word)
        .any(|(at, _)| !(is_digit(word.chars().next()) && is_digit(text[..at].chars().next_back())))
}
