//! The purposes of rays, and the words that programs have for them.

use std::fmt;
use std::sync::Arc;

/// The purpose of a ray.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Purpose {
    /// From the eye.
    Camera,
    /// Mirrored.
    Reflected,
    /// Refracted.
    Transmitted,
    /// Scattered by a surface that is no mirror, to its own side.
    Diffuse,
    /// Scattered about the mirrored direction, to its own side.
    Glossy,
    /// The next ray of a path, to either side.
    Path,
    /// Towards a lamp.
    Shadow,
    /// Towards anything near.
    Occlusion,
    /// A word of the log: only its geometry is judged.
    Other(Arc<str>),
}

impl Purpose {
    /// The purpose that this word means.
    pub fn of(word: &str) -> Self {
        match word.to_ascii_lowercase().as_str() {
            "camera" | "primary" | "eye" => Self::Camera,
            "reflected" | "reflection" | "mirror" | "specular" => Self::Reflected,
            "transmitted" | "transmission" | "refracted" | "refraction" => Self::Transmitted,
            "diffuse" => Self::Diffuse,
            "glossy" | "rough" => Self::Glossy,
            "path" | "bounce" | "indirect" | "scattered" => Self::Path,
            "shadow" | "nee" | "light" => Self::Shadow,
            "occlusion" | "ao" => Self::Occlusion,
            _ => Self::Other(word.into()),
        }
    }
}

impl fmt::Display for Purpose {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Camera => "camera",
            Self::Reflected => "reflected",
            Self::Transmitted => "transmitted",
            Self::Diffuse => "diffuse",
            Self::Glossy => "glossy",
            Self::Path => "path",
            Self::Shadow => "shadow",
            Self::Occlusion => "occlusion",
            Self::Other(word) => word,
        })
    }
}
