//! The dimension of a field, in the schema of scene files.

use std::borrow::Cow;
use std::marker::PhantomData;

use schemars::{JsonSchema, Schema, SchemaGenerator};

/// The key of a field's dimension in the schema: `length`, `1/length`, one of them to the power of
/// another field as in `length^attenuation`, or `1` for a part without one.
pub const DIMENSION: &str = "x-dimension";

/// What the schema says of a field whose numbers are lengths: `#[schemars(with = "Length")]`, or
/// `Length<Vector>` for a displacement. The coordinates of a [`Point`](super::Point) are always
/// lengths.
pub struct Length<T = f64>(PhantomData<T>);

impl<T: JsonSchema> JsonSchema for Length<T> {
    fn schema_name() -> Cow<'static, str> {
        format!("LengthOf{}", T::schema_name()).into()
    }

    fn inline_schema() -> bool {
        true
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let mut schema = generator.subschema_for::<T>();
        schema.insert(DIMENSION.to_owned(), "length".into());
        schema
    }
}
