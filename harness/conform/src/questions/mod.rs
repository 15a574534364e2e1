//! Questions whose answers are held against our own: one file for each chapter's subject.

pub mod cameras;
pub mod meshes;
pub mod optics;
pub mod sampling;
pub mod spaces;
pub mod surfaces;

pub use optics::outside;

use serde_json::{Value, json};

use super::mistakes::Mistake;

/// A mistake that is another question: turns the question into it, if it applies.
pub type AsQuestion = (&'static Mistake, fn(&mut Value) -> Option<()>);
/// A mistake that is another value of a field: from question, field name and our answer.
pub type AsAnswer = (&'static Mistake, fn(&Value, &str, &Value) -> Option<Vec<f64>>);

/// The mistakes that people make in answers to one question of the probe.
#[derive(Clone, Copy)]
pub struct Mistakes {
    /// Those that are another question: what our function answers to it is what they would.
    pub questions: &'static [AsQuestion],
    /// Those that are another value of a field.
    pub answers: &'static [AsAnswer],
}

/// Those of the question of this name that no edit of the file of mistakes says.
pub fn mistakes(question: &str) -> &'static Mistakes {
    match question {
        "camera_ray" => &cameras::CAMERA_RAY,
        "fresnel" => &optics::FRESNEL,
        "intersect" => &meshes::MESH,
        "lobe" => &optics::LOBE,
        "map" => &sampling::MAP,
        "mapping" => &surfaces::MAPPING,
        "texture" => &surfaces::TEXTURE,
        "transform" => &spaces::TRANSFORM,
        _ => &Mistakes { questions: &[], answers: &[] },
    }
}

/// A number with few digits, so that it can be read.
pub fn round(x: f64) -> f64 {
    (x * 1024.0).round() / 1024.0
}

/// The data of a question, to be changed.
fn data(question: &mut Value) -> Option<&mut Value> {
    question.as_object_mut()?.values_mut().next()
}

/// Changes a number.
fn change(data: &mut Value, pointer: &str, by: impl Fn(f64) -> f64) -> Option<()> {
    let slot = data.pointer_mut(pointer)?;
    *slot = json!(by(slot.as_f64()?));
    Some(())
}

/// Removes a field.
pub fn remove(data: &mut Value, field: &str) -> Option<()> {
    data.as_object_mut()?.remove(field).map(|_| ())
}

/// The only field of an object: the data of a kind.
pub fn only(kind: &mut Value) -> Option<&mut Value> {
    kind.as_object_mut()?.values_mut().next()
}
