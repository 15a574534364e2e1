//! The mistakes that people make in ray tracers: what is done wrong, and where the book has it right.
//!
//! One list for pictures and for answers, the file `mistakes.toml`, which says how it is read: `verify` and `mistakes`
//! render pictures of those in its part `pictures`, and `conform` names all of them.

use std::collections::BTreeMap;
use std::sync::LazyLock;

use serde_json::Value;
use toml::Spanned;

use super::edit::{Edit, apply};

const FILE: &str = include_str!("../../mistakes.toml");

/// A mistake: an entry of the file.
#[derive(Debug, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct KnownMistake {
    /// Its name, in lower case with hyphens.
    #[serde(skip)]
    pub name: &'static str,
    /// The chapter of the book that has the right rule; 0 for those that only answers tell.
    #[serde(default)]
    pub chapter: u32,
    /// Completes the sentence "the picture agrees with ours if …".
    pub words: &'static str,
    /// Where the book has it right, or what to read.
    pub place: &'static str,
    /// What wrong answers tell of it, where that is other than the words.
    pub clue: Option<&'static str>,
    /// A scene of the gallery in whose picture it shows, of those that only answers tell.
    pub scene: Option<&'static str>,
    /// How much it says.
    #[serde(default)]
    pub says: Says,
    /// What it makes of a scene, or of a question with a scene. Where the mistake has code, too, its picture is made by that,
    /// and the change is another way to make it, which only answers tell.
    #[serde(default)]
    pub change: Vec<Edit>,
    /// What it makes of a question that has no scene, and of our answer to it, which is then the question's field `answer`: a list
    /// of edits for each way to make it.
    #[serde(default)]
    pub asked: Vec<Vec<Edit>>,
    /// Whether `verify` also tries the change in one material alone.
    #[serde(default)]
    pub in_one_material: bool,
    /// Other forms in which people make it.
    #[serde(default)]
    pub forms: Vec<Form>,
}

/// Another form of a mistake.
#[derive(Debug, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Form {
    /// A half sentence that follows the words.
    pub words: &'static str,
    /// What it makes of a scene.
    pub change: Vec<Edit>,
}

/// How much a mistake says, the most first.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, serde::Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Says {
    /// What was done.
    #[default]
    Deed,
    /// How the components of an answer differ.
    Components,
    /// How its numbers differ.
    Numbers,
}

impl KnownMistake {
    /// Makes the mistake in a question with a scene; `None` if there is nothing to change.
    pub fn change(&self, data: &mut Value) -> Option<()> {
        apply(&self.change, data)
    }

    /// A question that has no scene, with our answer as its field `answer`, as the change and each other way to make the mistake
    /// make it; `None` where there is nothing to change.
    pub fn ways(&self, data: &Value) -> Vec<Option<Value>> {
        let way = |edits: &Vec<Edit>| {
            // no edits change nothing: no question is copied for them
            let mut changed = (!edits.is_empty()).then(|| data.clone())?;
            apply(edits, &mut changed).map(|()| changed)
        };
        std::iter::once(&self.change).chain(&self.asked).map(way).collect()
    }
}

/// The parts of the file, and their entries by name.
#[derive(serde::Deserialize)]
#[serde(deny_unknown_fields)]
struct Parts<T> {
    pictures: T,
    answers: T,
}

static PARTS: LazyLock<Parts<Vec<KnownMistake>>> = LazyLock::new(|| {
    type Entries = BTreeMap<&'static str, Spanned<KnownMistake>>;
    let in_order = |entries: Entries| {
        let mut entries: Vec<_> = entries.into_iter().collect();
        entries.sort_by_key(|(_, entry)| entry.span().start);
        let named = |(name, entry): (_, Spanned<_>)| KnownMistake { name, ..entry.into_inner() };
        entries.into_iter().map(named).collect()
    };
    let parts: Parts<Entries> =
        toml::from_str(FILE).unwrap_or_else(|e| panic!("mistakes.toml: {e}"));
    Parts { pictures: in_order(parts.pictures), answers: in_order(parts.answers) }
});

static BY_NAME: LazyLock<BTreeMap<&str, &KnownMistake>> =
    LazyLock::new(|| pictures().iter().chain(answers()).map(|known| (known.name, known)).collect());

/// Those of which a picture can be made, by chapter.
pub fn pictures() -> &'static [KnownMistake] {
    &PARTS.pictures
}

/// Those that only answers tell.
pub fn answers() -> &'static [KnownMistake] {
    &PARTS.answers
}

/// The mistake of this name.
pub fn find(name: &str) -> Option<&'static KnownMistake> {
    BY_NAME.get(name).copied()
}
