//! Questions whose answers are held against our own: one file for each chapter's subject.

mod cameras;
pub mod images;
mod instances;
pub mod meshes;
pub mod noise;
pub mod optics;
pub mod sampling;
pub mod spaces;
pub mod surfaces;

use ask::Draw;
pub use cameras::ray_question;
pub use optics::outside;

use serde::Serialize;
use serde_json::{Value, json};

use super::family::{Family, Judge};
use groundtruth::kinds::Entry;

/// All of these families.
pub fn families() -> Vec<Family> {
    let all = [
        optics::families(),
        instances::within_a_turn(),
        surfaces::families(),
        noise::families(),
        cameras::families(),
    ];
    all.into_iter().flatten().collect()
}

/// A family whose cases are drawn one by one.
pub fn family(
    name: &str,
    about: &str,
    chapter: &'static str,
    judge: Judge,
    case: impl Fn(&mut Draw) -> Value + Send + Sync + 'static,
) -> Family {
    let cases = move |seed, n| (0..n).map(|index| case(&mut Draw::case(seed, index))).collect();
    Family {
        name: name.to_owned(),
        about: about.to_owned(),
        chapter,
        ordinary: true,
        share: 1.0,
        cases: Box::new(cases),
        judge,
        namer: None,
        is_shrunk: true,
    }
}

/// Each kind of a list: its tag, its chapter, and the data of its specimens. Those that name a file are left out,
/// because other programs do not have it.
pub fn kinds<Kind: Serialize>(entries: &[Entry<Kind>]) -> Vec<(String, &'static str, Vec<Value>)> {
    let kind = |entry: &Entry<Kind>| {
        let data =
            (entry.specimens)().into_iter().filter_map(|kind| serde_json::to_value(kind).ok());
        let names_no_file = |data: &Value| !data.to_string().contains("\"file\"");
        let data: Vec<Value> = data.filter(names_no_file).collect();
        let tag = data.first()?.as_object()?.keys().next()?.clone();
        Some((tag, entry.chapter, data))
    };
    entries.iter().filter_map(kind).collect()
}

/// One of these.
fn any<'a>(draw: &mut Draw, of: &'a [Value]) -> &'a Value {
    &of[draw.below(of.len())]
}

/// A number with few digits, so that it can be read.
pub fn round(x: f64) -> f64 {
    (x * 1024.0).round() / 1024.0
}

/// A point or vector in the cube of this half-side.
pub fn vector(draw: &mut Draw, half_side: f64) -> Value {
    json!(draw.vector(half_side).to_array().map(round))
}

/// Two numbers of at least 0 and below 1.
pub fn square(draw: &mut Draw) -> Value {
    json!([draw.between(0.0, 1.0), draw.between(0.0, 1.0)])
}

/// The data of a question, to be changed.
fn data(question: &mut Value) -> Option<&mut Value> {
    question.as_object_mut()?.values_mut().next()
}

/// Exchanges two values.
fn swap(data: &mut Value, a: &str, b: &str) -> Option<()> {
    let [x, y] = [a, b].map(|pointer| data.pointer(pointer).cloned());
    let (x, y) = (x?, y?);
    *data.pointer_mut(a)? = y;
    *data.pointer_mut(b)? = x;
    Some(())
}

/// Changes a number.
fn change(data: &mut Value, pointer: &str, by: impl Fn(f64) -> f64) -> Option<()> {
    let slot = data.pointer_mut(pointer)?;
    *slot = json!(by(slot.as_f64()?));
    Some(())
}

/// Removes a field.
fn remove(data: &mut Value, field: &str) -> Option<()> {
    data.as_object_mut()?.remove(field).map(|_| ())
}

/// The only field of an object: the data of a kind.
fn only(kind: &mut Value) -> Option<&mut Value> {
    kind.as_object_mut()?.values_mut().next()
}
