//! Textures: colours that vary over a surface (Suffern, ch. 29–31). Every colour of a material is
//! one; a plain colour is the constant texture.

mod checker3d;
mod constant;
mod plane_checker;
mod random_colors;

use std::borrow::Cow;
use std::fmt::Debug;
use std::sync::Arc;

use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use crate::invalid::Invalid;
use crate::rgb::{ColorOr, Colorful, Rgb};
use crate::shapes::Surface;

/// A colour for each point of a surface. Contract: `tests/contracts/texture.rs`.
pub trait Texture: Debug + Send + Sync {
    /// The colour at a hit; solid textures look at the local point.
    fn color(&self, at: &Surface) -> Rgb;
}

crate::kinds! {
    /// A colour that varies over a surface. It may be written wherever a material has a colour.
    Kind builds dyn Texture with ();
    ch30 constant::Constant,
    ch30 checker3d::Checker3d,
    ch30 plane_checker::PlaneChecker,
    ch22 random_colors::RandomColors,
}

/// A colour of a material: in scene files `[r, g, b]`, one number for a grey, or a texture, as
/// `{ checker3d = { size = 4.0 } }`.
#[derive(Clone, Debug)]
pub struct Paint(pub Kind);

impl Paint {
    /// One colour everywhere.
    pub const fn plain(color: Rgb) -> Self {
        Self(Kind::Constant(Constant { color }))
    }

    /// Checks the data of the field of this name and builds the texture.
    pub(crate) fn build(&self, field: &str) -> Result<Arc<dyn Texture>, Invalid> {
        match &self.0 {
            Kind::Constant(constant) => {
                constant.color.checked(field)?;
                Ok(Arc::new(constant.clone()))
            }
            kind => kind.build(&mut ()).map_err(|e| e.inside(field)),
        }
    }

    /// The same paint with every length multiplied by `factor`.
    pub fn scaled(&self, factor: f64) -> Self {
        Self(self.0.scaled(factor))
    }
}

impl From<Rgb> for Paint {
    fn from(color: Rgb) -> Self {
        Self::plain(color)
    }
}

impl Serialize for Paint {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match &self.0 {
            Kind::Constant(constant) => constant.color.serialize(serializer),
            kind => kind.serialize(serializer),
        }
    }
}

impl Colorful for Kind {
    const NAME: &'static str = "a texture";
}

impl JsonSchema for Paint {
    fn schema_name() -> Cow<'static, str> {
        ColorOr::<Kind>::schema_name()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        ColorOr::<Kind>::json_schema(generator)
    }
}

impl<'de> Deserialize<'de> for Paint {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        Ok(match ColorOr::deserialize(deserializer)? {
            ColorOr::Color(color) => Self::plain(color),
            ColorOr::Kind(kind) => Self(kind),
        })
    }
}
