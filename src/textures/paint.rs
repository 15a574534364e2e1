//! Colours of materials, plain or textured: as scene data ([`Paint`]) and built ([`Color`]).

use std::borrow::Cow;
use std::sync::Arc;

use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::{Kind, Texel, Texture, TexturePoint};
use crate::invalid::Invalid;
use crate::kinds::Resources;
use crate::rgb::{ColorOr, Colorful, Rgb};

/// A colour of a material: in scene files `[r, g, b]`, one number for a grey, or a texture, such as
/// `{ checker3d = { size = 4.0 } }`.
#[derive(Clone, Debug)]
pub enum Paint {
    /// One colour everywhere.
    Plain(Rgb),
    /// A colour that varies.
    Textured(Box<Kind>),
}

/// A built colour.
#[derive(Clone, Debug)]
pub enum Color {
    /// One colour everywhere.
    Plain(Rgb),
    /// A colour that varies.
    Textured(Arc<dyn Texture>),
}

impl Color {
    /// The colour at a point.
    pub fn at(&self, at: &TexturePoint<'_>) -> Rgb {
        match self {
            Self::Plain(color) => *color,
            Self::Textured(texture) => texture.color(at),
        }
    }

    /// The red channel, or the number of the texture.
    pub(super) fn number(&self, at: &TexturePoint<'_>) -> f64 {
        match self {
            Self::Plain(color) => color.r,
            Self::Textured(texture) => texture.number(at),
        }
    }

    /// The texel at a point; `None` without an image.
    pub(super) fn texel(&self, at: &TexturePoint<'_>) -> Option<Texel> {
        self.texture()?.texel(at)
    }

    /// The texture, if it is one.
    pub fn texture(&self) -> Option<&dyn Texture> {
        match self {
            Self::Plain(_) => None,
            Self::Textured(texture) => Some(&**texture),
        }
    }
}

impl Paint {
    /// Checks the data of the field of this name and builds the colour.
    pub fn build(&self, field: &str, resources: &mut Resources) -> Result<Color, Invalid> {
        match self {
            Self::Plain(color) => color.checked(field).map(Color::Plain),
            Self::Textured(kind) => {
                kind.build(resources).map(Color::Textured).map_err(|e| e.inside(field))
            }
        }
    }

    /// Checks the colours of the list of this name and builds them.
    pub(super) fn build_list(
        paints: &[Self],
        field: &str,
        resources: &mut Resources,
    ) -> Result<Vec<Color>, Invalid> {
        let build = |(index, paint): (usize, &Self)| {
            paint.build(field, resources).map_err(|mut e| {
                e.path.insert(1, index.into()); // after the name of the list
                e
            })
        };
        paints.iter().enumerate().map(build).collect()
    }
}

impl From<Rgb> for Paint {
    fn from(color: Rgb) -> Self {
        Self::Plain(color)
    }
}

impl<T: Into<Kind>> From<T> for Paint {
    fn from(texture: T) -> Self {
        Self::Textured(Box::new(texture.into()))
    }
}

impl Serialize for Paint {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Plain(color) => color.serialize(serializer),
            Self::Textured(kind) => kind.serialize(serializer),
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
            ColorOr::Color(color) => Self::Plain(color),
            ColorOr::Kind(kind) => Self::Textured(Box::new(kind)),
        })
    }
}
