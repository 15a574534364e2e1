//! Materials: recipes that turn textures at a hit into lobes (Suffern, ch. 14, 15, 24, 27, 28).
//!
//! The book folds everything into `Material::shade`, which also loops over the lights and traces
//! rays. Here a material only says of what its surface is made; `trace` does the rest.

mod dielectric;
mod emissive;
mod glossy_reflector;
mod matte;
mod phong;
mod reflective;
mod sphere_materials;
mod transparent;

// shared by the kinds
mod emission;
mod medium;

use std::fmt::Debug;

use crate::invalid::Invalid;
use crate::kinds::Resources;
use crate::lobes::{Lobes, check_exponent};
use crate::rgb::Rgb;
use crate::textures::{Amount, Texture, TexturePoint, Value};

pub use emission::Emission;
pub use medium::{Boundary, Medium};

/// What a surface is made of. Contract: `tests/contracts/material.rs`.
pub trait Material: Debug + Send + Sync {
    /// Adds what the surface, seen under `cos_o = n·ω_o` (negative on the inner side), makes of the
    /// light that comes to it. Asked once for a hit, as textures may be costly.
    fn respond(&self, at: &TexturePoint<'_>, cos_o: f64, response: &mut Response);

    /// What it sends out by itself, if it shines.
    fn emission(&self) -> Option<&Emission> {
        None
    }

    /// What is on either side, for boundaries between media; `None` where rays stay in the medium
    /// they came through.
    fn boundary(&self) -> Option<Boundary> {
        None
    }

    /// The textures that count at a point, with the fields that they stand in, as in `phong.cd`.
    /// Asked only by those who want to know why a point has its colour.
    fn textures(&self, _at: &TexturePoint<'_>) -> Vec<TexturedField<'_>> {
        Vec::new()
    }

    /// Whether light passes through, so that the surface must know its inside.
    fn transmits(&self) -> bool {
        self.boundary().is_some()
    }

    /// Whether part of it is seen by reflected or refracted rays only.
    fn needs_rays(&self) -> bool {
        self.transmits()
    }
}

/// A texture of a material, and the field it stands in.
pub type TexturedField<'a> = (String, &'a dyn Texture);

/// The textures among these fields.
fn textured<'a>(
    fields: impl IntoIterator<Item = (&'static str, Option<&'a dyn Texture>)>,
) -> Vec<TexturedField<'a>> {
    let some = |(name, texture): (&str, Option<_>)| Some((name.to_owned(), texture?));
    fields.into_iter().filter_map(some).collect()
}

/// Builds the exponent of a lobe.
fn built_exponent(exponent: &Amount, resources: &mut Resources) -> Result<Value, Invalid> {
    if let Amount::Plain(exponent) = exponent {
        check_exponent(*exponent)?;
    }
    exponent.build("exponent", resources)
}

/// The textures of a material that stands in a field of another.
fn within<'a>(
    field: &str,
    material: &'a dyn Material,
    at: &TexturePoint<'_>,
) -> impl Iterator<Item = TexturedField<'a>> {
    material
        .textures(at)
        .into_iter()
        .map(move |(name, texture)| (format!("{field}.{name}"), texture))
}

/// What a surface makes of the light that comes to it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Response {
    /// The reflectance for ambient light, `ρ = k_a c_d`.
    pub ambient: Rgb,
    /// How light from a direction is scattered.
    pub lobes: Lobes,
}

crate::kinds! {
    /// What a surface makes of light.
    Kind builds dyn Material with Resources;
    ch14 matte::Matte,
    ch15 phong::Phong,
    ch24 reflective::Reflective,
    ch24 emissive::Emissive,
    ch25 glossy_reflector::GlossyReflector,
    ch27 transparent::Transparent,
    ch28 dielectric::Dielectric,
    ch30 sphere_materials::SphereMaterials,
}
