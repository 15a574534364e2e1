//! Terms of our formulas that another renderer does not have, left out on both sides.

use std::str::FromStr;

use groundtruth::materials::{Kind, Phong};
use groundtruth::scene::Scene;

/// A term that can be left out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Term {
    /// The highlights of materials: `ks` becomes 0.
    Phong,
    /// Ambient light: those lights are switched off.
    Ambient,
}

impl Term {
    /// All, by their names.
    pub const ALL: [(&'static str, Self); 2] = [("phong", Self::Phong), ("ambient", Self::Ambient)];

    /// Leaves it out of a scene.
    pub fn remove(self, scene: &mut Scene) {
        match self {
            Self::Phong => {
                for material in &mut scene.materials {
                    if let Some(phong) = phong_of(&mut material.recipe) {
                        phong.ks = 0.0.into();
                    }
                }
            }
            Self::Ambient => {
                use groundtruth::lights::Kind::{Ambient, AmbientOccluder};
                for light in &mut scene.lights {
                    light.enabled &= !matches!(light.source, Ambient(_) | AmbientOccluder(_));
                }
            }
        }
    }
}

impl FromStr for Term {
    type Err = String;

    fn from_str(name: &str) -> Result<Self, String> {
        let found = Self::ALL.into_iter().find(|(word, _)| *word == name);
        let names = Self::ALL.map(|(word, _)| word).join(", ");
        found.map(|(_, term)| term).ok_or_else(|| format!("there are: {names}"))
    }
}

/// The fields of `phong` in a material.
fn phong_of(recipe: &mut Kind) -> Option<&mut Phong> {
    match recipe {
        Kind::Phong(it) => Some(it),
        Kind::Reflective(it) => Some(&mut it.phong),
        Kind::GlossyReflector(it) => Some(&mut it.phong),
        Kind::Transparent(it) => Some(&mut it.phong),
        Kind::Dielectric(it) => Some(&mut it.phong),
        Kind::Matte(_) | Kind::Emissive(_) | Kind::SphereMaterials(_) | Kind::Custom(_) => None,
    }
}
