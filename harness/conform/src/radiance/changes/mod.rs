//! Mistakes that are another scene, or another pixel: what our tracer answers to it is what they would.

mod lights;
mod surfaces;
mod views;

use judge::mistakes::fields::{
    Fields, any, bases, instead, is_ambient, is_lamp, items, keep_lamps, lights, number, of_kinds,
    recipes, set, steps, tables, without,
};
use serde_json::Value;

use super::super::mistakes::Mistake;

/// A mistake, and what it makes of the data of a `radiance`.
#[derive(Debug)]
pub struct SceneMistake {
    /// The mistake.
    pub mistake: &'static Mistake,
    /// `None` if there is nothing to change.
    pub apply: fn(&mut Value) -> Option<()>,
}

/// All of them.
pub fn all() -> impl Iterator<Item = &'static SceneMistake> {
    [lights::KNOWN, lights::ALL, surfaces::ALL, surfaces::KNOWN, views::ALL, views::KNOWN]
        .into_iter()
        .flatten()
}

/// A list of changes: words, place in the book, change.
macro_rules! changes {
    ($($words:literal, $place:literal => $apply:expr;)*) => {
        &[$(SceneMistake {
            mistake: &Mistake::of_answers($words, $place, None),
            apply: $apply,
        }),*]
    };
}
use changes;
