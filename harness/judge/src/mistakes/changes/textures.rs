//! Mistakes of textures (Suffern, ch. 29–31): changes of the tables that describe them. Each may be made in all
//! materials, or in one alone.

use serde_json::{Map, Value, json};

use super::edits::edited;
use crate::mistakes::Mistake;
use crate::mistakes::known::{self, KnownMistake};

/// A change of a table within a material; whether it changed something.
pub type Edit = fn(&mut Map<String, Value>) -> bool;

/// A change of textures.
#[derive(Clone, Copy, Debug)]
pub struct TextureChange {
    /// The mistake that makes it in all materials.
    pub known: &'static KnownMistake,
    /// What it does with a table.
    pub edit: Edit,
}

/// A list of mistakes with the change that each makes.
macro_rules! texture_mistakes {
    ($($known:ident: $edit:path;)*) => {
        /// The changes.
        pub const CHANGES: &[TextureChange] =
            &[$(TextureChange { known: &known::$known, edit: $edit }),*];

        pub(in crate::mistakes) const ALL: &[Mistake] = &[$(
            Mistake::scene(&known::$known, |scene, _| edited(scene, "materials", &$edit))
        ),*];
    };
}

texture_mistakes! {
    TEXTURE_UPSIDE_DOWN: upside_down;
    TEXTURE_MIRRORED: mirrored;
    TEXTURE_TURNED: turned;
    TEXTURE_NEAREST: nearest;
    TEXTURE_BILINEAR: bilinear;
    TEXTURE_OF_OTHER_RULE: other_rule;
    TEXTURE_COLOURS_EXCHANGED: colors_exchanged;
    TEXTURE_OFFSET: offset;
    TEXTURE_SIZE_DOUBLED: size_doubled;
    TEXTURE_SIZE_HALVED: size_halved;
    NO_OUTLINES: without_outlines;
    ONE_OCTAVE_LESS: one_octave_less;
    ONE_OCTAVE_MORE: one_octave_more;
    OCTAVES_WITHOUT_GAIN: without_gain;
    OCTAVES_WITHOUT_LACUNARITY: without_lacunarity;
    NOISE_LINEAR: linear;
}

/// The axis of a mapping along which u runs, or about which it is symmetric, and the same for v.
fn axes(image: &Value) -> Option<[&'static str; 2]> {
    match image.get("mapping").and_then(Value::as_str)? {
        "square" => Some(["z", "x"]),
        "cylindrical" | "spherical" | "light_probe" | "panoramic" => Some(["x", "y"]),
        _ => None,
    }
}

/// Replaces a texture, the only entry of a table, by its instance with these steps.
fn transformed(table: &mut Map<String, Value>, steps: Value) {
    let of = Value::Object(std::mem::take(table));
    table.insert("texture_instance".to_owned(), json!({ "of": of, "transform": steps }));
}

/// The image that is the only entry of a table.
fn image(table: &Map<String, Value>) -> Option<&Value> {
    table.get("image").filter(|_| table.len() == 1)
}

/// Reflects an image on its object so that v becomes 1 − v.
fn upside_down(table: &mut Map<String, Value>) -> bool {
    let Some([_, axis]) = image(table).and_then(axes) else { return false };
    transformed(table, json!([{ "reflect": axis }]));
    true
}

/// The same for u.
fn mirrored(table: &mut Map<String, Value>) -> bool {
    let hemisphere = |image: &Value| {
        image.get("mapping").and_then(Value::as_str).filter(|it| *it == "hemispherical")?;
        Some(["x", "y"])
    };
    let axes = image(table).and_then(|image| axes(image).or_else(|| hemisphere(image)));
    let Some([axis, _]) = axes else { return false };
    transformed(table, json!([{ "reflect": axis }]));
    true
}

fn turned(table: &mut Map<String, Value>) -> bool {
    // without a mapping the texture coordinates are the surface's own
    if image(table).and_then(|image| image.get("mapping")).is_none_or(Value::is_null) {
        return false;
    }
    transformed(table, json!([{ "rotate_y": 90.0 }]));
    true
}

/// Replaces a value by another, if the table has it.
fn replaced(table: &mut Map<String, Value>, key: &str, from: &Value, to: Value) -> bool {
    let is_it = table.get(key) == Some(from);
    if is_it {
        table.insert(key.to_owned(), to);
    }
    is_it
}

fn nearest(table: &mut Map<String, Value>) -> bool {
    replaced(table, "filtering", &json!("bilinear"), json!("nearest"))
}

fn bilinear(table: &mut Map<String, Value>) -> bool {
    replaced(table, "filtering", &json!("nearest"), json!("bilinear"))
}

fn other_rule(table: &mut Map<String, Value>) -> bool {
    let [even, book] = ["even", "book"].map(Value::from);
    table.contains_key("filtering")
        && (replaced(table, "rule", &even, book.clone()) || replaced(table, "rule", &book, even))
}

fn colors_exchanged(table: &mut Map<String, Value>) -> bool {
    let (Some(first), Some(second)) = (table.get("color1"), table.get("color2")) else {
        return false;
    };
    let (first, second) = (first.clone(), second.clone());
    let is_changed = first != second;
    table.insert("color1".to_owned(), second);
    table.insert("color2".to_owned(), first);
    is_changed
}

fn offset(table: &mut Map<String, Value>) -> bool {
    let only = table.values().next().filter(|_| table.len() == 1);
    let is_pattern = |it: &&Value| it.get("color1").is_some() && it.get("noise").is_none();
    let size = only.filter(is_pattern).and_then(|it| it.get("size")?.as_f64());
    let Some(size) = size else { return false };
    transformed(table, json!([{ "translate": [0.5 * size, 0.5 * size, 0.5 * size] }]));
    true
}

/// The number of this key times a factor.
fn scaled(table: &mut Map<String, Value>, key: &str, factor: f64) -> bool {
    let number = table.get(key).and_then(Value::as_f64);
    if let Some(number) = number {
        table.insert(key.to_owned(), (factor * number).into());
    }
    number.is_some_and(|number| number != 0.0)
}

fn size_doubled(table: &mut Map<String, Value>) -> bool {
    scaled(table, "size", 2.0)
}

fn size_halved(table: &mut Map<String, Value>) -> bool {
    scaled(table, "size", 0.5)
}

fn without_outlines(table: &mut Map<String, Value>) -> bool {
    scaled(table, "outline_width", 0.0)
}

/// Adds octaves to noise that has several.
fn octaves(table: &mut Map<String, Value>, more: i64) -> bool {
    let octaves = table.get("octaves").and_then(Value::as_i64).filter(|octaves| *octaves > 1);
    if let Some(octaves) = octaves {
        table.insert("octaves".to_owned(), (octaves + more).into());
    }
    octaves.is_some()
}

fn one_octave_less(table: &mut Map<String, Value>) -> bool {
    octaves(table, -1)
}

fn one_octave_more(table: &mut Map<String, Value>) -> bool {
    octaves(table, 1)
}

/// Noise of several octaves has 1 for this number.
fn one_for(table: &mut Map<String, Value>, key: &str) -> bool {
    let has_several = table.get("octaves").and_then(Value::as_u64).is_some_and(|it| it > 1);
    let is_other = table.get(key).and_then(Value::as_f64).is_some_and(|it| it != 1.0);
    if has_several && is_other {
        table.insert(key.to_owned(), 1.0.into());
    }
    has_several && is_other
}

fn without_gain(table: &mut Map<String, Value>) -> bool {
    one_for(table, "gain")
}

fn without_lacunarity(table: &mut Map<String, Value>) -> bool {
    one_for(table, "lacunarity")
}

fn linear(table: &mut Map<String, Value>) -> bool {
    replaced(table, "interpolation", &json!("cubic"), json!("linear"))
}
