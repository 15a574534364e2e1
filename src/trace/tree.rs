//! The recorder that keeps everything.

use serde::Serialize;

use super::recorder::{Outcome, RayKind, Recorder, Term, TermSource};
use super::{Optics, ShadingPoint};
use crate::lights::Unlit;
use crate::lobes::Lobes;
use crate::materials::TexturedField;
use crate::math::{Normal, Point, Ray, Vector, atan2, to_degrees};
use crate::rgb::Rgb;
use crate::shapes::PartPath;
use crate::textures::Texel;
use crate::world::Hit;

/// All rays of a sample; a parent comes before its children.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RayTree {
    nodes: Vec<Node>,
    /// The rays that have begun and not ended.
    open: Vec<usize>,
    /// The number of open rays that are not kept.
    beyond: usize,
    /// Whether some ray was not kept.
    cut: bool,
}

/// The most rays that are kept: a larger tree would be unreadable and take gigabytes.
const MAX_RAYS: usize = 1 << 20;

/// One ray.
#[derive(Clone, Debug, PartialEq)]
pub struct Node {
    /// Its purpose.
    pub kind: RayKind,
    /// The ray.
    pub ray: Ray,
    /// The number of edges before it; 0 for shadow rays, which end the tree.
    pub depth: u32,
    /// The factor of its radiance in the ray before it.
    pub weight: Rgb,
    /// Its outcome.
    pub outcome: Outcome<RecordedHit>,
    /// The terms of its sum, in order.
    pub terms: Vec<RecordedTerm>,
    /// The lights that were not counted at its hit, by their indices.
    pub unlit: Vec<(u32, Unlit)>,
    /// The transmittance of its medium.
    pub transmittance: Rgb,
    /// The radiance that arrives at its origin.
    pub radiance: Rgb,
    /// The indices of the rays it sent, in order.
    pub children: Vec<usize>,
}

/// A hit that was recorded.
#[derive(Clone, Debug, PartialEq)]
pub struct RecordedHit {
    /// Along the ray.
    pub t: f64,
    /// The object's index in the scene.
    pub object: u32,
    /// The index of the material of the part that is hit.
    pub material: u32,
    /// Which of the shapes nested in the object's, and which part of the innermost.
    pub path: PartPath,
    /// The hit point.
    pub point: Point,
    /// Bound of the distance between the point and the true surface.
    pub error: f64,
    /// The true normal.
    pub normal: Normal,
    /// The normal used for shading.
    pub shading: Normal,
    /// Whether the ray met the side the normal points to.
    pub front: bool,
    /// The angle of incidence: between the ray and the true normal, in degrees from 0 to 90.
    pub angle_of_incidence: f64,
    /// How light divides there, if the surface refracts.
    pub optics: Option<Optics>,
    /// Whether its material shines.
    pub is_emissive: bool,
    /// Whether the object may shine: not while it is the lamp of a light that is off.
    pub shines: bool,
    /// The cosine between the true normal and the direction to the viewer; of a two-sided surface, not
    /// negative.
    pub cos_o: f64,
    /// The values of its material's textures there.
    pub textures: Vec<RecordedTexture>,
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

impl RecordedHit {
    fn of(hit: &Hit<'_>, ray: &Ray) -> Self {
        let Hit { t, surface, .. } = hit;
        let along = surface.normal.dot(ray.direction).abs();
        let across = Vector::from(surface.normal).cross(ray.direction).length();
        Self {
            t: *t,
            object: hit.object.index,
            material: hit.material.index,
            path: hit.path(),
            point: surface.point,
            error: surface.error,
            normal: surface.normal,
            shading: hit.shading_normal(),
            front: hit.front,
            angle_of_incidence: to_degrees(atan2(across, along)),
            optics: None,
            is_emissive: hit.material.recipe.emission().is_some(),
            shines: hit.object.shines,
            cos_o: ShadingPoint::new(hit, -ray.direction).cos_o,
            textures: recorded_textures(hit),
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

/// A term, and the ray it comes from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RecordedTerm {
    /// The term.
    pub term: Term,
    /// The ray whose radiance it weighs; `None` for a local term.
    pub child: Option<usize>,
}

impl RayTree {
    /// The rays; a parent comes before its children.
    pub fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    /// The camera's ray.
    ///
    /// # Panics
    /// If nothing was recorded.
    pub fn root(&self) -> &Node {
        &self.nodes[0]
    }

    /// Whether every ray was kept: at most about a million are.
    pub fn is_complete(&self) -> bool {
        !self.cut
    }

    /// The radiance of the ray by the law `T · Σ terms`, computed again from its terms.
    pub fn folded(&self, node: &Node) -> Rgb {
        let value = |recorded: &RecordedTerm| match recorded.child {
            Some(child) => recorded.term.weight * self.nodes[child].radiance,
            None => recorded.term.value,
        };
        node.transmittance * node.terms.iter().map(value).sum()
    }

    fn current(&mut self) -> &mut Node {
        let at = *self.open.last().expect("a ray has begun");
        &mut self.nodes[at]
    }
}

impl Recorder for RayTree {
    fn enter(&mut self, kind: RayKind, ray: &Ray, depth: u32, weight: Rgb) {
        let at = self.nodes.len();
        if self.beyond > 0 || at >= MAX_RAYS {
            self.beyond += 1;
            self.cut = true;
            return;
        }
        if !self.open.is_empty() {
            self.current().children.push(at);
        }
        self.open.push(at);
        self.nodes.push(Node {
            kind,
            ray: *ray,
            depth,
            weight,
            outcome: Outcome::Background,
            terms: Vec::new(),
            unlit: Vec::new(),
            transmittance: Rgb::WHITE,
            radiance: Rgb::BLACK,
            children: Vec::new(),
        });
    }

    fn outcome(&mut self, outcome: Outcome<&Hit<'_>>) {
        if self.beyond > 0 {
            return;
        }
        let node = self.current();
        node.outcome = outcome.described(|hit| RecordedHit::of(hit, &node.ray), |object| object);
    }

    fn surface(&mut self, point: &ShadingPoint<'_>, lobes: &Lobes) {
        if self.beyond > 0 {
            return;
        }
        if let Outcome::Hit { hit } = &mut self.current().outcome {
            hit.optics = Optics::of(point, lobes);
        }
    }

    fn unlit(&mut self, light: u32, why: impl FnOnce() -> Unlit) {
        if self.beyond == 0 {
            self.current().unlit.push((light, why()));
        }
    }

    fn term(&mut self, term: Term) {
        if self.beyond > 0 {
            return;
        }
        let from_ray = match term.source {
            TermSource::Traced { .. } => true,
            TermSource::Direct { traced, .. } | TermSource::Ambient { traced, .. } => traced,
            TermSource::Background { .. }
            | TermSource::Emission { .. }
            | TermSource::Light { .. } => false,
        };
        let node = self.current();
        let child = if from_ray { node.children.last().copied() } else { None };
        node.terms.push(RecordedTerm { term, child });
    }

    fn leave(&mut self, transmittance: Rgb, arriving: Rgb) {
        if self.beyond > 0 {
            self.beyond -= 1;
            return;
        }
        let node = self.current();
        node.transmittance = transmittance;
        node.radiance = arriving;
        self.open.pop();
    }
}
