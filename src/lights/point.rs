//! The point light (Suffern, ch. 14), with the distance attenuation of its exercises.

use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{Illumination, Light, LightSample, Place, Reach};
use crate::invalid::{Invalid, finite, finite_point, not_negative};
use crate::kinds::{self, Specification};
use crate::math::{Vector, power};
use crate::rgb::Rgb;

/// Light `ls · color / d^k` from one place, `d` the distance.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "PointLight")]
pub struct Point {
    /// Multiplies the colour; not negative.
    #[serde(default = "kinds::one")]
    pub ls: f64,
    /// The colour of the light.
    #[serde(default = "kinds::white::<Rgb>")]
    pub color: Rgb,
    /// Where it is.
    pub location: Place,
    /// The exponent `k` of the distance, not negative: 0, the book's default, for the same light at
    /// every distance; 2 for real lamps, whose `ls` must then be as large as the distance squared.
    #[serde(default)]
    pub attenuation: f64,
}

#[derive(Debug)]
struct Built {
    radiance: Rgb,
    location: Place,
    attenuation: f64,
}

impl Specification for Point {
    type Built = Arc<dyn Light>;
    type Context = ();

    fn build(&self, (): &mut ()) -> Result<Arc<dyn Light>, Invalid> {
        finite("attenuation", self.attenuation)?;
        Ok(Arc::new(Built {
            radiance: not_negative("ls", self.ls)? * self.color.checked("color")?,
            location: finite_point("location", self.location)?,
            attenuation: not_negative("attenuation", self.attenuation)?,
        }))
    }

    fn scaled(&self, factor: f64) -> Self {
        Self {
            ls: self.ls * power(factor, self.attenuation),
            location: self.location.scaled(factor),
            ..*self
        }
    }

    fn specimens() -> Vec<Self> {
        let plain = Self {
            ls: 3.0,
            color: Rgb::new(1.0, 0.5, 0.0),
            location: Place::new(10.0, 15.0, 20.0),
            attenuation: 0.0,
        };
        vec![Self { attenuation: 2.0, ls: 600.0, ..plain }, plain]
    }
}

impl Light for Built {
    fn illuminate(&self, from: Place) -> Illumination {
        let to_light = self.location - from;
        let distance = to_light.length();
        let radiance = match self.attenuation {
            0.0 => self.radiance,
            k => self.radiance / power(distance, k),
        };
        // at the light itself there is no direction, and no surface that faces it
        let direction = to_light.unit().unwrap_or(Vector::ZERO);
        let reach = Reach::To(self.location);
        Illumination::From(LightSample {
            direction,
            reach,
            radiance,
            blocked: Rgb::BLACK,
            pdf: 1.0,
        })
    }
}
