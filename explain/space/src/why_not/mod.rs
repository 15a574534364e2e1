//! Why a ray does not hit an object.
//!
//! What the tracer recorded decides: which object the ray hit, or what blocked it. Only where that leaves several
//! reasons open are the ray's own hits of the object looked at, as if it were alone.

mod alone;
mod words;

use std::path::Path;

use explain::RecordedRay;
use groundtruth::math::{Point, Ray, Span};
use groundtruth::printable;
use groundtruth::scene::Scene;
use groundtruth::similar;
use groundtruth::trace::{Outcome, RayKind};
use groundtruth::world::{Hit, PlacedObject, World};
use serde::Serialize;
use text::brief::count;

use super::approach::{Approach, Beside};
use super::hits::hits;
use super::segments::light_point;

/// A question about a ray of a recorded tree.
#[derive(Clone, Copy, Debug)]
pub struct Question<'a> {
    /// The scene that was rendered.
    pub scene: &'a Scene,
    /// The folder of the files that the scene names.
    pub folder: &'a Path,
    /// Its world.
    pub world: &'a World,
    /// The tree.
    pub root: &'a RecordedRay,
    /// The number of the ray in the tree.
    pub ray: usize,
    /// The index of the object in the scene; it may be switched off.
    pub object: u32,
}

/// Why a ray does not hit an object, or that it does.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct WhyNot {
    /// The name of the object.
    pub object: String,
    /// The number of the ray.
    pub ray: usize,
    /// The purpose of the ray.
    #[serde(flatten)]
    pub kind: RayKind,
    /// The light of a shadow ray.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub light: Option<String>,
    /// The answer.
    #[serde(flatten)]
    pub answer: WhyNotAnswer,
    /// Where the ray meets the object or, if something is before it or it is switched off, would meet it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub meets: Option<Meeting>,
    /// Where the ray is nearest to the object that it does not meet. Other objects do not end it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub approach: Option<Approach>,
    /// What ended the ray: the object that it hit, or the one that blocked it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ended: Option<Ended>,
    /// If the ray brings no light: which factors are 0, in a sentence.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub black: Option<String>,
    /// The numbers of the rays of the tree that hit the object or are blocked by it.
    pub met_by: Vec<usize>,
}

/// Where a ray meets an object.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Meeting {
    /// Along the ray, in units of its direction.
    pub t: f64,
    /// From the ray's origin, in world units.
    pub distance: f64,
    /// The point.
    pub point: Point,
}

/// What ended a ray, and where.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Ended {
    /// The object.
    pub object: String,
    /// Where.
    #[serde(flatten)]
    pub at: Meeting,
}

/// Why a ray does not hit an object, or that it does.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "answer", rename_all = "snake_case")]
pub enum WhyNotAnswer {
    /// It hits it.
    Hits {
        /// Whether on the side that the normal points to.
        front: bool,
        /// Whether that is the back of a one-sided material, which scatters nothing.
        is_dark_back: bool,
    },
    /// The object blocks the shadow ray.
    Blocks,
    /// The object is switched off.
    SwitchedOff,
    /// The ray was not cast.
    NotCast {
        /// Because it is beyond the largest depth; if not, because there were too many rays.
        is_too_deep: bool,
    },
    /// Another object is before it.
    BeyondHit,
    /// Another object blocks the shadow ray before it.
    BeyondBlocker,
    /// Another object blocks the shadow ray behind it; any one is enough.
    AlsoBlocks,
    /// The light of the shadow ray is before it.
    BeyondLight,
    /// The shadow ray passes it: no object casts shadows in the light.
    LightCastsNone,
    /// The shadow ray passes it: it casts no shadows.
    CastsNone,
    /// The shadow ray passes it: it lets light through.
    LetsThrough,
    /// It is as near as rounding can tell to where the ray starts, to its light or to another surface.
    Touches,
    /// The ray starts on it and leaves it.
    StartsOnIt,
    /// It is a part of a larger surface, which the ray meets elsewhere.
    OutsidePart {
        /// The larger surface: `plane`, `whole sphere`.
        whole: &'static str,
        /// Where.
        at: Meeting,
    },
    /// It is behind the origin: the line of the ray meets it there.
    Behind {
        /// Where; its t is negative.
        at: Meeting,
    },
    /// The ray passes it.
    Passes,
}

/// Part of the way to a light: nearer than this to its end, a surface is at the light.
const AT_LIGHT: f64 = 1e-9;

/// The index of the object of a name in a scene.
///
/// # Errors
/// No object has the name: says which are like it, and all there are.
pub fn object_named(scene: &Scene, name: &str) -> Result<u32, String> {
    let known: Vec<&str> = scene.objects.iter().map(|object| object.name.as_str()).collect();
    let found = known.iter().position(|known| *known == name);
    found.map(|index| index as u32).ok_or_else(|| {
        let hint = similar::did_you_mean(name, &known);
        let all: Vec<String> =
            known.iter().map(|name| format!("\"{}\"", printable::name(name))).collect();
        let all = if all.is_empty() { "none".to_owned() } else { all.join(", ") };
        format!("no object \"{}\"; the objects are {all}{hint}", printable::name(name))
    })
}

impl Question<'_> {
    /// The answer.
    ///
    /// # Errors
    /// The tree has no such ray or the scene no such object, or an object that is switched off cannot be built.
    pub fn answer(&self) -> Result<WhyNot, String> {
        let rays = self.root.rays();
        let numbered = |number| rays.iter().copied().find(|ray| ray.number == number);
        let ray = numbered(self.ray).ok_or_else(|| {
            let all = count(rays.len(), "ray");
            format!("no ray {}: the tree has {all}, numbered from 0", self.ray)
        })?;
        let parent = ray.parent.and_then(numbered);
        let of_scene = self.scene.objects.get(self.object as usize);
        let name = of_scene.map(|object| object.name.as_str()).ok_or_else(|| {
            format!("no object {}: the scene has {}", self.object, self.scene.objects.len())
        })?;
        let is_light_near = light_point(self.world, ray, parent).is_some();
        let cast = Cast {
            question: self,
            name,
            ray,
            parent,
            end: if is_light_near { 1.0 } else { f64::INFINITY },
            is_on: true,
        };
        let met_by = rays.iter().filter(|ray| meets(ray, name)).map(|ray| ray.number).collect();
        match self.world.objects().iter().find(|object| object.index == self.object) {
            Some(object) => Ok(cast.answer(self.world, object, met_by)),
            None => {
                let world = alone::world(self.scene, self.folder, self.object);
                let world = world.map_err(|error| error.to_string())?;
                Ok(Cast { is_on: false, ..cast }.answer(&world, &world.objects()[0], met_by))
            }
        }
    }
}

/// Whether a recorded ray hits an object or is blocked by it.
fn meets(ray: &RecordedRay, name: &str) -> bool {
    let hit = ray.hit.as_ref().map(|hit| &*hit.object);
    [hit, ray.blocked_by.as_deref()].contains(&Some(name))
}

/// A ray and an object that is asked about.
struct Cast<'a> {
    question: &'a Question<'a>,
    name: &'a str,
    ray: &'a RecordedRay,
    parent: Option<&'a RecordedRay>,
    /// Where the ray ends by itself, in units of its direction: at its light, or never.
    end: f64,
    /// Whether the object is switched on.
    is_on: bool,
}

impl Cast<'_> {
    /// The answer for the object of this world: that of the question, or one with the object alone.
    fn answer(&self, world: &World, object: &PlacedObject, met_by: Vec<usize>) -> WhyNot {
        let ray = &self.ray.ray;
        let first = world.hit_of(object, ray, Span::AHEAD);
        let ended = self.ended();
        let answer = self.reason(world, object, first.as_ref(), ended.as_ref());
        let meets = match &answer {
            WhyNotAnswer::Hits { .. } | WhyNotAnswer::Blocks => ended.as_ref().map(|it| it.at),
            _ => first.as_ref().map(|hit| meeting(ray, hit.t, hit.surface.point)),
        };
        let is_apart = meets.is_none() && answer != WhyNotAnswer::StartsOnIt;
        let beside = Beside { world, object, ray: *ray, end: self.end };
        WhyNot {
            object: self.name.to_owned(),
            ray: self.ray.number,
            kind: self.ray.kind,
            light: self.ray.light.as_ref().map(|light| light.to_string()),
            approach: is_apart.then(|| beside.approach()).flatten(),
            answer,
            meets,
            ended,
            black: self.ray.black.clone(),
            met_by,
        }
    }

    /// What ended the ray.
    fn ended(&self) -> Option<Ended> {
        let ray = &self.ray.ray;
        if let Some(hit) = &self.ray.hit {
            let at = meeting(ray, hit.t, hit.point);
            return Some(Ended { object: hit.object.to_string(), at });
        }
        let Outcome::Blocked { blocked_by } = self.ray.outcome else { return None };
        let world = self.question.world;
        let blocker = world.objects().iter().find(|object| object.index == blocked_by)?;
        let hits = || hits(world, blocker, *ray).filter(|(t, _)| *t < self.end);
        let opaque = hits().find(|(_, hit)| hit.casts_shadow() && !self.lets_through(hit));
        let (t, hit) = opaque.or_else(|| hits().next())?;
        let object = self.ray.blocked_by.as_ref()?.to_string();
        Some(Ended { object, at: meeting(ray, t, hit.surface.point) })
    }

    /// Whether shadow rays pass a surface because it is transparent.
    fn lets_through(&self, hit: &Hit<'_>) -> bool {
        use groundtruth::scene::TransparentShadows;
        let shadows = self.question.world.transparency.shadows;
        shadows == TransparentShadows::Attenuated && hit.material.recipe.transmits()
    }

    fn reason(
        &self,
        world: &World,
        object: &PlacedObject,
        first: Option<&Hit<'_>>,
        ended: Option<&Ended>,
    ) -> WhyNotAnswer {
        match self.ray.outcome {
            _ if self.ray.blocked_by.as_deref() == Some(self.name) => WhyNotAnswer::Blocks,
            Outcome::Hit if meets(self.ray, self.name) => self.hit(),
            _ if !self.is_on => WhyNotAnswer::SwitchedOff,
            Outcome::TooDeep => WhyNotAnswer::NotCast { is_too_deep: true },
            Outcome::OverBudget => WhyNotAnswer::NotCast { is_too_deep: false },
            _ => match first {
                None => self.missed(world, object),
                Some(first) if self.ray.light.is_some() => {
                    let hits = hits(world, object, self.ray.ray);
                    let before_light = hits.take_while(|(t, _)| *t < self.end);
                    let hits: Vec<_> = before_light.map(|(_, hit)| hit).collect();
                    self.shadow(first, &hits, ended)
                }
                Some(_) if ended.is_some() => WhyNotAnswer::BeyondHit,
                Some(_) => WhyNotAnswer::Touches,
            },
        }
    }

    fn hit(&self) -> WhyNotAnswer {
        let hit = self.ray.hit.as_ref().expect("the ray hits something");
        let material = self.question.world.materials.iter().find(|it| it.name == hit.material);
        let is_one_sided = material.is_some_and(|it| !it.two_sided && !it.recipe.transmits());
        WhyNotAnswer::Hits { front: hit.front, is_dark_back: !hit.front && is_one_sided }
    }

    /// Why an object ahead did not block the shadow ray. `hits` are those before the light.
    fn shadow(&self, first: &Hit<'_>, hits: &[Hit<'_>], ended: Option<&Ended>) -> WhyNotAnswer {
        if first.t >= self.end - AT_LIGHT {
            return WhyNotAnswer::BeyondLight;
        }
        let casts = hits.iter().any(Hit::casts_shadow);
        let lets_through = hits.iter().all(|hit| !hit.casts_shadow() || self.lets_through(hit));
        let lamps = &self.question.world.lights;
        let light = lamps.iter().find(|light| Some(&*light.name) == self.ray.light.as_deref());
        match ended {
            Some(ended) if ended.at.t < first.t => WhyNotAnswer::BeyondBlocker,
            None if light.is_some_and(|light| !light.shadows) => WhyNotAnswer::LightCastsNone,
            _ if !casts => WhyNotAnswer::CastsNone,
            _ if lets_through => WhyNotAnswer::LetsThrough,
            Some(_) => WhyNotAnswer::AlsoBlocks,
            None => WhyNotAnswer::Touches,
        }
    }

    /// Why the ray meets nothing of the object.
    fn missed(&self, world: &World, object: &PlacedObject) -> WhyNotAnswer {
        let Self { ray, parent, .. } = self;
        if parent.is_some_and(|parent| meets(parent, self.name)) {
            return WhyNotAnswer::StartsOnIt;
        }
        if let Some((whole, at)) = self.whole(object) {
            return WhyNotAnswer::OutsidePart { whole, at };
        }
        let backward = Ray::new(ray.ray.origin, -ray.ray.direction);
        match world.hit_of(object, &backward, Span::AHEAD) {
            Some(hit) => {
                let at = meeting(&backward, hit.t, hit.surface.point);
                WhyNotAnswer::Behind { at: Meeting { t: -at.t, ..at } }
            }
            None => WhyNotAnswer::Passes,
        }
    }

    /// The larger surface of which the object is a part, and where the ray meets it.
    fn whole(&self, object: &PlacedObject) -> Option<(&'static str, Meeting)> {
        let (name, whole) = object.shape.whole()?;
        let ray = &self.ray.ray;
        let at = whole.hit(ray, Span { min: 0.0, max: self.end })?;
        Some((name, meeting(ray, at.t, whole.surface(ray, &at).point)))
    }
}

fn meeting(ray: &Ray, t: f64, point: Point) -> Meeting {
    Meeting { t, distance: t * ray.direction.length(), point }
}
