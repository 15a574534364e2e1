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

/// The words of programs for each purpose, ours first.
const WORDS: &[(Purpose, &[&str])] = &[
    (Purpose::Camera, &["camera", "primary", "eye"]),
    (Purpose::Reflected, &["reflected", "reflection", "mirror", "specular"]),
    (Purpose::Transmitted, &["transmitted", "transmission", "refracted", "refraction"]),
    (Purpose::Diffuse, &["diffuse"]),
    (Purpose::Glossy, &["glossy", "rough"]),
    (Purpose::Path, &["path", "bounce", "indirect", "scattered"]),
    (Purpose::Shadow, &["shadow", "nee", "light"]),
    (Purpose::Occlusion, &["occlusion", "ao"]),
];

impl Purpose {
    /// The purpose that this word means.
    pub fn of(word: &str) -> Self {
        let is = |names: &[&str]| names.iter().any(|name| name.eq_ignore_ascii_case(word));
        let known = WORDS.iter().find(|(_, names)| is(names));
        known.map_or_else(|| Self::Other(word.into()), |(purpose, _)| purpose.clone())
    }
}

impl fmt::Display for Purpose {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let known = WORDS.iter().find(|(purpose, _)| purpose == self);
        match (self, known) {
            (Self::Other(word), _) => f.write_str(word),
            (_, known) => f.write_str(known.map_or("", |(_, names)| names[0])),
        }
    }
}
