//! The errors of reading, building and writing scenes.

use std::fmt;
use std::path::{Path, PathBuf};

use groundtruth::invalid::Invalid;
use groundtruth::printable;

/// A scene that cannot be read, built or written.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum SceneError {
    /// The file cannot be read.
    #[error("{}: cannot be read: {source}", shown(path))]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// The error of the file system.
        source: std::io::Error,
    },
    /// An invalid value, an unknown key, or a text that is not TOML.
    #[error("{location}{invalid}")]
    Invalid {
        /// File and line, if the scene was read from a file.
        location: Location,
        /// Object, field, what was found and what would be valid.
        invalid: Invalid,
    },
    /// A scene with a part of a custom kind: it cannot be written to a file.
    #[error("{invalid}")]
    NotPlain {
        /// The part that cannot be written.
        invalid: Invalid,
    },
}

/// A file, or a line of it, printed as `scene.toml:12: `; nothing for a scene built in code.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Location(Option<(PathBuf, Option<usize>)>);

impl Location {
    /// Whether the scene was built in code.
    pub fn is_unknown(&self) -> bool {
        self.0.is_none()
    }

    pub(crate) fn file(path: &Path) -> Self {
        Self(Some((path.to_owned(), None)))
    }

    pub(crate) fn line(path: &Path, line: usize) -> Self {
        Self(Some((path.to_owned(), Some(line))))
    }
}

/// A path without characters that a terminal obeys.
fn shown(path: &Path) -> String {
    printable::text(&path.display().to_string())
}

impl fmt::Display for Location {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.0 {
            Some((path, None)) => write!(f, "{}: ", shown(path)),
            Some((path, Some(line))) => write!(f, "{}:{line}: ", shown(path)),
            None => Ok(()),
        }
    }
}

impl From<Invalid> for SceneError {
    fn from(invalid: Invalid) -> Self {
        Self::Invalid { location: Location::default(), invalid }
    }
}
