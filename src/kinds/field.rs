//! Fields of scene files that are a plain value, or of a kind, as `{ kind = { … } }`.

use std::borrow::Cow;
use std::fmt;
use std::marker::PhantomData;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::value::{MapAccessDeserializer, SeqAccessDeserializer};
use serde::de::{self, IntoDeserializer, MapAccess, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize};

use crate::rgb::Rgb;

/// A plain value, or what gives such values.
#[derive(Clone, Debug, Serialize)]
#[serde(untagged)]
pub enum Field<V, K> {
    /// The same everywhere.
    Plain(V),
    /// A value that varies.
    Textured(Box<K>),
}

/// A value that can be said plainly.
pub trait Plain: Sized {
    /// Its name in schemas.
    const NAME: &'static str;
    /// What it is in an error, and in a description.
    const WORDS: [&'static str; 2];
    /// What a description adds about kinds.
    const BY_KIND: &'static str;
    /// Whether it may be a list.
    const IS_LIST: bool;

    /// The schema of the plain value.
    fn schema(generator: &mut SchemaGenerator) -> Schema;
}

impl Plain for f64 {
    const NAME: &'static str = "Number";
    const WORDS: [&'static str; 2] = ["a number", "A number of at least 0"];
    const BY_KIND: &'static str =
        ", whose red channel is the number; an image of numbers needs `encoding = \"linear\"`";
    const IS_LIST: bool = false;

    fn schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({ "type": "number", "minimum": 0 })
    }
}

impl Plain for Rgb {
    const NAME: &'static str = "Colour";
    const WORDS: [&'static str; 2] = [
        "a colour [r, g, b], one number for a grey",
        "A colour as `[r, g, b]`, one number for a grey",
    ];
    const BY_KIND: &'static str = "";
    const IS_LIST: bool = true;

    fn schema(generator: &mut SchemaGenerator) -> Schema {
        generator.subschema_for::<Self>()
    }
}

/// A list of kinds that give values.
pub trait Giving: JsonSchema {
    /// What people call one of them, with its article.
    const NAME: &'static str;
}

impl<V: Plain, K: Giving> JsonSchema for Field<V, K> {
    fn schema_name() -> Cow<'static, str> {
        format!("{}Or{}", V::NAME, K::schema_name().trim_end_matches("Kind")).into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let ([_, plain], kind, by_kind) = (V::WORDS, K::NAME, V::BY_KIND);
        json_schema!({
            "description": format!("{plain}, or {kind} as `{{ kind = {{ … }} }}`{by_kind}."),
            "anyOf": [V::schema(generator), generator.subschema_for::<K>()],
        })
    }
}

impl<'de, V, K> Deserialize<'de> for Field<V, K>
where
    V: Plain + Deserialize<'de>,
    K: Giving + Deserialize<'de>,
{
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(FieldVisitor(PhantomData))
    }
}

struct FieldVisitor<V, K>(PhantomData<(V, K)>);

impl<'de, V, K> Visitor<'de> for FieldVisitor<V, K>
where
    V: Plain + Deserialize<'de>,
    K: Giving + Deserialize<'de>,
{
    type Value = Field<V, K>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}, or {}", V::WORDS[0], K::NAME)
    }

    fn visit_f64<E: de::Error>(self, number: f64) -> Result<Field<V, K>, E> {
        V::deserialize(number.into_deserializer()).map(Field::Plain)
    }

    fn visit_i64<E: de::Error>(self, number: i64) -> Result<Field<V, K>, E> {
        self.visit_f64(number as f64)
    }

    fn visit_u64<E: de::Error>(self, number: u64) -> Result<Field<V, K>, E> {
        self.visit_f64(number as f64)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, list: A) -> Result<Field<V, K>, A::Error> {
        match V::IS_LIST {
            true => V::deserialize(SeqAccessDeserializer::new(list)).map(Field::Plain),
            false => Err(de::Error::invalid_type(de::Unexpected::Seq, &self)),
        }
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Field<V, K>, A::Error> {
        let kind = K::deserialize(MapAccessDeserializer::new(map))?;
        Ok(Field::Textured(Box::new(kind)))
    }
}
