//! The fields of a ray's line: their names, what they mean, and where their values go.

use std::borrow::Cow;
use std::fmt;

use groundtruth::math::{Point, Vector};
use serde::de::{Deserializer, Error, MapAccess, Visitor};
use serde_json::Value;
use text::loose::quoted;

use super::{Purpose, Ray, value};

/// A field of a ray's line.
#[derive(Clone, Copy, Debug)]
pub struct Field {
    /// Its name, and the short ones.
    pub names: &'static [&'static str],
    /// `number`, `point`, `vector`, `color` …: what its value is.
    pub form: &'static str,
    /// What it says.
    pub means: &'static str,
}

#[derive(Default)]
struct Line {
    ray: Ray,
    origin: Option<Point>,
    direction: Option<Vector>,
    sample: Option<u32>,
}

macro_rules! fields {
    ($($first:literal $(| $other:literal)*: $form:ident $($place:ident).+, $means:literal;)*) => {
        impl Line {
            /// Reads the value of the field of this name, if it is one of a ray.
            fn read<'de, A: MapAccess<'de>>(&mut self, name: &str, map: &mut A) -> Result<bool, A::Error> {
                match name {
                    $($first $(| $other)* => {
                        self.$($place).+ = value::$form(map.next_value()?).map_err(A::Error::custom)?;
                    })*
                    _ => return Ok(false),
                }
                Ok(true)
            }
        }

        /// All fields of a ray.
        pub const FIELDS: &[Field] = &[$(
            Field { names: &[$first $(, $other)*], form: stringify!($form), means: $means },
        )*];
    };
}

fields! {
    "origin" | "o": point origin, "where the ray starts";
    "direction" | "d" | "dir": vector direction, "where it goes, of any length";
    "pixel": pixel ray.pixel, "column and row of its pixel, from 0 at the top left";
    "sample": count sample, "the sample of the pixel";
    "ray" | "id": id ray.id, "what the log calls it, once in its sample";
    "parent": id ray.parent, "what the log calls the ray that sent it";
    "kind" | "type": kind ray.kind, "its purpose: camera, reflected, transmitted, diffuse, glossy, path, shadow, occlusion, or any other word";
    "t": number ray.t, "where it ended, or a shadow ray was blocked; null: it hit nothing";
    "end" | "tmax": number ray.end, "of a shadow ray: how far the lamp is, as t";
    "point" | "p": point ray.point, "where it ended";
    "object" | "obj" | "by": name ray.object, "what it hit, or what blocked it";
    "light": name ray.light, "the lamp that it was aimed at";
    "normal" | "n": vector ray.normal, "the normal at its hit";
    "shading_normal" | "ns": vector ray.shading_normal, "the normal that shading uses there";
    "uv": pair ray.uv, "texture coordinates there";
    "front": truth ray.front, "whether it met the side that the normal points to";
    "eta": number ray.factors.eta, "the ratio of the indices of refraction, in either order";
    "eta_from": number ray.factors.eta_from, "the index of the medium that it comes from";
    "eta_to": number ray.factors.eta_to, "the index of the medium that it enters";
    "f": color ray.factors.f, "the value of the BRDF, per steradian";
    "cos": number ray.factors.cos, "the cosine to the normal";
    "pdf": number ray.factors.pdf, "the density of its direction, per steradian";
    "pdf_area": number ray.factors.pdf_area, "the density per area of the lamp";
    "other_pdf": number ray.factors.other_pdf, "the density with which the other way draws this direction, per steradian";
    "choice": number ray.factors.choice, "the probability of having been chosen: lobe, lamp, roulette";
    "mis": number ray.factors.mis, "the MIS weight";
    "weight" | "w": color ray.factors.weight, "all factors, as multiplied";
    "throughput": color ray.factors.throughput, "the product of the weights from the camera to it";
    "emitted": color ray.emitted, "emitted at its hit, towards its origin";
    "direct": color ray.direct, "added at its hit without another ray that is logged with a weight";
    "radiance" | "L": color ray.radiance, "what it brings back to its origin";
}

#[derive(serde::Deserialize)]
struct Name<'a>(#[serde(borrow)] Cow<'a, str>);

impl<'de> Visitor<'de> for &mut Line {
    type Value = ();

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("an object")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<(), A::Error> {
        while let Some(Name(name)) = map.next_key()? {
            let named = |e: A::Error| A::Error::custom(format!("`{name}`: {e}"));
            if self.read(&name, &mut map).map_err(named)? {
                continue;
            }
            match map.next_value().map_err(named)? {
                Value::Object(values) if name == "values" => self.ray.others.extend(values),
                value => drop(self.ray.others.insert(name.into_owned(), value)),
            }
        }
        Ok(())
    }
}

impl Line {
    fn of(text: &str) -> serde_json::Result<Self> {
        let (mut line, mut json) = (Self::default(), serde_json::Deserializer::from_str(text));
        json.deserialize_map(&mut line)?;
        json.end().map(|()| line)
    }
}

/// The ray that a line describes; `None` if the line is no ray, having neither origin nor direction.
///
/// # Errors
/// What is wrong with the line.
pub(super) fn ray_of(line: &str, number: usize) -> Result<Option<Ray>, String> {
    let read = Line::of(line).or_else(|e| Line::of(&quoted(line)).map_err(|_| e));
    let it = read.map_err(|e| e.to_string().replace(" at line 1 column", " at column"))?;
    let Line { mut ray, origin, direction, sample } = it;
    (ray.line, ray.sample) = (number, sample.unwrap_or(0));
    if ray.kind.is_none() && (ray.light.is_some() || ray.end.is_some()) {
        ray.kind = Some(Purpose::Shadow);
    }
    match (origin, direction) {
        (Some(origin), Some(direction)) => {
            (ray.origin, ray.direction) = (origin, direction);
            Ok(Some(ray))
        }
        (Some(_), None) => Err("the ray has no `direction`".to_owned()),
        (None, Some(_)) => Err("the ray has no `origin`".to_owned()),
        (None, None) => Ok(None),
    }
}
