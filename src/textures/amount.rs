//! Numbers of materials, plain or textured: as scene data ([`Amount`]) and built ([`Value`]).

use std::borrow::Cow;
use std::fmt;
use std::sync::Arc;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::value::MapAccessDeserializer;
use serde::de::{self, MapAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize};

use super::{Kind, Texture, TexturePoint};
use crate::invalid::{Invalid, strength};
use crate::kinds::Resources;

/// A number of a material, not negative: in scene files a number, or a texture whose red channel is
/// the number, such as `{ image = { file = "gloss.png", encoding = "linear" } }`.
#[derive(Clone, Debug, Serialize)]
#[serde(untagged)]
pub enum Amount {
    /// The same everywhere.
    Plain(f64),
    /// The red channel of a texture.
    Textured(Box<Kind>),
}

/// A built number.
#[derive(Clone, Debug)]
pub enum Value {
    /// The same everywhere.
    Plain(f64),
    /// The red channel of a texture.
    Textured(Arc<dyn Texture>),
}

impl Value {
    /// The number at a point.
    pub fn at(&self, at: &TexturePoint<'_>) -> f64 {
        match self {
            Self::Plain(value) => *value,
            Self::Textured(texture) => texture.number(at),
        }
    }

    /// The texture, if it is one.
    pub fn texture(&self) -> Option<&dyn Texture> {
        match self {
            Self::Plain(_) => None,
            Self::Textured(texture) => Some(&**texture),
        }
    }
}

impl Amount {
    /// Checks the data of the field of this name and builds the number.
    pub(crate) fn build(&self, field: &str, resources: &mut Resources) -> Result<Value, Invalid> {
        match self {
            Self::Plain(value) => strength(field, *value).map(Value::Plain),
            Self::Textured(kind) => {
                kind.build(resources).map(Value::Textured).map_err(|e| e.inside(field))
            }
        }
    }

    /// The default of factors in scene files.
    pub(crate) fn one() -> Self {
        Self::Plain(1.0)
    }
}

/// Zero.
impl Default for Amount {
    fn default() -> Self {
        Self::Plain(0.0)
    }
}

impl From<f64> for Amount {
    fn from(value: f64) -> Self {
        Self::Plain(value)
    }
}

impl<T: Into<Kind>> From<T> for Amount {
    fn from(texture: T) -> Self {
        Self::Textured(Box::new(texture.into()))
    }
}

impl JsonSchema for Amount {
    fn schema_name() -> Cow<'static, str> {
        "NumberOrTexture".into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "description": "A number of at least 0, or a texture as `{ kind = { … } }`, whose red \
                channel is the number; an image of numbers needs `encoding = \"linear\"`.",
            "anyOf": [{ "type": "number", "minimum": 0 }, generator.subschema_for::<Kind>()],
        })
    }
}

impl<'de> Deserialize<'de> for Amount {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(AmountVisitor)
    }
}

struct AmountVisitor;

impl<'de> Visitor<'de> for AmountVisitor {
    type Value = Amount;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a number, or a texture")
    }

    fn visit_f64<E: de::Error>(self, value: f64) -> Result<Amount, E> {
        Ok(Amount::Plain(value))
    }

    fn visit_i64<E: de::Error>(self, value: i64) -> Result<Amount, E> {
        Ok(Amount::Plain(value as f64))
    }

    fn visit_u64<E: de::Error>(self, value: u64) -> Result<Amount, E> {
        Ok(Amount::Plain(value as f64))
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Amount, A::Error> {
        let kind = Kind::deserialize(MapAccessDeserializer::new(map))?;
        Ok(Amount::Textured(Box::new(kind)))
    }
}
