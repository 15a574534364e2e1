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

use std::fmt::Debug;

use crate::kinds;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::emission::Emission;
use crate::invalid::{Invalid, positive};
use crate::lobes::Lobes;
use crate::resources::Resources;
use crate::rgb::Rgb;
use crate::textures::{Texture, TexturePoint};

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

    /// The textures that count at a point, with the fields that they stand in, as in `phong.cd`. Asked
    /// only by those who want to know why a point has its colour.
    fn textures(&self, _at: &TexturePoint<'_>) -> Vec<TexturedField<'_>> {
        Vec::new()
    }

    /// Whether light passes through, so that the surface must know its inside.
    fn transmits(&self) -> bool {
        self.boundary().is_some()
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

/// The medium on each side of a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Boundary {
    /// On the inner side, which the normal points away from.
    pub inside: Medium,
    /// On the side the normal points to.
    pub outside: Medium,
}

/// A transparent medium.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(example = Medium { eta: 1.33, absorption: Rgb::new(0.25, 0.0, 0.0625) })]
pub struct Medium {
    /// The index of refraction; positive. Air is 1, water 1.33, glass about 1.5.
    #[serde(default = "kinds::one")]
    pub eta: f64,
    /// `σ` per unit length: the book's colour filter is `exp(−σ)`, so clear is 0. It may be
    /// infinite in code, not in a scene file.
    #[serde(default)]
    pub absorption: Rgb,
}

impl Default for Medium {
    fn default() -> Self {
        Self { eta: 1.0, absorption: Rgb::BLACK }
    }
}

impl Medium {
    /// A medium without absorption.
    pub const fn clear(eta: f64) -> Self {
        Self { eta, absorption: Rgb::BLACK }
    }

    pub(crate) fn checked(self, field: &str) -> Result<Self, Invalid> {
        positive("eta", self.eta).map_err(|e| e.inside(field))?;
        self.absorption.checked("absorption").map_err(|e| e.inside(field))?;
        Ok(self)
    }

    /// The same medium where lengths are `factor` times as long.
    #[must_use]
    pub fn scaled(self, factor: f64) -> Self {
        Self { absorption: (1.0 / factor) * self.absorption, ..self }
    }
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
