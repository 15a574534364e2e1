//! The chapter that brings a kind.

use groundtruth::kinds::Entry;
use serde::Serialize;

/// The chapter of a shape with this tag.
pub fn shape(tag: &str) -> &'static str {
    of(groundtruth::shapes::Kind::ENTRIES, tag)
}

/// The chapter of the entry whose specimens are written with this tag.
pub fn of<Kind: Serialize>(entries: &[Entry<Kind>], tag: &str) -> &'static str {
    let has_tag = |entry: &&Entry<Kind>| {
        let first = (entry.specimens)().into_iter().next();
        let data = first.and_then(|kind| serde_json::to_value(kind).ok());
        data.is_some_and(|data| data.get(tag).is_some())
    };
    entries.iter().find(has_tag).map_or("ch03", |entry| entry.chapter)
}
