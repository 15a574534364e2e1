//! What a light sends to a place.

use serde::{Deserialize, Serialize};

use super::numbers::{Real, Triple, color, triple};
use crate::invalid::Invalid;
use crate::lights::{Illumination, Kind, Reach};
use crate::math::{Point, Vector};

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Light {
    light: Kind,
    from: Point,
}

#[derive(Serialize)]
#[serde(untagged)]
pub enum Answer {
    Ambient { ambient: Triple },
    From { direction: Triple, distance: Real, radiance: Triple },
}

impl super::Question for Light {
    type Answer = Answer;

    fn answer(&self) -> Result<Answer, Invalid> {
        let light = self.light.build(&mut ()).map_err(|e| e.inside("light"))?;
        match light.illuminate(self.from) {
            Illumination::Ambient(radiance) => Ok(Answer::Ambient { ambient: color(radiance) }),
            Illumination::From(sample) if sample.direction == Vector::ZERO => {
                Err(Invalid::field("from", "is the place of the light: there is no direction"))
            }
            Illumination::From(sample) => Ok(Answer::From {
                direction: triple(sample.direction),
                distance: Real(match sample.reach {
                    Reach::Infinity => f64::INFINITY,
                    Reach::To(place) => self.from.distance(place),
                }),
                radiance: color(sample.radiance),
            }),
        }
    }
}
