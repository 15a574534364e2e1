//! The planted mistakes of the repository: one table a file in `power/planted`, each an expression that is written wrongly.

use std::path::Path;

use anyhow::{Context, Result, ensure};
use serde::Deserialize;

use crate::change::{Change, How};

/// A mistake that a competent developer makes, or a decoy: other code that means the same.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Planted {
    /// A name that begins with its chapter or package, as `ch03-far-root`.
    pub name: String,
    /// The file, from the root of the repository.
    pub file: String,
    /// Text of the file that occurs once and holds `ours`; `ours` itself where this is not said.
    pub at: Option<String>,
    /// The expression (or statements without `let`) that is there, once within `at`.
    pub ours: String,
    /// What stands there while the mistake is planted.
    pub theirs: String,
    /// What the mistake is, or why the decoy is none.
    pub meaning: String,
    /// The law that is expected to find it, as a part of its name, with its program: `chapters ch03::spheres`. None for a decoy.
    pub law: Option<String>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Table {
    planted: Vec<Planted>,
}

/// All planted mistakes and decoys, in the order of the names of their files.
///
/// # Errors
/// A table that cannot be read; a name that occurs twice.
pub fn read(folder: &Path) -> Result<Vec<Planted>> {
    let mut files: Vec<_> =
        std::fs::read_dir(folder)?.map(|entry| Ok(entry?.path())).collect::<Result<_>>()?;
    files.retain(|path| path.extension().is_some_and(|it| it == "toml"));
    files.sort();
    let mut all: Vec<Planted> = Vec::new();
    for file in files {
        let text = std::fs::read_to_string(&file)?;
        let table: Table = toml::from_str(&text).with_context(|| format!("{}", file.display()))?;
        for planted in table.planted {
            ensure!(
                all.iter().all(|it| it.name != planted.name),
                "{}: {} occurs twice",
                file.display(),
                planted.name
            );
            all.push(planted);
        }
    }
    Ok(all)
}

impl Planted {
    /// Where the change is in the tree at `root`.
    ///
    /// # Errors
    /// A text that is not there, or that occurs twice.
    pub fn change(&self, root: &Path) -> Result<Change> {
        let path = root.join(&self.file);
        let text = std::fs::read_to_string(&path)
            .with_context(|| format!("{}: {}", self.name, self.file))?;
        let at = self.at.as_ref().unwrap_or(&self.ours);
        let begin =
            once(&text, at).with_context(|| format!("{}: `at` in {}", self.name, self.file))?;
        let start = begin
            + once(at, &self.ours).with_context(|| format!("{}: `ours` within `at`", self.name))?;
        let span = start..start + self.ours.len();
        let how = How::Expression(self.theirs.clone());
        Ok(Change { name: self.name.clone(), file: self.file.clone(), span, how })
    }
}

impl Planted {
    /// Whether the change can be written, and reads as Rust.
    ///
    /// # Errors
    /// What does not fit.
    pub fn check(&self, root: &Path) -> Result<()> {
        let change = self.change(root)?;
        let text = std::fs::read_to_string(root.join(&self.file))?;
        let theirs =
            format!("{}{}{}", &text[..change.span.start], self.theirs, &text[change.span.end..]);
        syn::parse_file(&theirs)
            .with_context(|| format!("{}: `theirs` is no Rust there", self.name))?;
        let text = change.switched(&text);
        syn::parse_file(&text).with_context(|| {
            format!("{}: no switch can stand there; name a whole expression", self.name)
        })?;
        ensure!(!self.meaning.is_empty(), "{}: no meaning", self.name);
        Ok(())
    }
}

fn once(text: &str, part: &str) -> Result<usize> {
    let found: Vec<usize> = text.match_indices(part).map(|(at, _)| at).collect();
    ensure!(found.len() == 1, "the text occurs {} times instead of once: {part}", found.len());
    Ok(found[0])
}
