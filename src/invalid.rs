//! Errors of input values: their path, what was found, and what would fit.

use std::fmt;

use crate::math::{Normal, Point, Vector};
use formats::printable;

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

/// What to write for a path of Windows.
pub const BACKSLASH: &str = r"in double quotes a backslash begins an escape; write the path in single quotes, as 'C:\meshes\bunny.ply', or with /";
