//! The renderers for which scenes are written.

use std::path::Path;

use groundtruth::scene::Scene;
use groundtruth::shapes;

use super::kinds::{AnyKind, How};
use super::leaves::Leaves;
use super::{Unsupported, mitsuba, pov};

/// A renderer for which scenes are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Target {
    /// POV-Ray 3.7.
    Pov,
    /// Mitsuba 3.
    Mitsuba,
}

/// A scene in the language of another renderer.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Exported {
    /// Its text.
    pub text: String,
    /// The files that the text names, with their contents.
    pub files: Vec<(String, Vec<u8>)>,
}

/// A scene in the language of a target, or all that cannot be said.
pub type Written = Result<Exported, Vec<Unsupported>>;

/// All that is known of a target: its entry in its own folder.
pub struct ExportLanguage {
    pub(super) name: &'static str,
    /// The program that renders, and its arguments to say its version.
    pub(super) program: &'static str,
    pub(super) version: &'static [&'static str],
    /// What to do if it does not say its version.
    pub(super) missing: Option<&'static str>,
    /// The files of a scene and of its picture.
    pub(super) files: [&'static str; 2],
    /// The arguments to render a scene, with spaces between them and `{width}` and `{height}` of its picture.
    pub(super) arguments: &'static str,
    /// A file that rendering needs besides, with its contents.
    pub(super) script: Option<[&'static str; 2]>,
    /// The scene in its language: name, the beginning of the names of further files, leaves, scene, folder.
    pub(super) write: fn([&str; 2], &Leaves<'_>, &Scene, &Path) -> Written,
    /// How a kind is exported that is not taken apart.
    pub(super) how: fn(&Scene, &AnyKind) -> How,
    /// How a shape that is taken apart is exported; `None` if it is written as a whole, or not at all.
    pub(super) apart: fn(&shapes::Kind) -> Option<How>,
    /// Whether both sides have a picture without noise.
    pub is_noiseless: fn(&Scene) -> bool,
    /// Whether it computes in single precision.
    pub is_single: bool,
}

impl Target {
    /// All, in the order of the columns of the table.
    pub const ALL: [Self; 2] = [Self::Pov, Self::Mitsuba];

    /// What is known of it.
    pub fn language(self) -> &'static ExportLanguage {
        match self {
            Self::Pov => &pov::LANGUAGE,
            Self::Mitsuba => &mitsuba::LANGUAGE,
        }
    }

    /// Its name.
    pub fn name(self) -> &'static str {
        self.language().name
    }

    /// A scene of this name in its language. The names of further files begin with `stem`; `folder` is where the files are
    /// that the scene names.
    ///
    /// # Errors
    /// All that cannot be said.
    pub fn write(self, name: &str, stem: &str, scene: &Scene, folder: &Path) -> Written {
        (self.language().write)([name, stem], &Leaves::of(scene, self), scene, folder)
    }

    /// How it exports a kind: what the writer says of it.
    pub fn how(self, kind: &AnyKind) -> How {
        let apart = match kind {
            AnyKind::Shape(shape) => (self.language().apart)(shape),
            _ => None,
        };
        apart.unwrap_or_else(|| (self.language().how)(&kind.scene(), kind))
    }
}
