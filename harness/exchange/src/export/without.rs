//! Terms of our formulas that another renderer does not have, left out on both sides.

use std::str::FromStr;

use groundtruth::background::Background;
use groundtruth::materials::{Kind, Phong};
use groundtruth::rgb::Rgb;
use groundtruth::scene::{Light, Scene, Tracer};
use groundtruth::shapes;

/// A term that can be left out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Term {
    /// The highlights of materials: `ks` becomes 0.
    Phong,
    /// Ambient light: those lights are switched off.
    Ambient,
    /// The colour behind everything, where it is only seen and lights nothing: it becomes black.
    Background,
    /// Light that passes through objects: all of them block that of all lights.
    Unshadowed,
    /// The absorption of media: glass becomes clear.
    Absorption,
    /// The factor 1/η² of refracted radiance.
    Scaling,
    /// Normals interpolated between the corners of triangles: meshes become flat.
    Smooth,
}

impl Term {
    /// All, by their names.
    pub const ALL: [(&'static str, Self); 7] = [
        ("phong", Self::Phong),
        ("ambient", Self::Ambient),
        ("background", Self::Background),
        ("unshadowed", Self::Unshadowed),
        ("absorption", Self::Absorption),
        ("scaling", Self::Scaling),
        ("smooth", Self::Smooth),
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
            Self::Unshadowed => {
                scene.lights.iter_mut().for_each(|it| it.shadows = true);
                scene.materials.iter_mut().for_each(|it| it.casts_shadows = true);
                scene.objects.iter_mut().for_each(|it| it.casts_shadows = true);
            }
            Self::Absorption => {
                scene.camera.medium.absorption = Rgb::BLACK;
                for material in &mut scene.materials {
                    if let Kind::Dielectric(it) = &mut material.recipe {
                        it.inside.absorption = Rgb::BLACK;
                        it.outside.absorption = Rgb::BLACK;
                    }
                }
            }
            Self::Scaling => scene.transparency.scales_radiance = false,
            Self::Smooth => {
                scene.objects.iter_mut().for_each(|it| flatten(&mut it.shape));
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

/// Gives the triangles of a shape one normal each.
fn flatten(shape: &mut shapes::Kind) {
    use shapes::Kind::{Compound, Instance, Mesh, TessellatedSphere, Triangle};
    match shape {
        Triangle(it) => it.normals = None,
        Mesh(it) => it.smooth = false,
        TessellatedSphere(it) => it.smooth = false,
        Instance(it) => flatten(&mut it.of),
        Compound(it) => it.parts.iter_mut().for_each(|part| flatten(&mut part.shape)),
        _ => {}
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
        _ => None,
    }
}
