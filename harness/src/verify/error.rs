//! Errors of golden images.

use std::path::PathBuf;

use groundtruth::film::ImageError;
use groundtruth::scene::SceneError;

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
    /// A scene of the gallery cannot be built.
    #[error("{name}: {source}")]
    Scene {
        /// Its name.
        name: String,
        /// Why.
        source: Box<SceneError>,
    },
    /// No scene of the gallery has this name.
    #[error("no golden `{0}` can be made: the gallery has no such scene (`groundtruth list`)")]
    NoScene(String),
    /// A golden is accepted without a reason.
    #[error("a golden is accepted with a reason: --because \"what it was checked against\"")]
    NoReason,
}
