//! Whether a shape, or an object of a scene, stands in the way.

use serde::Deserialize;

use super::numbers::{RayData, SpanData};
use super::source::{Built, Source};
use super::{intersect, limits};
use groundtruth::accel::Method;
use groundtruth::invalid::Invalid;
use groundtruth::math::{Point, Ray, Span, Step};
use groundtruth::shapes::{Context, Kind};
use groundtruth::world::DEFAULT_SEED;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Occluded {
    shape: Option<Kind>,
    #[serde(default)]
    transform: Vec<Step>,
    shapes: Option<Vec<Kind>>,
    scene: Option<Source>,
    ray: Option<RayData>,
    span: Option<SpanData>,
    segment: Option<Segment>,
}

#[derive(Clone, Copy, Deserialize)]
#[serde(deny_unknown_fields)]
struct Segment {
    from: Point,
    to: Point,
}

impl super::Question for Occluded {
    type Answer = bool;

    fn answer(&self) -> Result<bool, Invalid> {
        let (ray, span) = self.way()?;
        if let Some(scene) = &self.scene {
            if self.shape.is_some() || self.shapes.is_some() || !self.transform.is_empty() {
                return Err(Invalid::field("scene", "stands in the place of `shape` and `shapes`"));
            }
            let Built { world, .. } = scene.built(DEFAULT_SEED, |_| Ok(()))?;
            return Ok(world.occluder(&ray, span).is_some());
        }
        match (&self.shape, &self.shapes) {
            (Some(shape), None) => {
                let shape = intersect::build(shape, &self.transform, Method::default())?;
                Ok(shape.shadow_hit(&ray, span).is_some())
            }
            (None, Some(shapes)) if self.transform.is_empty() => {
                any(shapes, &ray, span).map_err(|e| e.inside("shapes"))
            }
            (None, Some(_)) => {
                let problem = "goes with `shape`; in a list, each shape can be an instance";
                Err(Invalid::field("transform", problem))
            }
            _ => Err(Invalid::new("needs `shape`, `shapes` or `scene`")),
        }
    }
}

impl Occluded {
    fn way(&self) -> Result<(Ray, Span), Invalid> {
        match (self.ray, self.segment) {
            (Some(ray), None) => Ok((ray.ray()?, SpanData::span(self.span)?)),
            (None, Some(_)) if self.span.is_some() => {
                Err(Invalid::field("span", "goes with `ray`; a segment ends by itself"))
            }
            (None, Some(Segment { from, to })) => {
                groundtruth::invalid::direction("to", to - from)
                    .map_err(|_| Invalid::field("to", "the segment has no length, or overflows"))
                    .map_err(|e| e.inside("segment"))?;
                Ok((Ray::new(from, to - from), Span::SEGMENT))
            }
            _ => Err(Invalid::new("needs either `ray` or `segment`")),
        }
    }
}

fn any(shapes: &[Kind], ray: &Ray, span: Span) -> Result<bool, Invalid> {
    limits::buildable(shapes.iter(), |index, e| e.inside(index))?;
    let mut context = Context::default();
    let mut blocked = false;
    for (index, shape) in shapes.iter().enumerate() {
        // every shape is checked, also behind one that is in the way
        let shape = shape.build(&mut context).map_err(|e| e.inside(index))?;
        blocked |= shape.shadow_hit(ray, span).is_some();
    }
    Ok(blocked)
}
