//! Lists of a fixed length in files.

use std::borrow::Cow;
use std::fmt;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::value::SeqAccessDeserializer;
use serde::de::{Error, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer};

use super::Vector;

/// Reads a list of exactly `N`. (serde's array silently takes the first `N` of a longer list.)
///
/// # Errors
/// If the list has another length, or an element cannot be read.
pub fn exactly<'de, D, T, const N: usize>(deserializer: D) -> Result<[T; N], D::Error>
where
    D: Deserializer<'de>,
    T: Deserialize<'de>,
{
    let list = Vec::deserialize(deserializer)?;
    let found = list.len();
    list.try_into()
        .map_err(|_| Error::invalid_length(found, &format!("an array of length {N}").as_str()))
}

/// Reads a list of exactly `N` rows of exactly `M` numbers each.
///
/// # Errors
/// As [`exactly`], of the list or of a row.
pub fn rows<'de, D, const N: usize, const M: usize>(
    deserializer: D,
) -> Result<[[f64; M]; N], D::Error>
where
    D: Deserializer<'de>,
{
    exactly(deserializer).map(|rows: [Row<f64, M>; N]| rows.map(|Row(row)| row))
}

/// Reads a list, which may be left out, of rows of exactly `M` each.
///
/// # Errors
/// As [`exactly`], of a row.
pub fn of_rows_if_any<'de, D, T, const M: usize>(
    deserializer: D,
) -> Result<Option<Vec<[T; M]>>, D::Error>
where
    D: Deserializer<'de>,
    T: Deserialize<'de>,
{
    let rows: Vec<Row<T, M>> = Vec::deserialize(deserializer)?;
    Ok(Some(rows.into_iter().map(|Row(row)| row).collect()))
}

/// A list of exactly `N`.
#[derive(Deserialize)]
#[serde(bound = "T: Deserialize<'de>")]
struct Row<T, const N: usize>(#[serde(deserialize_with = "exactly")] [T; N]);

/// As [`exactly`], for a list that may be left out.
///
/// # Errors
/// As [`exactly`].
pub fn exactly_if_any<'de, D, T, const N: usize>(
    deserializer: D,
) -> Result<Option<[T; N]>, D::Error>
where
    D: Deserializer<'de>,
    T: Deserialize<'de>,
{
    exactly(deserializer).map(Some)
}

/// Reads a vector, or one number for all its components.
///
/// # Errors
/// If it is neither, or the number of components is wrong.
pub fn number_or_vector<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vector, D::Error> {
    deserializer.deserialize_any(NumberOrVector)
}

/// How [`number_or_vector`] is written.
pub struct NumberOrVector;

impl JsonSchema for NumberOrVector {
    fn schema_name() -> Cow<'static, str> {
        "NumberOrVector".into()
    }

    fn inline_schema() -> bool {
        true
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let vector = <[f64; 3]>::json_schema(generator);
        json_schema!({ "anyOf": [{ "type": "number" }, vector] })
    }
}

impl<'de> Visitor<'de> for NumberOrVector {
    type Value = Vector;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "one factor, or three as [x, y, z]")
    }

    fn visit_f64<E: Error>(self, number: f64) -> Result<Vector, E> {
        Ok(Vector::new(number, number, number))
    }

    fn visit_i64<E: Error>(self, number: i64) -> Result<Vector, E> {
        self.visit_f64(number as f64)
    }

    fn visit_u64<E: Error>(self, number: u64) -> Result<Vector, E> {
        self.visit_f64(number as f64)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, numbers: A) -> Result<Vector, A::Error> {
        Vector::deserialize(SeqAccessDeserializer::new(numbers))
    }
}
