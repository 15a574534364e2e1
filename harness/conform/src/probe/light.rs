//! What a light sends to a point.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use super::limits;
use super::numbers::{HALF_OPEN, Real, Triple, color, in_square, triple};
use groundtruth::background::Background;
use groundtruth::invalid::{Invalid, direction};
use groundtruth::kinds::Resources;
use groundtruth::lights::{Context, Kind, LampObject, LightContext, Segment};
use groundtruth::math::{Normal, Point, Vector};
use groundtruth::{materials, shapes};

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Light {
    light: Kind,
    from: Point,
    normal: Option<Vector>,
    #[serde(default)]
    u: Vec<[f64; 2]>,
    lamp: Option<Lamp>,
    #[serde(default)]
    background: Background,
}

/// The object that an area light names: it is called `lamp`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Lamp {
    shape: shapes::Kind,
    material: materials::Kind,
    #[serde(default)]
    two_sided: bool,
}

#[derive(Serialize)]
#[serde(untagged)]
pub enum LightAnswer {
    Ambient {
        ambient: Triple,
    },
    From {
        direction: Triple,
        distance: Real,
        radiance: Triple,
        /// What an ambient occluder sends where something is in the way.
        #[serde(skip_serializing_if = "Option::is_none")]
        blocked: Option<Triple>,
        #[serde(skip_serializing_if = "Option::is_none")]
        pdf: Option<f64>,
    },
}

impl super::Question for Light {
    /// `null` where no light arrives.
    type Answer = Option<LightAnswer>;

    fn answer(&self) -> Result<Option<LightAnswer>, Invalid> {
        let light = self.light.build(&mut self.context()?).map_err(|e| e.inside("light"))?;
        let draws = light.draws();
        if self.u.len() != draws {
            let found = self.u.len();
            let problem = format!("found {found} pairs, but this light needs {draws}");
            return Err(Invalid::field("u", problem));
        }
        let inside = |(i, &u): (usize, &[f64; 2])| {
            in_square("", u, HALF_OPEN).map_err(|e| Invalid::new(e.problem).inside(i).inside("u"))
        };
        let u = self.u.iter().enumerate().map(inside).collect::<Result<Vec<_>, _>>()?;
        let normal = match self.normal {
            Some(normal) => direction("normal", normal)?,
            None if draws == 0 => Normal::Y,
            None => {
                let problem = "missing: light that is sampled is asked for at a surface";
                return Err(Invalid::field("normal", problem));
            }
        };
        let sample = light.sample(&LightContext { point: self.from, normal }, &u);
        Ok(sample.map(|sample| {
            let Some(segment) = sample.segment else {
                return LightAnswer::Ambient { ambient: color(sample.radiance) };
            };
            let occluder = light.is_ambient();
            LightAnswer::From {
                direction: triple(sample.direction),
                distance: Real(match segment {
                    Segment::Infinity => f64::INFINITY,
                    Segment::To(end) => self.from.distance(end),
                }),
                radiance: color(sample.radiance),
                blocked: occluder.then(|| color(sample.blocked)),
                pdf: sample.pdf,
            }
        }))
    }
}

impl Light {
    /// A scene of one object, the lamp.
    fn context(&self) -> Result<Context, Invalid> {
        let background = self.background.build(&mut Resources::default())?;
        let mut objects = BTreeMap::new();
        if let Some(Lamp { shape, material, two_sided }) = &self.lamp {
            let outer = |field: &str, e: Invalid| e.inside(field).inside("lamp");
            let here = |_, e: Invalid| outer("shape", e);
            limits::buildable(std::iter::once(shape), here)?;
            let shape = shape.build(&mut shapes::Context::default());
            let material =
                material.build(&mut Resources::default()).map_err(|e| outer("material", e))?;
            let emission = material.emission().cloned();
            let shape = shape.map_err(|e| outer("shape", e))?;
            let object = LampObject { shape, emission, two_sided: *two_sided };
            objects.insert("lamp".to_owned(), object);
        }
        Ok(Context { objects, background, ..Context::default() })
    }
}
