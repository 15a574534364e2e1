//! The values of a ray's fields, with the numbers that languages print: `NaN`, `-nan(ind)`, `1e999`.

use std::borrow::Cow;
use std::sync::Arc;

use groundtruth::math::{Point, Vector};
use groundtruth::rgb::Rgb;
use serde::Deserialize;
use text::loose::not_finite;

use super::{Id, Purpose};

/// A value, `None` for `null`; or what is wrong.
type Read<T> = Result<Option<T>, String>;

#[derive(Deserialize)]
#[serde(untagged, expecting = "a number is expected")]
pub enum Number<'a> {
    Finite(f64),
    Named(#[serde(borrow)] Cow<'a, str>),
}

/// A list of numbers, of which `null` is none, as JavaScript writes it.
type Numbers<'a, const N: usize> = [Option<Number<'a>>; N];

#[derive(Deserialize)]
#[serde(untagged, expecting = "a number or three are expected")]
pub enum Color<'a> {
    #[serde(borrow)]
    Channels(Numbers<'a, 3>),
    All(Number<'a>),
}

#[derive(Deserialize)]
#[serde(untagged, expecting = "a text or a number is expected")]
pub enum Word<'a> {
    Text(#[serde(borrow)] Cow<'a, str>),
    Whole(i64),
    Number(f64),
}

pub fn number(value: Option<Number<'_>>) -> Read<f64> {
    let of = |name: &str| not_finite(name).ok_or(format!("a number is expected, not `{name}`"));
    Ok(match value {
        None => None,
        Some(Number::Finite(x)) => Some(x),
        Some(Number::Named(name)) => Some(of(&name)?),
    })
}

fn list<const N: usize>(values: Numbers<'_, N>) -> Result<[f64; N], String> {
    let mut numbers = [f64::NAN; N];
    for (place, value) in numbers.iter_mut().zip(values) {
        *place = number(value)?.unwrap_or(f64::NAN);
    }
    Ok(numbers)
}

pub fn point(value: Option<Numbers<'_, 3>>) -> Read<Point> {
    Ok(value.map(list).transpose()?.map(Point::from))
}

pub fn vector(value: Option<Numbers<'_, 3>>) -> Read<Vector> {
    Ok(value.map(list).transpose()?.map(Vector::from))
}

pub fn pair(value: Option<Numbers<'_, 2>>) -> Read<[f64; 2]> {
    value.map(list).transpose()
}

pub fn color(value: Option<Color<'_>>) -> Read<Rgb> {
    match value {
        Some(Color::Channels(channels)) => Ok(Some(Rgb::from(list(channels)?))),
        Some(Color::All(grey)) => Ok(number(Some(grey))?.map(Rgb::grey)),
        None => Ok(None),
    }
}

pub fn count(value: Option<Number<'_>>) -> Read<u32> {
    number(value)?.map(whole).transpose()
}

pub fn pixel(value: Option<Numbers<'_, 2>>) -> Read<[u32; 2]> {
    pair(value)?.map(|[x, y]| Ok([whole(x)?, whole(y)?])).transpose()
}

pub fn truth(value: Option<bool>) -> Read<bool> {
    Ok(value)
}

pub fn id(value: Option<Word<'_>>) -> Read<Id> {
    Ok(value.map(|word| match word {
        Word::Whole(number) => Id::Number(number),
        // JavaScript may print 3 as 3.0
        Word::Number(x) if x.fract() == 0.0 && x.abs() < 1e15 => Id::Number(x as i64),
        other => Id::Text(other.text()),
    }))
}

/// A number is a name, too.
pub fn name(value: Option<Word<'_>>) -> Read<Arc<str>> {
    Ok(value.map(Word::text))
}

pub fn kind(value: Option<Word<'_>>) -> Read<Purpose> {
    Ok(value.map(|word| Purpose::of(&word.text())))
}

impl Word<'_> {
    fn text(self) -> Arc<str> {
        match self {
            Self::Text(text) => text.into(),
            Self::Whole(x) => x.to_string().into(),
            Self::Number(x) => x.to_string().into(),
        }
    }
}

fn whole(x: f64) -> Result<u32, String> {
    let is_whole = x.fract() == 0.0 && (0.0..=f64::from(u32::MAX)).contains(&x);
    is_whole.then_some(x as u32).ok_or_else(|| format!("a whole number is expected, not {x}"))
}
