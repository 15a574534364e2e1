//! Errors of input values: their path, what was found, and what would fit.

use std::fmt;

use crate::math::{Normal, Point, Vector};
use formats::printable;

use crate::similar;

/// A value that does not fit. `path` grows from the inside out while the error travels up.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{}{}", path_text(path), printable::text(problem))]
pub struct Invalid {
    /// The keys and indices that lead to the value, outermost first.
    pub path: Vec<Key>,
    /// What was found and what would fit, as a sentence.
    pub problem: String,
}

/// One step of a path into a scene.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Key {
    /// A field of a table.
    Field(String),
    /// An element of a list, with its name if it has one.
    Item(usize, Option<String>),
}

impl From<&str> for Key {
    fn from(field: &str) -> Self {
        Key::Field(field.to_owned())
    }
}

impl From<usize> for Key {
    fn from(index: usize) -> Self {
        Key::Item(index, None)
    }
}

/// The most steps of a path in a message.
const SHOWN: usize = 16;

/// The path and a colon; nothing for the thing as a whole.
fn path_text(path: &[Key]) -> String {
    use fmt::Write;

    use printable::name;
    let mut text = String::new();
    for (depth, key) in path.iter().enumerate() {
        if path.len() > SHOWN && (SHOWN - 2..path.len() - 2).contains(&depth) {
            if !text.ends_with('…') {
                text.push('…');
            }
            continue;
        }
        let _ = match key {
            Key::Field(field) if text.is_empty() => write!(text, "{}", name(field)),
            Key::Field(field) if text.ends_with('"') => write!(text, ", {}", name(field)),
            Key::Field(field) => write!(text, ".{}", name(field)),
            Key::Item(index, None) => write!(text, "[{index}]"),
            Key::Item(index, Some(item)) => write!(text, "[{index}] \"{}\"", name(item)),
        };
    }
    if !text.is_empty() {
        text.push_str(": ");
    }
    text
}

impl Invalid {
    /// The value itself does not fit.
    pub fn new(problem: impl Into<String>) -> Self {
        Self { path: Vec::new(), problem: problem.into() }
    }

    /// The field of this name does not fit.
    pub fn field(name: &str, problem: impl Into<String>) -> Self {
        Self::new(problem).inside(name)
    }

    /// The same problem with a path that starts one level further out.
    pub fn inside(mut self, key: impl Into<Key>) -> Self {
        self.path.insert(0, key.into());
        self
    }
}

/// Plain data of a scene file: its fields' types say their ranges, and `#[kind]` checks them.
pub trait Ranges {
    /// Whether each field is in its range.
    ///
    /// # Errors
    /// Names the first field that is not.
    fn check_ranges(&self) -> Result<(), Invalid>;
}

/// A number as people write it: without three hundred digits.
pub fn shown(value: f64) -> String {
    let plain = value == 0.0 || (1e-6..1e16).contains(&value.abs());
    if plain || !value.is_finite() { format!("{value}") } else { format!("{value:e}") }
}

/// `value`, if it is finite.
pub fn finite(field: &str, value: f64) -> Result<f64, Invalid> {
    if value.is_finite() {
        return Ok(value);
    }
    Err(Invalid::field(field, format!("found {}, but a finite number is needed", shown(value))))
}

/// `value`, if it is finite and above zero.
pub fn positive(field: &str, value: f64) -> Result<f64, Invalid> {
    if value.is_finite() && value > 0.0 {
        return Ok(value);
    }
    Err(Invalid::field(
        field,
        format!("found {}, but a positive, finite number is needed", shown(value)),
    ))
}

/// The lengths that shapes are made for: from Planck's to far beyond the universe's, in metres.
/// Within it no square of a square leaves the range of `f64`, not even where an instance of one end
/// of it stands in a scene of the other; beyond, hits would be lost.
pub const LENGTHS: std::ops::RangeInclusive<f64> = 1e-40..=1e40;

/// `value`, if it is one of the [`LENGTHS`].
pub fn length(field: &str, value: f64) -> Result<f64, Invalid> {
    positive(field, value)?;
    if LENGTHS.contains(&value) {
        return Ok(value);
    }
    Err(Invalid::field(field, format!("found {}, but {}", shown(value), lengths())))
}

/// The most instances, lattices and compounds nested in one another: far more than in any scene.
/// The text readers allow that many; their limit is 80 nested tables and lists.
pub const MAX_NESTING: usize = 16;

/// What lengths there may be, as the end of a sentence.
pub(crate) fn lengths() -> String {
    let [least, most] = [LENGTHS.start(), LENGTHS.end()].map(|&length| shown(length));
    format!("only lengths from {least} to {most} are supported")
}

/// `value`, if it is finite and not negative.
pub fn not_negative(field: &str, value: f64) -> Result<f64, Invalid> {
    if value.is_finite() && value >= 0.0 {
        return Ok(value);
    }
    Err(Invalid::field(
        field,
        format!("found {}, but a finite number of at least 0 is needed", shown(value)),
    ))
}

/// The largest channel of a colour and the largest factor of one: their products stay far from the
/// largest number also in a scene that is scaled by 2³⁰. Picture files store what is beyond `f32`
/// as its largest number.
pub const BRIGHTEST: f64 = 1e30;

/// `value`, if it can be a share or strength of light: from 0 to [`BRIGHTEST`].
pub fn strength(field: &str, value: f64) -> Result<f64, Invalid> {
    if not_negative(field, value)? <= BRIGHTEST {
        return Ok(value);
    }
    let problem = format!("found {}, but at most {} fits", shown(value), shown(BRIGHTEST));
    Err(Invalid::field(field, problem))
}

/// `value`, if it lies in this range.
pub fn within(
    field: &str,
    value: f64,
    range: std::ops::RangeInclusive<f64>,
) -> Result<f64, Invalid> {
    if range.contains(&value) {
        return Ok(value);
    }
    let [least, most] = [range.start(), range.end()].map(|&end| shown(end));
    Err(Invalid::field(field, format!("found {}, but {least} to {most} fit", shown(value))))
}

/// `value`, if it is a part of a whole.
pub fn share(field: &str, value: f64) -> Result<f64, Invalid> {
    within(field, value, 0.0..=1.0)
}

/// The indices of refraction of media. Fresnel's equations and the change of radiance square the
/// ratio of two: 1e40 at most, far from the ends of `f64`.
const INDICES: std::ops::RangeInclusive<f64> = 1e-10..=1e10;

/// `eta`, if it can be the index of a medium.
pub fn index(field: &str, eta: f64) -> Result<f64, Invalid> {
    positive(field, eta)?;
    within(field, eta, INDICES)
}

/// `eta`, if the media on both sides of a surface can have this ratio of indices.
pub fn index_ratio(field: &str, eta: f64) -> Result<f64, Invalid> {
    positive(field, eta)?;
    within(field, eta, 1e-20..=1e20) // two of `INDICES` divided
}

/// `value`, if it is an angle above 0° and at most `most`.
pub fn angle(field: &str, value: f64, most: f64) -> Result<f64, Invalid> {
    if value > 0.0 && value <= most {
        return Ok(value);
    }
    let problem = format!("found {}, but more than 0 and at most {most} degrees fit", shown(value));
    Err(Invalid::field(field, problem))
}

/// `value`, if it is an angle above 0° and below `limit`.
pub fn angle_below(field: &str, value: f64, limit: f64) -> Result<f64, Invalid> {
    if value > 0.0 && value < limit {
        return Ok(value);
    }
    let problem =
        format!("found {}, but more than 0 and less than {limit} degrees fit", shown(value));
    Err(Invalid::field(field, problem))
}

/// `p`, if its coordinates are finite.
pub fn finite_point(field: &str, p: Point) -> Result<Point, Invalid> {
    if p.is_finite() {
        return Ok(p);
    }
    Err(Invalid::field(
        field,
        format!("found {:?}, but finite coordinates are needed", p.to_array()),
    ))
}

/// `v`, if its components are finite.
pub fn finite_vector(field: &str, v: Vector) -> Result<Vector, Invalid> {
    finite_point(field, Point::ORIGIN + v)?;
    Ok(v)
}

/// The unit vector along `v`, which must be finite and not zero.
pub fn direction(field: &str, v: Vector) -> Result<Normal, Invalid> {
    Normal::new(v).ok_or_else(|| {
        let found = v.to_array();
        Invalid::field(
            field,
            format!("found {found:?}, but a finite vector other than zero is needed"),
        )
    })
}

/// The message of a text reader with the names short that it quotes by backticks.
fn with_short_names(message: &str) -> String {
    let parts = message.split('`').enumerate();
    let parts: Vec<String> = parts
        .map(|(i, part)| if i % 2 == 1 { printable::name(part) } else { part.to_owned() })
        .collect();
    parts.join("`")
}

/// The message of a text reader about an unknown field or kind: with similar names, or else with
/// all.
fn of_unknown(message: &str) -> Option<String> {
    let variant = message.strip_prefix("unknown variant `").map(|rest| ("kind", rest));
    let unknown = || message.strip_prefix("unknown field `").map(|rest| ("field", rest));
    let (what, rest) = variant.or_else(unknown)?;
    let (found, expected) = rest.split_once("`, expected ")?;
    let known: Vec<&str> = expected.split('`').skip(1).step_by(2).collect();
    Some(match similar::did_you_mean(found, &known) {
        none if none.is_empty() => format!("unknown {what} `{found}`, expected {expected}"),
        hint => format!("unknown {what} `{found}`{hint}"),
    })
}

/// For a number such as `1000.0` in the start of a message, how it is written as a whole one.
fn whole_number_in(start: &str) -> String {
    let found = start.strip_prefix("invalid type: floating point `");
    let found = found.and_then(|rest| rest.split('`').next()?.parse::<f64>().ok());
    match found.filter(|n| n.fract() == 0.0 && (0.0..=f64::from(u32::MAX)).contains(n)) {
        Some(number) => format!("; write {number}"),
        None => String::new(),
    }
}

/// What to write for a path of Windows.
pub(crate) const BACKSLASH: &str = r"in double quotes a backslash begins an escape; write the path in single quotes, as 'C:\meshes\bunny.ply', or with /";

/// What [`plain_words`] says where a whole number of 32 bits is needed.
pub const WHOLE_NUMBER: &str = "expected a whole number from 0 to 4294967295";

/// What [`plain_words`] says of a kind that is written as a string.
pub const NEEDS_TABLE: &str = "a kind needs a table of fields, as `kind = { … }`; it may be empty";

/// The message of a text reader, in words for a user who does not know Rust.
pub fn plain_words(message: &str) -> String {
    let message = with_short_names(&message.replace('\n', "; "));
    if let Some(plain) = of_unknown(&message) {
        return plain;
    }
    let message = message.replacen("invalid type: map,", "invalid type: table,", 1);
    let message = message.replacen("invalid type: sequence,", "invalid type: list,", 1);
    for (technical, plain) in [
        ("expected u32", WHOLE_NUMBER),
        ("expected f64", "expected a number"),
        ("expected u64", "expected a whole number that is not negative"),
        ("expected a sequence", "expected a list"),
    ] {
        if let Some(start) = message.strip_suffix(technical) {
            let advice =
                if plain.contains("whole") { whole_number_in(start) } else { String::new() };
            return format!("{start}{plain}{advice}");
        }
    }
    if message.contains("recursion limit") || message.contains("max recursion depth") {
        return format!(
            "nested too deeply (at most 80 tables and lists fit in one another, and {MAX_NESTING} shapes)"
        );
    }
    if message.starts_with("wanted exactly 1 element") {
        return "exactly one kind is needed here, as `kind = { … }`".to_owned();
    }
    if message == "invalid type: unit variant, expected newtype variant" {
        return NEEDS_TABLE.to_owned();
    }
    if message == "wanted string or table" {
        return "a kind is needed here, as `kind = { … }`".to_owned();
    }
    message
}
