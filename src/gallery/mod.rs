//! The gallery: the book's scenes with the book's numbers, as functions that return a [`Scene`].
//!
//! Each chapter's file holds its scenes and their list; [`SCENES`] is all of them in order.

mod ch03;
mod ch14;
mod ch16;
mod ch20;
mod ch23;
mod ch24;
mod ch27;
mod ch28;

// shared by the chapters
mod parts;

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
        ch14::SCENES,
        ch16::SCENES,
        ch20::SCENES,
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

/// What a chapter's file lists: names and build functions.
type List = &'static [(&'static str, fn() -> Scene)];
