//! Scenes as TOML: files read and written, errors that say line, object and field, and what a file can say.
//!
//! [`read`] gives a scene and its world. The [`schema()`] is made from the doc comments, types and defaults of the kinds
//! themselves, and [`vocabulary`] is read from it.

mod error;
mod file;
mod files;
mod locations;
mod mismatch;
mod schema;
mod syntax;
pub mod vocabulary;
mod words;
mod world;

pub use error::SceneError;
pub use file::{STANDARD_INPUT, Source, from_bytes, open, parse, to_toml};
pub use files::{files, files_from};
pub use schema::schema;
pub use words::plain_words;
pub use world::{from_toml, read};
