//! Failures that are accepted: a file of families, one a line.

use std::collections::BTreeSet;
use std::fmt;
use std::path::{Path, PathBuf};

use scenefile::STANDARD_INPUT;

use super::card::Card;

/// The names of families that may fail.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct KnownFailures(BTreeSet<String>);

/// Why a file of known failures cannot be used.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum KnownError {
    /// It cannot be read.
    #[error("{}: {source}", path.display())]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// Why.
        source: std::io::Error,
    },
    /// A line that is no family's name.
    #[error("{}:{line}: no family `{name}`; the card shows their names", path.display())]
    Unknown {
        /// The file.
        path: PathBuf,
        /// From 1.
        line: usize,
        /// What stands there.
        name: String,
    },
}

impl KnownFailures {
    /// Reads names, one a line, from a file or, if its path is `-`, the standard input; `#` begins a comment.
    ///
    /// # Errors
    /// [`KnownError`] with file and line.
    pub fn read(path: &Path) -> Result<Self, KnownError> {
        let unreadable = |source| KnownError::Unreadable { path: path.to_owned(), source };
        let text = match path == Path::new(STANDARD_INPUT) {
            true => std::io::read_to_string(std::io::stdin().lock()),
            false => std::fs::read_to_string(path),
        };
        let text = text.map_err(unreadable)?;
        let families = super::suite::all();
        let mut names = BTreeSet::new();
        for (index, line) in text.lines().enumerate() {
            let name = line.split('#').next().unwrap_or_default().trim();
            if name.is_empty() {
                continue;
            }
            if !families.iter().any(|family| family.name == name) {
                let (path, name) = (path.to_owned(), name.to_owned());
                return Err(KnownError::Unknown { path, line: index + 1, name });
            }
            names.insert(name.to_owned());
        }
        Ok(Self(names))
    }

    /// What failed.
    pub fn of(card: &Card) -> Self {
        Self(card.rows.iter().filter(|row| row.is_failed()).map(|row| row.name.clone()).collect())
    }

    /// The families that failed and are not known to; and those known to fail that were asked and did not.
    pub fn compare(&self, card: &Card) -> (Vec<String>, Vec<String>) {
        let Self(failed) = Self::of(card);
        let new = failed.difference(&self.0).cloned().collect();
        let asked = card.rows.iter().filter(|row| row.total() > 0).map(|row| &row.name);
        let passed = asked.filter(|name| self.0.contains(*name) && !failed.contains(*name));
        (new, passed.cloned().collect())
    }
}

impl fmt::Display for KnownFailures {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.iter().try_for_each(|name| writeln!(f, "{name}"))
    }
}
