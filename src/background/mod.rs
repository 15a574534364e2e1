//! Backgrounds: the radiance of rays that hit nothing.

mod directions;
mod image;

use std::borrow::Cow;
use std::sync::Arc;

use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::{Deserialize, Deserializer, Serialize};

use crate::invalid::{Invalid, Ranges};
use crate::kinds::{Field, Giving, Resources};
use crate::math::{Distance, Ray, sin};
use crate::rgb::Rgb;

pub use directions::Directions;
pub use image::{Dome, Image, ImageSky};

/// A colour, in scene files `[r, g, b]` or one number for a grey; or a pattern, as
/// `{ sinusoid = {} }` or `{ image = { file = "sky.hdr" } }`.
#[derive(Clone, Debug, Serialize)]
#[serde(untagged)]
pub enum Background {
    /// The same everywhere.
    Color(Rgb),
    /// See [`Pattern`].
    Pattern(Pattern),
}

/// A background that is not the same everywhere.
#[kind]
#[schemars(title = "patterns")]
pub enum Pattern {
    /// The waves of chapter 4 in the plane z = 0, which show what a sampler misses.
    Sinusoid(Sinusoid),
    /// An image of the sky, all around.
    Image(Image),
}

/// A built background.
#[derive(Clone, Debug)]
pub enum Sky {
    /// The same everywhere.
    Color(Rgb),
    /// See [`Sinusoid`].
    Sinusoid(Sinusoid),
    /// An image, by direction.
    Image(Arc<ImageSky>),
}

/// The test function of chapter 4: the grey `(1 + sin(x² y²))/2` where the ray meets the plane
/// `z = 0`, whose waves become shorter without end along both axes. Black for rays that do not.
#[kind]
#[schemars(example = Sinusoid { unit: 1.0 })]
pub struct Sinusoid {
    /// The length in which x and y are measured; positive.
    #[default(1.0)]
    pub unit: Distance,
}

impl Sky {
    /// The radiance along a ray that hits nothing.
    pub fn radiance(&self, ray: &Ray) -> Rgb {
        match self {
            Self::Color(color) => *color,
            Self::Sinusoid(sinusoid) => Rgb::grey(sinusoid.value(ray)),
            Self::Image(image) => image.radiance(ray.direction),
        }
    }
}

impl Background {
    /// Checks the data and builds.
    ///
    /// # Errors
    /// [`Invalid`] names the field that does not fit.
    pub fn build(&self, resources: &mut Resources) -> Result<Sky, Invalid> {
        match self {
            Self::Color(color) => color.checked("background").map(Sky::Color),
            Self::Pattern(Pattern::Sinusoid(sinusoid)) => sinusoid
                .check_ranges()
                .map(|_| Sky::Sinusoid(sinusoid.clone()))
                .map_err(|e| e.inside("sinusoid").inside("background")),
            Self::Pattern(Pattern::Image(image)) => image
                .build(resources)
                .map(|image| Sky::Image(Arc::new(image)))
                .map_err(|e| e.inside("image").inside("background")),
        }
    }
}

impl Sinusoid {
    fn value(&self, ray: &Ray) -> f64 {
        let t = -ray.origin.z() / ray.direction.z();
        let p = ray.at(t);
        let [x, y] = [p.x() / self.unit, p.y() / self.unit];
        let phase = (x * x) * (y * y);
        if t >= 0.0 && phase.is_finite() { 0.5 * (1.0 + sin(phase)) } else { 0.0 }
    }
}

impl Default for Background {
    fn default() -> Self {
        Rgb::BLACK.into()
    }
}

impl From<Rgb> for Background {
    fn from(color: Rgb) -> Self {
        Self::Color(color)
    }
}

impl From<Image> for Background {
    fn from(image: Image) -> Self {
        Self::Pattern(Pattern::Image(image))
    }
}

impl Default for Sky {
    fn default() -> Self {
        Self::Color(Rgb::BLACK)
    }
}

impl Giving for Pattern {
    const NAME: &'static str = "a pattern";
}

impl JsonSchema for Background {
    fn schema_name() -> Cow<'static, str> {
        Field::<Rgb, Pattern>::schema_name()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        Field::<Rgb, Pattern>::json_schema(generator)
    }
}

impl<'de> Deserialize<'de> for Background {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        Ok(match Field::deserialize(deserializer)? {
            Field::Plain(color) => Self::Color(color),
            Field::Textured(pattern) => Self::Pattern(*pattern),
        })
    }
}
