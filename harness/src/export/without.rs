//! Terms of our formulas that another renderer does not have, left out on both sides.

use std::str::FromStr;

use groundtruth::background::Background;
use groundtruth::materials::{Kind, Phong};
use groundtruth::rgb::Rgb;
use groundtruth::scene::{Light, Scene, Tracer};

/// A term that can be left out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Term {
    /// The highlights of materials: `ks` becomes 0.
    Phong,
    /// Ambient light: those lights are switched off.
    Ambient,
    /// The colour behind everything, where it is only seen and lights nothing: it becomes black.
    Background,
    /// Lights and things without shadows: they get them.
    Shadowless,
}

impl Term {
    /// All, by their names.
    pub const ALL: [(&'static str, Self); 4] = [
        ("phong", Self::Phong),
        ("ambient", Self::Ambient),
        ("background", Self::Background),
        ("shadowless", Self::Shadowless),
    ];

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
            Self::Background if is_sky(scene) => {}
            Self::Background => scene.background = Background::Color(Rgb::BLACK),
            Self::Shadowless => {
                scene.lights.iter_mut().for_each(|light| light.shadows = true);
                scene.materials.iter_mut().for_each(|material| material.casts_shadows = true);
                scene.objects.iter_mut().for_each(|object| object.casts_shadows = true);
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

/// Whether the background is a light: an environment light samples it, or paths meet it.
pub(super) fn is_sky(scene: &Scene) -> bool {
    use groundtruth::lights::Kind::Environment;
    let sampled = |light: &Light| light.enabled && matches!(light.source, Environment(_));
    let is_path = !matches!(scene.tracer, Tracer::RayCast | Tracer::Whitted(_));
    is_path || scene.lights.iter().any(sampled)
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
