//! The renderers for which scenes are written.

use std::path::Path;

use groundtruth::scene::Scene;
use groundtruth::{cameras, lights, materials, shapes, textures};

use super::kinds::{self, How};
use super::{Unsayable, mitsuba, pov};

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
pub struct Said {
    /// One text, or several whose pictures are to be added.
    pub scenes: Vec<String>,
    /// The files that the texts name, with their contents.
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
    ) -> Result<Said, Vec<Unsayable>> {
        let of_text = |text| Said { scenes: vec![text], files: Vec::new() };
        match self {
            Self::Pov => pov::write(name, scene, folder).map(of_text),
            Self::Mitsuba => mitsuba::write(name, stem, scene, folder),
        }
    }

    /// How it says a shape.
    pub fn shape(self, kind: &shapes::Kind) -> (How, &'static str) {
        match self {
            Self::Pov => kinds::pov_shape(kind),
            Self::Mitsuba => mitsuba::kinds::shape(kind),
        }
    }

    /// How it says a material.
    pub fn material(self, kind: &materials::Kind) -> (How, &'static str) {
        match self {
            Self::Pov => kinds::pov_material(kind),
            Self::Mitsuba => mitsuba::kinds::material(kind),
        }
    }

    /// How it says a light.
    pub fn light(self, kind: &lights::Kind) -> (How, &'static str) {
        match self {
            Self::Pov => kinds::pov_light(kind),
            Self::Mitsuba => mitsuba::kinds::light(kind),
        }
    }

    /// How it says a texture.
    pub fn texture(self, kind: &textures::Kind) -> (How, &'static str) {
        match self {
            Self::Pov => kinds::pov_texture(kind),
            Self::Mitsuba => mitsuba::kinds::texture(kind),
        }
    }

    /// How it says a camera.
    pub fn camera(self, kind: &cameras::Kind) -> (How, &'static str) {
        match self {
            Self::Pov => kinds::pov_camera(kind),
            Self::Mitsuba => mitsuba::kinds::camera(kind),
        }
    }
}
