//! Errors of golden images.

use std::path::PathBuf;

use groundtruth::film::ImageError;
use scenefile::SceneError;

/// Golden images that cannot be read, made or kept.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum GoldenError {
    /// A file cannot be read or written.
    #[error("{}: {source}", path.display())]
    File {
        /// The file.
        path: PathBuf,
        /// Why.
        source: std::io::Error,
    },
    /// The folder has no manifest.
    #[error("{}: there is none; run this where the folder `goldens` is, or name a folder by --folder DIR", path.display())]
    NoManifest {
        /// The manifest that would be there.
        path: PathBuf,
    },
    /// The manifest is invalid.
    #[error("{}: {problem}", path.display())]
    Manifest {
        /// The manifest.
        path: PathBuf,
        /// What is wrong with it.
        problem: String,
    },
    /// A picture cannot be read or written.
    #[error(transparent)]
    Image(#[from] ImageError),
    /// A scene cannot be read or built.
    #[error("{}{source}", unless_placed(name, source))]
    Scene {
        /// Its name.
        name: String,
        /// Why.
        source: Box<SceneError>,
    },
    /// There is no scene of the gallery and no scene file of this name.
    #[error(
        "no golden `{0}` can be made: the gallery has no such scene (`groundtruth list`), and a scene file ends in .toml"
    )]
    NoScene(String),
    /// Another scene file has the name of a golden already.
    #[error("golden `{name}` is of the file {}; rename one of the two", known.display())]
    OtherFile {
        /// The golden's name.
        name: String,
        /// Its scene file.
        known: PathBuf,
    },
    /// A golden is accepted without a reason.
    #[error("a golden is accepted with a reason: --because \"what it was checked against\"")]
    NoReason,
}

/// The golden's name before the error of its scene, unless that names its file itself.
fn unless_placed(name: &str, error: &SceneError) -> String {
    let has_file = match error {
        SceneError::Unreadable { .. } => true,
        SceneError::Invalid { location, .. } => !location.is_unknown(),
        _ => false,
    };
    if has_file { String::new() } else { format!("{name}: ") }
}
