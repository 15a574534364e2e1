//! The compound (Suffern, ch. 19): any shapes as one; with `accel = "grid"` the book's `Grid` (ch.
//! 22).
//!
//! A ray hits the nearest hit of all parts, if it meets the box around them.

use super::assembly::{Assembly, PartData};
use crate::accel::Method;
use crate::invalid::Invalid;
use crate::shapes::{Context, Kind, Made, Specification, made};

/// Shapes that are hit, transformed and searched as one; they may be compounds themselves.
#[kind]
pub struct Compound {
    /// How rays find its parts. If left out: as the scene, but up to eight parts one by one.
    pub accel: Option<Method>,
    /// The parts; of two hit at the same distance, the first is seen.
    pub parts: Vec<Part>,
}

/// A part of a compound.
#[kind]
pub struct Part {
    /// What people call it; it need not be unique.
    #[optional]
    pub name: String,
    /// The name of its material; the compound's if left out.
    pub material: Option<String>,
    /// What it is.
    pub shape: Kind,
}

impl Part {
    /// A part without a name, of the compound's material.
    pub fn new(shape: impl Into<Kind>) -> Self {
        Self { name: String::new(), material: None, shape: shape.into() }
    }

    /// The same part of a material of its own.
    #[must_use]
    pub fn of_material(self, material: &str) -> Self {
        Self { material: Some(material.to_owned()), ..self }
    }
}

impl Compound {
    /// These shapes, of one material.
    pub fn of<S: Into<Kind>>(shapes: impl IntoIterator<Item = S>) -> Self {
        Self { accel: None, parts: shapes.into_iter().map(Part::new).collect() }
    }
}

impl Specification for Compound {
    fn make(&self, context: &mut Context) -> Made {
        if self.parts.is_empty() {
            return Err(Invalid::field("parts", "found none, but a compound has at least one"));
        }
        let parts = self.parts.iter().map(|part| PartData {
            name: &part.name,
            material: part.material.as_deref(),
            shape: &part.shape,
        });
        made(Assembly::build("parts", parts, self.accel, context)?)
    }
}
