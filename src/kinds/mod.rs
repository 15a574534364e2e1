//! Kinds: how one file and one entry add a shape, camera, sampler, light, material or texture.
//!
//! A kind's file holds plain data that a scene file can say, marked by `#[kind]` (package `kind`),
//! and its `Specification`, which makes the thing itself of it. The list in the folder's `mod.rs`,
//! written with [`kinds!`](crate::kinds!), makes of all of them one enum, and gives each its tag.
//! The folder's `specimens.toml` has valid examples of each, for contracts, docs, exporters and
//! fuzz bodies.

mod field;
mod resources;

use std::fmt::Debug;
use std::sync::Arc;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::Serialize;
use serde::de::DeserializeOwned;

pub use field::{Field, Giving, Plain};
pub use resources::{ImageSource, Resources};

/// One line of the list of kinds.
pub struct Entry<Kind> {
    /// The chapter that brings the kind, as `ch19`.
    pub chapter: &'static str,
    /// The file it lives in, without `.rs`.
    pub module: &'static str,
    /// Valid examples.
    pub specimens: fn() -> Vec<Kind>,
    /// What a light adds at a hit, or a surface of a material sends to the viewer; empty for kinds
    /// of other lists.
    pub formula: &'static str,
}

/// A thing of a user's own, for which there is no data: it cannot be written to a scene file.
#[derive(Debug)]
pub struct Custom<T: ?Sized>(pub Arc<T>);

impl<T: ?Sized> Clone for Custom<T> {
    fn clone(&self) -> Self {
        Self(Arc::clone(&self.0))
    }
}

/// `OpenCylinder` as scene files write it: `open_cylinder`.
pub fn tag(name: &str) -> String {
    let mut tag = String::new();
    for (i, c) in name.char_indices() {
        if c.is_uppercase() && i > 0 {
            tag.push('_');
        }
        tag.extend(c.to_lowercase());
    }
    tag
}

/// The tag that a list gives a kind, or that of its name.
#[doc(hidden)]
pub fn tag_of(name: &str, given: &[&str]) -> String {
    given.first().map_or_else(|| tag(name), |&given| given.to_owned())
}

/// The schema of a list of kinds: a table of one key, which is the tag of a kind. The title of the
/// list is its trait's name in the plural.
#[doc(hidden)]
pub fn schema_of_list(
    of_trait: &str,
    description: &str,
    kinds: impl IntoIterator<Item = (String, Schema)>,
) -> Schema {
    let kinds: serde_json::Map<_, _> =
        kinds.into_iter().map(|(tag, schema)| (tag, schema.to_value())).collect();
    json_schema!({
        "title": format!("{}s", of_trait.to_lowercase()),
        "description": description.trim(),
        "type": "object",
        "properties": kinds,
        "additionalProperties": false,
        "minProperties": 1,
        "maxProperties": 1,
    })
}

const SCENES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/scenes");

/// The examples of a list by tag, from its text, where `{scenes}` stands for the folder of scenes.
#[doc(hidden)]
pub fn examples(text: &str) -> toml::Table {
    let list = toml::from_str(&text.replace("{scenes}", SCENES));
    list.unwrap_or_else(|error| panic!("specimens: {error}"))
}

/// The examples of the kind with this tag.
#[doc(hidden)]
pub fn specimens<Data: DeserializeOwned>(examples: &toml::Table, tag: &str) -> Vec<Data> {
    let specimens = examples.get(tag).unwrap_or_else(|| panic!("{tag} has no specimens"));
    specimens.clone().try_into().unwrap_or_else(|error| panic!("specimens of {tag}: {error}"))
}

/// The schema of one kind of a list, with the chapter that brings it and its first specimen.
#[doc(hidden)]
pub fn schema_of_kind<Data: JsonSchema + Serialize>(
    chapter: &str,
    example: Option<Data>,
    generator: &mut SchemaGenerator,
) -> Schema {
    let mut schema = generator.subschema_for::<Data>();
    schema.insert("x-chapter".to_owned(), chapter.into());
    let example = example.and_then(|it| serde_json::to_string(&it).ok());
    // examples name files as a scene in scenes/ does
    let example = example.map(|it| it.replace(&format!("{SCENES}/"), ""));
    if let Some(example) = example.and_then(|text| serde_json::from_str(&text).ok()) {
        schema.insert("examples".to_owned(), serde_json::Value::Array(vec![example]));
    }
    schema
}

/// Writes the enum of a folder's kinds from its list of entries.
#[macro_export]
#[doc(hidden)]
macro_rules! kinds {
    (
        $(#[doc = $doc:literal])*
        $Kind:ident builds dyn $Trait:ident with $Context:ty $(, finished by $finish:path)?;
        $($chapter:ident $module:ident::$Data:ident $(as $tag:literal)?),* $(,)?
    ) => {
        $(pub use $module::$Data;)*

        /// A thing of this list, or what is wrong with the data that describe it.
        pub type Made = Result<::std::sync::Arc<dyn $Trait>, $crate::invalid::Invalid>;

        pub(crate) fn made(it: impl $Trait + 'static) -> Made {
            Ok(::std::sync::Arc::new(it))
        }

        /// Plain data that describes one thing of this list.
        pub trait Specification: $crate::invalid::Ranges {
            /// What a light adds at a hit, or a surface of a material sends to the viewer, as a
            /// formula for people who build the scene in another renderer; empty for kinds of other
            /// lists, whose fields say all.
            const FORMULA: &'static str = "";

            /// Makes the thing, from fields that are in their ranges.
            ///
            /// # Errors
            /// Names the field that does not fit the others, or the context.
            fn make(&self, context: &mut $Context) -> Made;

            /// Checks the data and builds.
            ///
            /// # Errors
            /// [`Invalid`]($crate::invalid::Invalid) names the field that does not fit.
            fn build(&self, context: &mut $Context) -> Made {
                self.check_ranges()?;
                self.make(context)
            }
        }

        $(#[doc = $doc])*
        #[derive(Clone, Debug, ::serde::Serialize, ::serde::Deserialize)]
        #[serde(rename_all = "snake_case")]
        pub enum $Kind {
            $(
                #[doc = concat!("See [`", stringify!($Data), "`].")]
                $(#[serde(rename = $tag)])?
                $Data($Data),
            )*
            /// A kind of a user's own; not in scene files.
            #[serde(skip)]
            Custom($crate::kinds::Custom<dyn $Trait>),
        }

        $(
            impl From<$Data> for $Kind {
                fn from(data: $Data) -> Self {
                    Self::$Data(data)
                }
            }
        )*

        /// Read once: whoever asks for all kinds asks for each.
        static EXAMPLES: ::std::sync::LazyLock<::toml::Table> = ::std::sync::LazyLock::new(
            || $crate::kinds::examples(include_str!("specimens.toml")),
        );

        impl ::schemars::JsonSchema for $Kind {
            fn schema_name() -> ::std::borrow::Cow<'static, str> {
                concat!(stringify!($Trait), "Kind").into()
            }

            fn json_schema(generator: &mut ::schemars::SchemaGenerator) -> ::schemars::Schema {
                let kinds = [$({
                    let tag = $crate::kinds::tag_of(stringify!($Data), &[$($tag)?]);
                    let first = $crate::kinds::specimens(&EXAMPLES, &tag).into_iter().next();
                    let schema = $crate::kinds::schema_of_kind::<$Data>(stringify!($chapter), first, generator);
                    (tag, schema)
                }),*];
                $crate::kinds::schema_of_list(stringify!($Trait), concat!($($doc, "\n"),*), kinds)
            }
        }

        impl $Kind {
            /// Every kind, in the order of the list.
            pub const ENTRIES: &'static [$crate::kinds::Entry<Self>] = &[$(
                $crate::kinds::Entry {
                    chapter: stringify!($chapter),
                    module: stringify!($module),
                    specimens: || {
                        let tag = $crate::kinds::tag_of(stringify!($Data), &[$($tag)?]);
                        let all: Vec<$Data> = $crate::kinds::specimens(&EXAMPLES, &tag);
                        all.into_iter().map(Self::from).collect()
                    },
                    formula: <$Data as Specification>::FORMULA,
                },
            )*];

            /// Checks the data and builds the thing.
            ///
            /// # Errors
            /// [`Invalid`](crate::invalid::Invalid) names the field that does not fit.
            pub fn build(&self, context: &mut $Context) -> Made {
                let (built, name, given): (_, &str, &[&str]) = match self {
                    $(Self::$Data(data) => (
                        Specification::build(data, context),
                        stringify!($Data),
                        &[$($tag)?],
                    ),)*
                    Self::Custom(custom) => return Ok(::std::sync::Arc::clone(&custom.0)),
                };
                $(let built = built.and_then(|built| $finish(built, context));)?
                built.map_err(|e| e.inside($crate::kinds::tag_of(name, given).as_str()))
            }
        }
    };
}

/// The default of many factors.
pub fn one() -> f64 {
    1.0
}

/// The default of many colours in scene files.
pub(crate) fn white<T: From<crate::rgb::Rgb>>() -> T {
    crate::rgb::Rgb::WHITE.into()
}
