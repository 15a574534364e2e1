//! The recorder that keeps everything.

use std::sync::Arc;

use groundtruth::lobes::Lobes;
use groundtruth::materials::TexturedField;
use groundtruth::math::{Normal, Point, Ray, Vector, atan2, to_degrees};
use groundtruth::rgb::Rgb;
use groundtruth::shapes::PartPath;
use groundtruth::textures::Texel;
use groundtruth::trace::{Outcome, RayKind, Recorder, ShadingPoint, Term, TermSource};
use groundtruth::world::{Hit, Names, World};
use serde::Serialize;

use super::optics::Optics;
use super::unlit::UnlitLight;

/// Records all rays of a sample.
#[derive(Clone, Debug)]
pub struct RayTree {
    names: Arc<Names>,
    /// The rays that have begun and not ended, each the parent of the next.
    open: Vec<RecordedRay>,
    /// The camera's ray, once it has ended.
    root: Option<RecordedRay>,
    /// The number of rays kept.
    count: usize,
    /// The number of open rays that are not kept.
    beyond: usize,
    /// Whether some ray was not kept.
    cut: bool,
}

/// The most rays that are kept: a larger tree would be unreadable and take gigabytes.
const MAX_KEPT: usize = 1 << 20;

/// One ray, with all rays after it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct RecordedRay {
    /// Its number in the tree: 0 is the camera's ray, the others follow in the order in which they
    /// were cast.
    pub number: usize,
    /// The number of the ray that sent it; `None` for the camera's. As data, children stand in
    /// their parent.
    #[serde(skip)]
    pub parent: Option<usize>,
    /// Its purpose.
    #[serde(flatten)]
    pub kind: RayKind,
    /// The light of a shadow ray.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub light: Option<Arc<str>>,
    /// The number of rays before it; 0 for the camera's ray.
    pub depth: u32,
    /// The ray: with a unit direction, or for a shadow ray to a point, the way to that point.
    #[serde(flatten)]
    pub ray: Ray,
    /// The factor of its radiance in the ray before it.
    pub weight: Rgb,
    /// Its outcome.
    #[serde(flatten)]
    pub outcome: Outcome,
    /// The surface that it hit.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub hit: Option<RecordedHit>,
    /// The object that blocked a shadow ray.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub blocked_by: Option<Arc<str>>,
    /// The terms of what leaves the surface towards its origin, in order.
    pub terms: Vec<RecordedTerm>,
    /// The lights that add nothing at its hit; asked by an explanation.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub unlit: Vec<UnlitLight>,
    /// Of an explained ray that brings no light and is no shadow ray, one sentence: which factors
    /// are 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub black: Option<String>,
    /// The transmittance of its medium.
    pub transmittance: Rgb,
    /// The radiance that arrives at its origin: the transmittance times the sum of the terms.
    pub radiance: Rgb,
    /// The contribution of it and of all rays after it to their sample; worked out by an
    /// explanation.
    pub contribution: Rgb,
    /// The contribution of its own terms, without another ray.
    pub own_contribution: Rgb,
    /// The part of its sample that it adds, from 0 to 1, averaged over the channels; 0 in a black
    /// sample.
    pub share: f64,
    /// The rays it sent, in order.
    pub children: Vec<RecordedRay>,
}

/// The surface that a ray hit.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct RecordedHit {
    /// The object.
    pub object: Arc<str>,
    /// The material of the part that is hit.
    pub material: Arc<str>,
    /// Which of the shapes nested in the object's, and which part of the innermost.
    #[serde(skip_serializing_if = "PartPath::is_empty")]
    pub path: PartPath,
    /// Along the ray.
    pub t: f64,
    /// The hit point.
    pub point: Point,
    /// Bound of the distance between the point and the true surface.
    pub error: f64,
    /// The true normal.
    pub normal: Normal,
    /// The normal used for shading.
    pub shading_normal: Normal,
    /// Whether the ray met the side the normal points to.
    pub front: bool,
    /// The angle of incidence: between the ray and the true normal, in degrees from 0 to 90.
    pub angle_of_incidence: f64,
    /// The cosine between the true normal and the direction to the viewer; of a two-sided surface,
    /// not negative.
    #[serde(skip)]
    pub cos_o: f64,
    /// How light divides there, if the surface refracts.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub optics: Option<Optics>,
    /// The values of its material's textures there.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub textures: Vec<RecordedTexture>,
    /// Whether its material shines.
    #[serde(skip)]
    pub is_emissive: bool,
    /// Whether it is the lamp of an area light that is off, and so does not shine.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub is_switched_off: bool,
}

/// The value of a material's texture at a hit.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct RecordedTexture {
    /// The field of the material that it stands in.
    pub field: String,
    /// Its colour; a field that is a number takes the red channel.
    pub color: Rgb,
    /// The position in its image, if it has one.
    #[serde(flatten, skip_serializing_if = "Option::is_none")]
    pub texel: Option<Texel>,
}

/// One term of what leaves a surface: `weight · arriving`.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct RecordedTerm {
    /// Where it comes from.
    #[serde(flatten)]
    pub source: TermSource,
    /// The light that it comes from.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub light: Option<Arc<str>>,
    /// What the arriving light is multiplied by.
    pub weight: Rgb,
    /// The light that arrives.
    pub arriving: Rgb,
    /// Their product.
    pub value: Rgb,
    /// The contribution to its sample; worked out by an explanation.
    pub contribution: Rgb,
    /// The part of its sample that it adds, from 0 to 1, averaged over the channels; 0 in a black
    /// sample.
    pub share: f64,
    /// The number of the ray that the light comes along, if it took one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ray: Option<usize>,
}

impl RecordedHit {
    fn of(point: &ShadingPoint<'_>, lobes: &Lobes) -> Self {
        let hit = point.hit;
        let along = hit.surface.normal.dot(point.wo).abs();
        let across = Vector::from(hit.surface.normal).cross(point.wo).length();
        let is_emissive = hit.material.recipe.emission().is_some();
        Self {
            object: Arc::clone(&hit.object.name),
            material: Arc::clone(&hit.material.name),
            path: hit.path(),
            t: hit.t,
            point: hit.surface.point,
            error: hit.surface.error,
            normal: hit.surface.normal,
            shading_normal: hit.shading_normal(),
            front: hit.front,
            angle_of_incidence: to_degrees(atan2(across, along)),
            cos_o: point.cos_o,
            optics: Optics::of(point, lobes),
            textures: recorded_textures(hit),
            is_emissive,
            is_switched_off: !hit.object.shines,
        }
    }
}

fn recorded_textures(hit: &Hit<'_>) -> Vec<RecordedTexture> {
    let at = hit.texture_point();
    let recorded = |(field, texture): TexturedField<'_>| RecordedTexture {
        field,
        color: texture.color(&at),
        texel: texture.texel(&at),
    };
    hit.material.recipe.textures(&at).into_iter().map(recorded).collect()
}

impl RecordedRay {
    /// It and all rays after it, in the order of their numbers.
    pub fn rays(&self) -> Vec<&Self> {
        let mut rays = vec![self];
        rays.extend(self.children.iter().flat_map(Self::rays));
        rays
    }

    /// Whether it looks for what is in the way to a light.
    pub fn is_shadow(&self) -> bool {
        matches!(self.kind, RayKind::Shadow { .. })
    }

    /// Whether it was cast: a limit may have come before.
    pub fn is_cast(&self) -> bool {
        !matches!(self.outcome, Outcome::TooDeep | Outcome::OverBudget)
    }

    /// The child of this number.
    pub fn child(&self, number: usize) -> Option<&Self> {
        self.children.iter().find(|child| child.number == number)
    }

    /// The radiance by the law `T · Σ terms`, computed again from its terms and children.
    pub fn folded(&self) -> Rgb {
        let value = |term: &RecordedTerm| match term.ray.and_then(|ray| self.child(ray)) {
            Some(child) => term.weight * child.radiance,
            None => term.value,
        };
        self.transmittance * self.terms.iter().map(value).sum()
    }
}

impl RayTree {
    /// Records a sample of this world.
    pub fn of(world: &World) -> Self {
        let names = Arc::clone(&world.names);
        Self { names, open: Vec::new(), root: None, count: 0, beyond: 0, cut: false }
    }

    /// The camera's ray with all rays after it; `None` if no ray was cast.
    pub fn into_root(self) -> Option<RecordedRay> {
        self.root
    }

    /// The rays in the order of their numbers; a parent comes before its children.
    pub fn rays(&self) -> Vec<&RecordedRay> {
        self.root.as_ref().map_or(Vec::new(), RecordedRay::rays)
    }

    /// The camera's ray.
    ///
    /// # Panics
    /// If nothing was recorded.
    pub fn root(&self) -> &RecordedRay {
        self.root.as_ref().expect("a sample was recorded")
    }

    /// Whether every ray was kept: at most about a million are.
    pub fn is_complete(&self) -> bool {
        !self.cut
    }

    fn light(&self, index: u32) -> Arc<str> {
        Arc::clone(&self.names.lights[index as usize])
    }

    /// The ray that events are about, if it is kept.
    fn current(&mut self) -> Option<&mut RecordedRay> {
        if self.beyond > 0 { None } else { self.open.last_mut() }
    }
}

impl Recorder for RayTree {
    fn enter(&mut self, kind: RayKind, ray: &Ray, _: u32, weight: Rgb) {
        let number = self.count;
        if self.beyond > 0 || number >= MAX_KEPT {
            self.beyond += 1;
            self.cut = true;
            return;
        }
        self.count += 1;
        let light = match kind {
            RayKind::Shadow { light } => Some(self.light(light)),
            RayKind::Camera | RayKind::Reflected | RayKind::Transmitted => None,
        };
        let parent = self.open.last();
        self.open.push(RecordedRay {
            number,
            parent: parent.map(|parent| parent.number),
            kind,
            light,
            depth: parent.map_or(0, |parent| parent.depth + 1),
            ray: *ray,
            weight,
            outcome: Outcome::Background,
            hit: None,
            blocked_by: None,
            terms: Vec::new(),
            unlit: Vec::new(),
            black: None,
            transmittance: Rgb::WHITE,
            radiance: Rgb::BLACK,
            contribution: Rgb::BLACK,
            own_contribution: Rgb::BLACK,
            share: 0.0,
            children: Vec::new(),
        });
    }

    fn hit(&mut self, point: &ShadingPoint<'_>, lobes: &Lobes) {
        if let Some(ray) = self.current() {
            ray.hit = Some(RecordedHit::of(point, lobes));
        }
    }

    fn term(&mut self, term: Term) {
        let Term { source, weight, arriving, value } = term;
        let (light, from_ray) = match source {
            TermSource::Traced { .. } => (None, true),
            TermSource::Direct { light, traced, .. } | TermSource::Ambient { light, traced } => {
                (Some(light), traced)
            }
            TermSource::Light { light } => (Some(light), false),
            TermSource::Background { .. } | TermSource::Emission { .. } => (None, false),
        };
        let light = light.map(|light| self.light(light));
        let Some(current) = self.current() else { return };
        let ray = current.children.last().filter(|_| from_ray).map(|child| child.number);
        let (contribution, share) = (Rgb::BLACK, 0.0);
        let term =
            RecordedTerm { source, light, weight, arriving, value, contribution, share, ray };
        current.terms.push(term);
    }

    fn leave(&mut self, outcome: Outcome, transmittance: Rgb, arriving: Rgb) {
        if self.beyond > 0 {
            self.beyond -= 1;
            return;
        }
        let mut ray = self.open.pop().expect("a ray has begun");
        if let Outcome::Blocked { blocked_by } = outcome {
            ray.blocked_by = Some(Arc::clone(&self.names.objects[blocked_by as usize]));
        }
        (ray.outcome, ray.transmittance, ray.radiance) = (outcome, transmittance, arriving);
        match self.open.last_mut() {
            Some(parent) => parent.children.push(ray),
            None => self.root = Some(ray),
        }
    }
}
