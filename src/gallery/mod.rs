//! The gallery: the book's scenes with the book's numbers, as functions that return a [`Scene`].
//!
//! Each chapter's file holds its scenes and their list; [`scenes`] is all of them in order.

mod ch03;
mod ch04;
mod ch06;
mod ch08;
mod ch09;
mod ch10;
mod ch11;
mod ch12;
mod ch14;
mod ch16;
mod ch19;
mod ch20;
mod ch21;
mod ch22;
mod ch23;
mod ch24;
mod ch27;
mod ch28;

// shared by the chapters
mod parts;
mod sets;

use crate::scene::Scene;

/// A scene by its name, `chNN/some-scene`.
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    /// As typed on the command line.
    pub name: &'static str,
    /// Builds it.
    pub build: fn() -> Scene,
}

/// Every scene, by chapter.
pub fn scenes() -> impl Iterator<Item = Entry> {
    [
        ch03::SCENES,
        ch04::SCENES,
        ch06::SCENES,
        ch08::SCENES,
        ch09::SCENES,
        ch10::SCENES,
        ch11::SCENES,
        ch12::SCENES,
        ch14::SCENES,
        ch16::SCENES,
        ch19::SCENES,
        ch20::SCENES,
        ch21::SCENES,
        ch22::SCENES,
        ch23::SCENES,
        ch24::SCENES,
        ch27::SCENES,
        ch28::SCENES,
    ]
    .into_iter()
    .flatten()
    .map(|&(name, build)| Entry { name, build })
}

/// The scene of this name.
pub fn find(name: &str) -> Option<Entry> {
    scenes().find(|entry| entry.name == name)
}

/// What to say of a name that is neither a scene's nor a file's.
pub fn unknown(name: &str) -> String {
    let problem = format!(
        "no scene `{name}`: neither a gallery name (`groundtruth list` shows them) nor a file"
    );
    let closest = scenes().map(|entry| (edits(name, entry.name), entry.name)).min();
    match closest {
        Some((edits, known)) if edits <= name.len() / 3 => {
            format!("{problem}; did you mean `{known}`?")
        }
        _ => problem,
    }
}

/// How many bytes must be put in, left out or changed to make `a` into `b` (Levenshtein 1965).
fn edits(a: &str, b: &str) -> usize {
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, byte) in a.bytes().take(100).enumerate() {
        let mut diagonal = std::mem::replace(&mut row[0], i + 1);
        for (j, other) in b.bytes().enumerate() {
            let change = diagonal + usize::from(byte != other);
            diagonal = row[j + 1];
            row[j + 1] = change.min(row[j] + 1).min(diagonal + 1);
        }
    }
    row[b.len()]
}

/// What a chapter's file lists: names and build functions.
type List = &'static [(&'static str, fn() -> Scene)];
