//! The renderers for which scenes are written.

use std::path::Path;

use groundtruth::scene::Scene;

use super::kinds::{AnyKind, How};
use super::parts::apart;
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

impl Target {
    /// All, in the order of the columns of the table.
    pub const ALL: [Self; 2] = [Self::Pov, Self::Mitsuba];

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Pov => "POV-Ray",
            Self::Mitsuba => "Mitsuba",
        }
    }

    /// A scene of this name in its language. The names of further files begin with `stem`; `folder` is where the files are
    /// that the scene names.
    ///
    /// # Errors
    /// All that cannot be said.
    pub fn write(
        self,
        name: &str,
        stem: &str,
        scene: &Scene,
        folder: &Path,
    ) -> Result<Exported, Vec<Unsupported>> {
        let of_text = |text| Exported { text, files: Vec::new() };
        match self {
            Self::Pov => pov::write(name, scene, folder).map(of_text),
            Self::Mitsuba => mitsuba::write(name, stem, scene, folder),
        }
    }

    /// How it exports a kind: what the writer says of it.
    pub fn how(self, kind: &AnyKind) -> How {
        if let AnyKind::Shape(shape) = kind
            && let Some(how) = apart(shape, self)
        {
            return how;
        }
        match self {
            Self::Pov => pov::how(&kind.scene(), kind),
            Self::Mitsuba => mitsuba::how(&kind.scene(), kind),
        }
    }
}
