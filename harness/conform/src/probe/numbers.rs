//! Numbers in lines: every finite `f64` exactly, and the infinities by name.

use std::fmt;

use serde::de::{self, Visitor};
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use groundtruth::invalid::{Invalid, direction};
use groundtruth::math::{Point, Ray, Span, UNIT_ROUNDOFF, Vector};
use groundtruth::rgb::Rgb;

/// A number of an answer. JSON has no infinity and no NaN, so these are printed as `"inf"`, `"-inf"` and
/// `"nan"`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Real(pub f64);

impl Serialize for Real {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self.0 {
            x if x.is_finite() => serializer.serialize_f64(x),
            f64::INFINITY => serializer.serialize_str("inf"),
            f64::NEG_INFINITY => serializer.serialize_str("-inf"),
            _ => serializer.serialize_str("nan"),
        }
    }
}

/// Three numbers.
pub type Triple = [Real; 3];

/// The coordinates of a point, vector or normal, or the channels of a colour.
pub fn triple(it: impl Into<[f64; 3]>) -> Triple {
    it.into().map(Real)
}

/// An end of a span: a number, `"inf"` or `"-inf"`.
#[derive(Clone, Copy, Debug)]
struct End(f64);

impl<'de> Deserialize<'de> for End {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(EndVisitor)
    }
}

struct EndVisitor;

impl Visitor<'_> for EndVisitor {
    type Value = End;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a number, \"inf\" or \"-inf\"")
    }

    fn visit_f64<E: de::Error>(self, end: f64) -> Result<End, E> {
        Ok(End(end))
    }

    fn visit_i64<E: de::Error>(self, end: i64) -> Result<End, E> {
        Ok(End(end as f64))
    }

    fn visit_u64<E: de::Error>(self, end: u64) -> Result<End, E> {
        Ok(End(end as f64))
    }

    fn visit_str<E: de::Error>(self, name: &str) -> Result<End, E> {
        match name {
            "inf" => Ok(End(f64::INFINITY)),
            "-inf" => Ok(End(f64::NEG_INFINITY)),
            _ => Err(E::invalid_value(de::Unexpected::Str(name), &self)),
        }
    }
}

/// The lengths allowed for directions: outside this range their squares lose digits or overflow.
const DIRECTIONS: std::ops::RangeInclusive<f64> = 1e-100..=1e100;

/// A ray as a line says it.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RayData {
    origin: Point,
    direction: Vector,
}

impl RayData {
    /// The ray, its direction as it is: `t` counts in it.
    pub fn ray(&self) -> Result<Ray, Invalid> {
        direction("direction", self.direction).map_err(|e| e.inside("ray"))?;
        let largest = self.direction.max_abs();
        if DIRECTIONS.contains(&largest) {
            return Ok(Ray::new(self.origin, self.direction));
        }
        let [least, most] = [DIRECTIONS.start(), DIRECTIONS.end()];
        let problem = format!(
            "found {:?}, but its largest coordinate has to be from {least:e} to {most:e} in size: its \
             square has to be a number",
            self.direction.to_array()
        );
        Err(Invalid::field("direction", problem).inside("ray"))
    }

    /// The ray, its direction made unit.
    pub fn unit_ray(&self) -> Result<Ray, Invalid> {
        let direction = unit("direction", self.direction).map_err(|e| e.inside("ray"))?;
        Ok(Ray::new(self.origin, direction))
    }
}

/// An open interval of `t` as a line says it.
#[derive(Clone, Copy, Debug, Deserialize)]
pub struct SpanData([End; 2]);

impl SpanData {
    /// The span of a line, or all that is ahead.
    pub fn span(it: Option<Self>) -> Result<Span, Invalid> {
        let Some(Self([End(min), End(max)])) = it else { return Ok(Span::AHEAD) };
        if min < max {
            return Ok(Span { min, max });
        }
        let problem = format!("found [{min}, {max}], but the first must be below the second");
        Err(Invalid::field("span", problem))
    }
}

/// The unit vector along `v`; one that is unit up to rounding is left as it is, bit for bit.
pub fn unit(field: &str, v: Vector) -> Result<Vector, Invalid> {
    let unit = direction(field, v)?;
    // a unit vector's square is off by its three rounded components and the sum: below 8u
    let is_unit = (v.length_squared() - 1.0).abs() <= 8.0 * UNIT_ROUNDOFF;
    Ok(if is_unit { v } else { unit.into() })
}

/// Two numbers from 0 to 1.
pub fn in_square(field: &str, square: [f64; 2], what: &str) -> Result<[f64; 2], Invalid> {
    let fits = |x: &f64| (0.0..=1.0).contains(x) && (what != HALF_OPEN || *x < 1.0);
    if square.iter().all(fits) {
        return Ok(square);
    }
    Err(Invalid::field(field, format!("found {square:?}, but two numbers {what} are needed")))
}

/// The range of random numbers.
pub const HALF_OPEN: &str = "of at least 0 and below 1";
/// The range of positions in a pixel.
pub const CLOSED: &str = "from 0 to 1";

/// A colour as an answer says it.
pub fn color(c: Rgb) -> Triple {
    triple(c)
}
