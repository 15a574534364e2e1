//! The values of a ray's fields, with the numbers that languages print: `NaN`, `-nan(ind)`, `1e999`.

use std::borrow::Cow;
use std::fmt;
use std::sync::Arc;

use groundtruth::math::{Point, Vector};
use groundtruth::rgb::Rgb;
use serde::de::{Deserialize, Deserializer, Error, SeqAccess, Visitor};
use text::loose::not_finite;

use super::{Id, Purpose};

/// A value, `None` for `null`; or what is wrong.
type Read<T> = Result<Option<T>, String>;

/// A value as it stands in a line.
pub enum Written<'a> {
    Whole(i64),
    Number(f64),
    Text(Cow<'a, str>),
    /// Numbers, of which `null` is none, as JavaScript writes it, and how many.
    List([f64; 3], usize),
}

use Written::{List, Number, Text, Whole};

struct Form;

// an untagged enum would keep a copy of each value
impl<'de> Visitor<'de> for Form {
    type Value = Written<'de>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a number, a text or up to three numbers")
    }

    fn visit_i64<E: Error>(self, x: i64) -> Result<Self::Value, E> {
        Ok(Whole(x))
    }

    fn visit_u64<E: Error>(self, x: u64) -> Result<Self::Value, E> {
        Ok(i64::try_from(x).map_or(Number(x as f64), Whole))
    }

    fn visit_f64<E: Error>(self, x: f64) -> Result<Self::Value, E> {
        Ok(Number(x))
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<Self::Value, E> {
        Ok(Text(Cow::Owned(text.to_owned())))
    }

    fn visit_borrowed_str<E: Error>(self, text: &'de str) -> Result<Self::Value, E> {
        Ok(Text(Cow::Borrowed(text)))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Self::Value, A::Error> {
        let (mut numbers, mut count) = ([f64::NAN; 3], 0);
        while let Some(value) = list.next_element()? {
            let place = numbers.get_mut(count);
            let place = place.ok_or_else(|| A::Error::invalid_length(count + 1, &self))?;
            *place = number(value).map_err(A::Error::custom)?.unwrap_or(f64::NAN);
            count += 1;
        }
        Ok(List(numbers, count))
    }
}

impl<'de> Deserialize<'de> for Written<'de> {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        from.deserialize_any(Form)
    }
}

pub fn number(value: Option<Written<'_>>) -> Read<f64> {
    let of = |name: &str| not_finite(name).ok_or(format!("a number is expected, not `{name}`"));
    Ok(match value {
        None => None,
        Some(Whole(x)) => Some(x as f64),
        Some(Number(x)) => Some(x),
        Some(Text(name)) => Some(of(&name)?),
        Some(List(..)) => return Err("a number is expected".to_owned()),
    })
}

fn three(value: Option<Written<'_>>) -> Read<[f64; 3]> {
    match value {
        None => Ok(None),
        Some(List(numbers, 3)) => Ok(Some(numbers)),
        Some(_) => Err("three numbers are expected".to_owned()),
    }
}

pub fn point(value: Option<Written<'_>>) -> Read<Point> {
    Ok(three(value)?.map(Point::from))
}

pub fn vector(value: Option<Written<'_>>) -> Read<Vector> {
    Ok(three(value)?.map(Vector::from))
}

pub fn color(value: Option<Written<'_>>) -> Read<Rgb> {
    match value {
        Some(List(..)) => Ok(three(value)?.map(Rgb::from)),
        grey => Ok(number(grey)?.map(Rgb::grey)),
    }
}

pub fn pair(value: Option<Written<'_>>) -> Read<[f64; 2]> {
    match value {
        None => Ok(None),
        Some(List([x, y, _], 2)) => Ok(Some([x, y])),
        Some(_) => Err("two numbers are expected".to_owned()),
    }
}

pub fn count(value: Option<Written<'_>>) -> Read<u32> {
    number(value)?.map(whole).transpose()
}

pub fn pixel(value: Option<Written<'_>>) -> Read<[u32; 2]> {
    pair(value)?.map(|[x, y]| Ok([whole(x)?, whole(y)?])).transpose()
}

pub fn truth(value: Option<bool>) -> Read<bool> {
    Ok(value)
}

pub fn id(value: Option<Written<'_>>) -> Read<Id> {
    Ok(match value {
        Some(Whole(number)) => Some(Id::Number(number)),
        // JavaScript may print 3 as 3.0
        Some(Number(x)) if x.fract() == 0.0 && x.abs() < 1e15 => Some(Id::Number(x as i64)),
        other => name(other)?.map(Id::Text),
    })
}

/// A number is a name, too.
pub fn name(value: Option<Written<'_>>) -> Read<Arc<str>> {
    Ok(match value {
        None => None,
        Some(Text(text)) => Some(text.into()),
        Some(Whole(x)) => Some(x.to_string().into()),
        Some(Number(x)) => Some(x.to_string().into()),
        Some(List(..)) => return Err("a text or a number is expected".to_owned()),
    })
}

pub fn kind(value: Option<Written<'_>>) -> Read<Purpose> {
    match value {
        Some(Text(word)) => Ok(Some(Purpose::of(&word))),
        other => Ok(name(other)?.map(|word| Purpose::of(&word))),
    }
}

fn whole(x: f64) -> Result<u32, String> {
    let is_whole = x.fract() == 0.0 && (0.0..=f64::from(u32::MAX)).contains(&x);
    is_whole.then_some(x as u32).ok_or_else(|| format!("a whole number is expected, not {x}"))
}
