//! The environment light (Suffern, ch. 18): the sky.

use std::f64::consts::PI;
use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{Context, Light, LightContext, LightSample, Segment, Target};
use crate::background::Background;
use crate::invalid::Invalid;
use crate::kinds::Specification;
use crate::math::{Frame, Ray, maps};
use crate::rgb::Rgb;

/// The light of the scene's `background`, from all sides. It has no radiance of its own, so that the
/// sky is written once. Switched off, the sky is still seen. (The book's light has a material, and a huge sphere of it is the sky.)
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Environment {}

#[derive(Debug)]
struct Sky {
    background: Background,
}

impl Specification for Environment {
    type Built = Arc<dyn Light>;
    type Context = Context;

    fn build(&self, context: &mut Context) -> Result<Arc<dyn Light>, Invalid> {
        let background = context.background.clone();
        if background.depends_on_origin() {
            let problem =
                "the background depends on where a ray starts, so it is no sky; a colour is one";
            return Err(Invalid::new(problem));
        }
        Ok(Arc::new(Sky { background }))
    }

    fn scaled(&self, _: f64) -> Self {
        self.clone()
    }

    fn specimens() -> Vec<Self> {
        vec![Self {}]
    }
}

impl Light for Sky {
    fn is_sky(&self) -> bool {
        true
    }

    fn draws(&self) -> usize {
        1
    }

    /// Cosine-distributed about the normal.
    fn sample(&self, from: &LightContext, u: &[[f64; 2]]) -> Option<LightSample> {
        let direction = Frame::around(from.normal).to_world(maps::hemisphere(u[0], 1.0));
        let pdf = from.normal.dot(direction) / PI;
        (pdf > 0.0).then(|| LightSample {
            direction,
            segment: Some(Segment::Infinity),
            radiance: self.background.radiance(&Ray::new(from.point, direction)),
            blocked: Rgb::BLACK,
            pdf: Some(pdf),
        })
    }

    fn pdf(&self, from: &LightContext, to: &Target<'_>) -> f64 {
        match to {
            Target::Infinity(direction) => from.normal.dot(*direction).max(0.0) / PI,
            Target::Surface(_) => 0.0,
        }
    }
}
