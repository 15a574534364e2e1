//! Where a ray meets a shape, or a scene.

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::limits;
use super::numbers::{RayData, Real, SpanData, Triple, triple};
use super::source::{Built, Source};
use groundtruth::accel::Method;
use groundtruth::invalid::{Invalid, Key, direction};
use groundtruth::kinds::Resources;
use groundtruth::math::{Ray, Span, Step, Vector};
use groundtruth::scene::Scene;
use groundtruth::shapes::{
    Candidate, Context, Instance, Kind, PartPath, Shape, Specification, Surface,
};
use groundtruth::world::DEFAULT_SEED;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Intersect {
    shape: Option<Kind>,
    scene: Option<Source>,
    #[serde(default)]
    transform: Vec<Step>,
    ray: RayData,
    span: Option<SpanData>,
    #[serde(default)]
    all: bool,
    /// A direction in which a ray leaves the hit.
    leave: Option<Vector>,
    /// Whether acceleration structures are used; they change no answer.
    #[serde(default = "yes")]
    accelerated: bool,
}

fn yes() -> bool {
    true
}

/// One hit.
#[derive(Serialize)]
pub struct Hit {
    /// In a scene, the object.
    #[serde(skip_serializing_if = "Option::is_none")]
    object: Option<Arc<str>>,
    t: Real,
    point: Triple,
    /// Geometric.
    normal: Triple,
    #[serde(skip_serializing_if = "Option::is_none")]
    shading_normal: Option<Triple>,
    front: bool,
    error: Real,
    /// Texture coordinates, of what has any.
    #[serde(skip_serializing_if = "Option::is_none")]
    uv: Option<[Real; 2]>,
    /// Through which nested shapes the hit went, of what has any.
    #[serde(skip_serializing_if = "PartPath::is_empty")]
    path: PartPath,
    /// Where a ray that leaves in the direction asked for starts.
    #[serde(skip_serializing_if = "Option::is_none")]
    leave: Option<Triple>,
}

#[derive(Serialize)]
#[serde(untagged)]
pub enum IntersectAnswer {
    All(Vec<Hit>),
    Nearest(Option<Hit>),
}

impl super::Question for Intersect {
    type Answer = IntersectAnswer;

    fn answer(&self) -> Result<IntersectAnswer, Invalid> {
        let ray = self.ray.ray()?;
        let span = SpanData::span(self.span)?;
        if let Some(leave) = self.leave {
            direction("leave", leave)?;
        }
        let kind = match (&self.shape, &self.scene) {
            (Some(shape), None) => shape,
            (None, Some(scene)) => {
                return self.in_scene(scene, &ray, span).map(IntersectAnswer::Nearest);
            }
            _ => return Err(Invalid::new("needs either `shape` or `scene`")),
        };
        let shape = build(kind, &self.transform, self.method())?;
        if self.all {
            limits::all_of(&*shape).map_err(|e| e.inside("all"))?;
            let roots = shape.roots(&ray, span);
            return Ok(IntersectAnswer::All(
                roots.iter().map(|at| self.hit(&*shape, &ray, at)).collect(),
            ));
        }
        Ok(IntersectAnswer::Nearest(shape.hit(&ray, span).map(|at| self.hit(&*shape, &ray, &at))))
    }
}

impl Intersect {
    fn method(&self) -> Method {
        if self.accelerated { Method::default() } else { Method::List }
    }

    /// The first hit in a scene.
    fn in_scene(&self, scene: &Source, ray: &Ray, span: Span) -> Result<Option<Hit>, Invalid> {
        if self.all || !self.transform.is_empty() {
            let field = if self.all { "all" } else { "transform" };
            return Err(Invalid::field(field, "goes with `shape`, not with `scene`"));
        }
        let method = |scene: &mut Scene| {
            scene.accel = if self.accelerated { scene.accel } else { self.method() };
            Ok(())
        };
        let Built { world, .. } = scene.built(DEFAULT_SEED, method)?;
        Ok(world.hit(ray, span).map(|hit| {
            let object = Some(Arc::clone(&hit.object.name));
            Hit { object, uv: None, path: hit.path(), ..self.of_surface(hit.t, &hit.surface, ray) }
        }))
    }

    fn hit(&self, shape: &dyn Shape, ray: &Ray, at: &Candidate) -> Hit {
        let surface = shape.surface(ray, at);
        let uv = shape.facet(at, Vector::ZERO).and_then(|facet| facet.uv());
        Hit {
            uv: uv.map(|uv| uv.map(Real)),
            path: shape.path(at),
            ..self.of_surface(at.t, &surface, ray)
        }
    }

    fn of_surface(&self, t: f64, surface: &Surface, ray: &Ray) -> Hit {
        let differs = surface.shading != surface.normal;
        Hit {
            object: None,
            t: Real(t),
            point: triple(surface.point),
            normal: triple(surface.normal),
            shading_normal: differs.then(|| triple(surface.shading)),
            front: surface.is_front(ray.direction),
            error: Real(surface.error),
            uv: None,
            path: PartPath::default(),
            leave: self.leave.map(|direction| triple(surface.leave(direction))),
        }
    }
}

/// The shape seen through the steps, if there are any.
pub(super) fn build(
    shape: &Kind,
    transform: &[Step],
    method: Method,
) -> Result<Arc<dyn Shape>, Invalid> {
    limits::buildable(std::iter::once(shape), |_, e| e.inside("shape"))?;
    let mut context = Context::new(Resources::default(), method);
    if transform.is_empty() {
        return shape.build(&mut context).map_err(|e| e.inside("shape"));
    }
    let instance = Instance::new(shape.clone(), transform.to_vec());
    instance.build(&mut context).map_err(|mut e| {
        // what an instance calls `of` is the line's `shape`
        if let Some(key) = e.path.first_mut().filter(|key| **key == Key::from("of")) {
            *key = "shape".into();
        }
        e
    })
}
