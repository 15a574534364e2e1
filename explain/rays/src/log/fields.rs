//! The fields of a line: their names, their short names, and the numbers that languages print.

use std::borrow::Cow;
use std::fmt;
use std::sync::Arc;

use groundtruth::math::{Point, Vector};
use groundtruth::rgb::Rgb;
use serde::de::{self, Deserialize, Deserializer, IgnoredAny, MapAccess, SeqAccess, Visitor};
use serde_json::{Map, Value};

use super::{Id, Purpose, Ray};
use text::loose::not_finite;

/// A line of a log: which of its records it is follows from the names of its fields.
#[derive(Debug, Default)]
pub(super) struct Line {
    pub ray: Ray,
    pub has_origin: bool,
    pub has_direction: bool,
}

/// A number; those that are not finite stand in quotes, or are `null` in a list, as JavaScript writes them.
struct Number(f64);

struct Triple([f64; 3]);

/// One number for all channels, or three.
struct Color(Rgb);

impl<'de> Deserialize<'de> for Number {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Numbers;
        impl Visitor<'_> for Numbers {
            type Value = f64;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a number")
            }
            fn visit_f64<E>(self, x: f64) -> Result<f64, E> {
                Ok(x)
            }
            fn visit_i64<E>(self, x: i64) -> Result<f64, E> {
                Ok(x as f64)
            }
            fn visit_u64<E>(self, x: u64) -> Result<f64, E> {
                Ok(x as f64)
            }
            fn visit_unit<E>(self) -> Result<f64, E> {
                Ok(f64::NAN)
            }
            fn visit_str<E: de::Error>(self, word: &str) -> Result<f64, E> {
                not_finite(word)
                    .ok_or_else(|| E::invalid_type(de::Unexpected::Str(word), &"a number"))
            }
        }
        deserializer.deserialize_any(Numbers).map(Self)
    }
}

impl<'de> Deserialize<'de> for Triple {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let [x, y, z] = <[Number; 3]>::deserialize(deserializer)?;
        Ok(Self([x.0, y.0, z.0]))
    }
}

impl<'de> Deserialize<'de> for Color {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Colors;
        impl<'de> Visitor<'de> for Colors {
            type Value = Rgb;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a number, or three for red, green and blue")
            }
            fn visit_f64<E>(self, x: f64) -> Result<Rgb, E> {
                Ok(Rgb::grey(x))
            }
            fn visit_i64<E>(self, x: i64) -> Result<Rgb, E> {
                Ok(Rgb::grey(x as f64))
            }
            fn visit_u64<E>(self, x: u64) -> Result<Rgb, E> {
                Ok(Rgb::grey(x as f64))
            }
            fn visit_str<E: de::Error>(self, word: &str) -> Result<Rgb, E> {
                let x = not_finite(word);
                x.map(Rgb::grey).ok_or_else(|| E::invalid_type(de::Unexpected::Str(word), &self))
            }
            fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Rgb, A::Error> {
                let mut next = |at| {
                    list.next_element::<Number>()?
                        .ok_or_else(|| de::Error::invalid_length(at, &"three numbers"))
                };
                let [r, g, b] = [next(0)?.0, next(1)?.0, next(2)?.0];
                match list.next_element::<IgnoredAny>()? {
                    None => Ok(Rgb::new(r, g, b)),
                    Some(_) => Err(de::Error::invalid_length(4, &"three numbers")),
                }
            }
        }
        deserializer.deserialize_any(Colors).map(Self)
    }
}

impl<'de> Deserialize<'de> for Id {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Ids;
        impl Visitor<'_> for Ids {
            type Value = Id;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a number or a text")
            }
            fn visit_i64<E>(self, x: i64) -> Result<Id, E> {
                Ok(Id::Number(x))
            }
            fn visit_u64<E>(self, x: u64) -> Result<Id, E> {
                Ok(i64::try_from(x).map_or_else(|_| Id::Text(x.to_string().into()), Id::Number))
            }
            fn visit_f64<E>(self, x: f64) -> Result<Id, E> {
                let is_whole = x.fract() == 0.0 && x.abs() < 1e15;
                Ok(if is_whole { Id::Number(x as i64) } else { Id::Text(x.to_string().into()) })
            }
            fn visit_str<E>(self, word: &str) -> Result<Id, E> {
                Ok(Id::Text(word.into()))
            }
        }
        deserializer.deserialize_any(Ids)
    }
}

impl fmt::Display for Id {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number(number) => write!(f, "{number}"),
            Self::Text(text) => f.write_str(text),
        }
    }
}

impl<'de> Deserialize<'de> for Line {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Lines;
        impl<'de> Visitor<'de> for Lines {
            type Value = Line;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("an object with the fields of a ray")
            }
            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Line, A::Error> {
                let mut line = Line::default();
                while let Some(name) = map.next_key::<Cow<'_, str>>()? {
                    line.read(&name, &mut map)
                        .map_err(|e| de::Error::custom(format!("`{name}`: {e}")))?;
                }
                Ok(line)
            }
        }
        deserializer.deserialize_map(Lines)
    }
}

impl Line {
    /// Reads the value of the field of this name; `null` is as if it were absent.
    fn read<'de, A: MapAccess<'de>>(&mut self, name: &str, map: &mut A) -> Result<(), A::Error> {
        let Self { ray, has_origin, has_direction } = self;
        let factors = &mut ray.factors;
        match name {
            "origin" | "o" => {
                ray.origin = Point::from(map.next_value::<Triple>()?.0);
                *has_origin = true;
            }
            "direction" | "d" | "dir" => {
                ray.direction = Vector::from(map.next_value::<Triple>()?.0);
                *has_direction = true;
            }
            "pixel" => ray.pixel = map.next_value()?,
            "sample" => ray.sample = map.next_value::<Option<u32>>()?.unwrap_or(0),
            "ray" | "id" => ray.id = map.next_value()?,
            "parent" => ray.parent = map.next_value()?,
            "kind" | "type" => {
                let word = map.next_value::<Option<Cow<'_, str>>>()?;
                ray.kind = word.map(|word| Purpose::of(&word));
            }
            "t" => ray.t = number(map)?,
            "end" | "tmax" => ray.end = number(map)?,
            "point" | "p" => ray.point = triple(map)?.map(Point::from),
            "object" | "obj" | "by" => ray.object = text(map)?,
            "light" => ray.light = text(map)?,
            "normal" | "n" => ray.normal = triple(map)?.map(Vector::from),
            "shading_normal" | "ns" => ray.shading_normal = triple(map)?.map(Vector::from),
            "uv" => ray.uv = map.next_value::<Option<[Number; 2]>>()?.map(|[u, v]| [u.0, v.0]),
            "front" => ray.front = map.next_value()?,
            "eta" => factors.eta = number(map)?,
            "eta_from" => factors.eta_from = number(map)?,
            "eta_to" => factors.eta_to = number(map)?,
            "f" => factors.f = color(map)?,
            "cos" => factors.cos = number(map)?,
            "pdf" => factors.pdf = number(map)?,
            "pdf_area" => factors.pdf_area = number(map)?,
            "other_pdf" => factors.other_pdf = number(map)?,
            "choice" => factors.choice = number(map)?,
            "mis" => factors.mis = number(map)?,
            "weight" | "w" => factors.weight = color(map)?,
            "throughput" => factors.throughput = color(map)?,
            "emitted" => ray.emitted = color(map)?,
            "direct" => ray.direct = color(map)?,
            "radiance" | "L" => ray.radiance = color(map)?,
            "values" => match map.next_value()? {
                Value::Object(values) => ray.others.extend(values),
                other => drop(ray.others.insert(name.to_owned(), other)),
            },
            _ => drop(ray.others.insert(name.to_owned(), map.next_value()?)),
        }
        Ok(())
    }

    /// The other fields, when the line turns out to be no ray; `object` among them.
    pub fn into_others(self) -> (Option<Arc<str>>, Map<String, Value>) {
        (self.ray.object, self.ray.others)
    }
}

fn number<'de, A: MapAccess<'de>>(map: &mut A) -> Result<Option<f64>, A::Error> {
    Ok(map.next_value::<Option<Number>>()?.map(|x| x.0))
}

fn triple<'de, A: MapAccess<'de>>(map: &mut A) -> Result<Option<[f64; 3]>, A::Error> {
    Ok(map.next_value::<Option<Triple>>()?.map(|x| x.0))
}

fn color<'de, A: MapAccess<'de>>(map: &mut A) -> Result<Option<Rgb>, A::Error> {
    Ok(map.next_value::<Option<Color>>()?.map(|x| x.0))
}

/// A name; a number is a name, too.
fn text<'de, A: MapAccess<'de>>(map: &mut A) -> Result<Option<Arc<str>>, A::Error> {
    Ok(map.next_value::<Option<Id>>()?.map(|id| id.to_string().into()))
}
