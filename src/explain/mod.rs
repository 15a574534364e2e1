//! Why a pixel has its colour: the ray tree in words and numbers, for people and for scripts.
//!
//! A [`RayExplanation`] is a recorded ray with names instead of indices, and its contribution to the pixel.
//! [`Sources`] are the contributions of each light and each lobe to the pixel, over all samples. The
//! command line prints them and the inspector shows them; neither computes anything.

mod omissions;
mod outline;
mod sources;
mod text;
mod unlit;

use serde::Serialize;

use crate::render::{self, CameraSample};
use crate::rgb::Rgb;
use crate::scene::Scene;
use crate::shapes::PartPath;
use crate::trace::{Optics, Outcome, RayKind, RayTree, RecordedHit, RecordedTexture, TermSource};
use crate::world::World;

pub use omissions::omissions;
pub use outline::{Outline, Row};
pub use sources::{Source, SourceExplanation, Sources, TooManyRays};
pub use text::{brief, count, percent, short, table, unblocked};
pub use unlit::{UnlitLight, lines};

/// A pixel explained: its samples and their sum.
#[derive(Clone, Debug, Serialize)]
pub struct PixelExplanation {
    /// x right and y down from the top left, from 0.
    pub pixel: [u32; 2],
    /// What was ignored or clamped in the scene's files and what the tracer leaves out, a sentence each.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub notes: Vec<String>,
    /// The number of samples of the pixel.
    pub samples_per_pixel: u32,
    /// Multiplies the mean of the samples.
    pub exposure_time: f64,
    /// The explained samples: all of them, or those asked for.
    pub samples: Vec<SampleExplanation>,
    /// The contribution of each sample to the mean, also of those not explained.
    #[serde(skip)]
    pub radiances: Vec<Rgb>,
    /// How the samples are spread.
    pub statistics: Statistics,
    /// The contributions of each light and each lobe.
    pub sources: Sources,
    /// The pixel: the exposure time times the mean of all its samples.
    pub radiance: Rgb,
}

/// How the samples of a pixel are spread.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Statistics {
    /// The mean.
    pub mean: Rgb,
    /// The standard error of the mean for independent samples; the error of well-spread samples is smaller.
    /// None for a single sample.
    pub standard_error: Option<Rgb>,
    /// The index of the sample with the least radiance, averaged over the channels.
    pub least: u32,
    /// The index of the sample with the greatest radiance.
    pub greatest: u32,
}

/// One sample explained.
#[derive(Clone, Debug, Serialize)]
pub struct SampleExplanation {
    /// Its index.
    pub index: u32,
    /// Where it is on the view plane, in world units from its centre; `None` in the gap of a stereo
    /// pair.
    pub film: Option<[f64; 2]>,
    /// Where it is on the lens, in the unit disk, if the camera has one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub lens: Option<[f64; 2]>,
    /// Its weight, from the filter.
    pub weight: f64,
    /// Its contribution to the mean.
    pub radiance: Rgb,
    /// Whether all its rays are shown; a tree of more than a million is cut off.
    pub complete: bool,
    /// The camera's ray and all rays after it; `None` where the camera sees nothing.
    pub ray: Option<RayExplanation>,
}

/// One ray explained.
#[derive(Clone, Debug, Serialize)]
pub struct RayExplanation {
    /// Its number in the tree: 0 is the camera's ray, the others follow in the order in which they
    /// were cast.
    pub number: usize,
    /// The number of the ray that sent it; `None` for the camera's. As data, children stand in their parent.
    #[serde(skip)]
    pub parent: Option<usize>,
    /// What it is for.
    #[serde(flatten)]
    pub kind: RayKind<String>,
    /// Edges before it; 0 for the camera's ray.
    pub depth: u32,
    /// Where it starts.
    pub origin: [f64; 3],
    /// Where it goes.
    pub direction: [f64; 3],
    /// What it counts for the ray before it.
    pub weight: Rgb,
    /// What became of it.
    #[serde(flatten)]
    pub outcome: Outcome<HitExplanation, String>,
    /// What leaves the surface towards the ray's origin, term by term.
    pub terms: Vec<TermExplanation>,
    /// The lights of the scene that add nothing at its hit.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub unlit: Vec<UnlitLight>,
    /// Which factors are 0, in one sentence, if it brings no light and is no shadow ray.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub black: Option<String>,
    /// The share that the medium lets through.
    pub transmittance: Rgb,
    /// What arrives at its origin: the transmittance times the sum of the terms.
    pub radiance: Rgb,
    /// What it adds to its sample, with all rays after it.
    pub contribution: Rgb,
    /// What of that comes from its own terms, without another ray.
    pub own_contribution: Rgb,
    /// The part of its sample that it adds, from 0 to 1, averaged over the channels; 0 in a black
    /// sample.
    pub share: f64,
    /// The rays it sent, in order.
    pub children: Vec<RayExplanation>,
}

/// What a ray hit.
#[derive(Clone, Debug, Serialize)]
pub struct HitExplanation {
    /// The object.
    pub object: String,
    /// Its material.
    pub material: String,
    /// Which of the shapes nested in the object's, and which part of the innermost.
    #[serde(skip_serializing_if = "PartPath::is_empty")]
    pub path: PartPath,
    /// Along the ray.
    pub t: f64,
    /// Where.
    pub point: [f64; 3],
    /// How far the point may be from the true surface.
    pub error: f64,
    /// The true normal.
    pub normal: [f64; 3],
    /// The normal used for shading.
    pub shading_normal: [f64; 3],
    /// Whether the ray met the side the normal points to.
    pub front: bool,
    /// Between the ray and the true normal, in degrees from 0 to 90.
    pub angle_of_incidence: f64,
    /// How light divides there, if the surface refracts.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub optics: Option<Optics>,
    /// What the textures of its material are there.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub textures: Vec<RecordedTexture>,
    /// Whether it is the lamp of an area light that is off, and so does not shine.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub is_switched_off: bool,
}

/// One term of what leaves a surface: `weight · arriving`.
#[derive(Clone, Debug, Serialize)]
pub struct TermExplanation {
    /// Where it comes from.
    #[serde(flatten)]
    pub source: TermSource<String>,
    /// What the arriving light is multiplied by.
    pub weight: Rgb,
    /// The light that arrives.
    pub arriving: Rgb,
    /// What it adds.
    pub value: Rgb,
    /// What it adds to its sample.
    pub contribution: Rgb,
    /// The part of its sample that it adds, from 0 to 1, averaged over the channels; 0 in a black
    /// sample.
    pub share: f64,
    /// The number of the ray that the light comes along, if it took one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ray: Option<usize>,
}

/// Sentences for the user: what was ignored or clamped in the scene's files, and what the tracer leaves out.
pub fn notes(world: &World) -> Vec<String> {
    world.notes.iter().cloned().chain(omissions(world)).collect()
}

/// Explains a pixel (x right, y down): one of its samples, or all.
///
/// # Errors
/// If its samples have so many rays that tracing them would take minutes or more.
pub fn pixel(
    scene: &Scene,
    world: &World,
    pixel: [u32; 2],
    only: Option<u32>,
) -> Result<PixelExplanation, TooManyRays> {
    // first, because it ends if there are too many rays
    let (radiances, sources) = sources::of(scene, world, pixel)?;
    let count = world.samples_per_pixel();
    let explained = only.map_or(0..count, |index| index..index + 1);
    let samples = explained.map(|index| sample(scene, world, pixel, index)).collect();
    Ok(PixelExplanation {
        pixel,
        notes: notes(world),
        samples_per_pixel: count,
        exposure_time: world.view.exposure_time,
        samples,
        statistics: Statistics::of(&radiances),
        sources,
        radiance: render::expose(world, radiances.iter().copied()),
        radiances,
    })
}

/// Explains one sample of a pixel.
pub fn sample(scene: &Scene, world: &World, pixel: [u32; 2], index: u32) -> SampleExplanation {
    let mut tree = RayTree::default();
    let radiance = render::sample(world, pixel, index, &mut tree);
    let complete = tree.is_complete();
    let Some(CameraSample { film, lens, weight, ray, .. }) =
        render::camera_sample(world, pixel, index)
    else {
        let (film, lens, weight, ray) = (None, None, 0.0, None);
        return SampleExplanation { index, film, lens, weight, radiance, complete, ray };
    };
    let ray = ray.map(|_| Explaining { scene, tree: &tree, weight: Rgb::grey(weight) }.root());
    SampleExplanation { index, film: Some(film), lens, weight, radiance, complete, ray }
}

/// Explains a recorded tree.
pub fn ray(scene: &Scene, tree: &RayTree) -> RayExplanation {
    Explaining { scene, tree, weight: Rgb::WHITE }.root()
}

impl Statistics {
    /// The statistics of at least one sample.
    fn of(radiances: &[Rgb]) -> Self {
        let root = (radiances.len() as f64).sqrt();
        let standard_error = sources::deviation(radiances).map(|deviation| deviation / root);
        let ranked = || (0_u32..).zip(radiances.iter().map(|radiance| radiance.average()));
        let by_value = |a: &(u32, f64), b: &(u32, f64)| a.1.total_cmp(&b.1);
        let [least, greatest] = [ranked().min_by(by_value), ranked().max_by(by_value)]
            .map(|found| found.map_or(0, |(index, _)| index));
        let mean = render::mean(radiances.iter().copied());
        Self { mean, standard_error, least, greatest }
    }
}

struct Explaining<'a> {
    scene: &'a Scene,
    tree: &'a RayTree,
    /// The weight of the sample, from the filter.
    weight: Rgb,
}

impl Explaining<'_> {
    fn root(&self) -> RayExplanation {
        self.ray(0, None, self.weight)
    }

    /// A contribution as a part of the sample.
    fn share(&self, contribution: Rgb) -> f64 {
        let sample = self.weight * self.tree.root().radiance;
        if sample.is_black() { 0.0 } else { contribution.average() / sample.average() }
    }

    /// Explains a ray and those after it. `throughput` is the weight at the eye of the radiance that
    /// arrives at the ray's origin.
    fn ray(&self, number: usize, parent: Option<usize>, throughput: Rgb) -> RayExplanation {
        let node = &self.tree.nodes()[number];
        // one shadow ray serves several lobes: their weights add up
        let weight_of = |child: usize| -> Rgb {
            let terms = node.terms.iter().filter(|recorded| recorded.child == Some(child));
            terms.map(|recorded| recorded.term.weight).sum()
        };
        // the throughput of light that leaves the surface: through the medium too
        let leaving = throughput * node.transmittance;
        let children =
            node.children.iter().map(|&c| self.ray(c, Some(number), leaving * weight_of(c)));
        let terms = node.terms.iter().map(|recorded| TermExplanation {
            source: recorded.term.source.named(|light| self.light(light)),
            weight: recorded.term.weight,
            arriving: recorded.term.arriving,
            value: recorded.term.value,
            contribution: leaving * recorded.term.value,
            share: self.share(leaving * recorded.term.value),
            ray: recorded.child,
        });
        let own_terms = node.terms.iter().filter(|recorded| recorded.child.is_none());
        let own: Rgb = own_terms.map(|recorded| recorded.term.value).sum();
        let contribution = throughput * node.radiance;
        let unlit = self.unlit(node);
        RayExplanation {
            number,
            parent,
            kind: node.kind.named(|light| self.light(light)),
            // a shadow ray is recorded with the depth of the hit that it leaves
            depth: parent.map_or(0, |parent| self.tree.nodes()[parent].depth + 1),
            origin: node.ray.origin.into(),
            direction: node.ray.direction.into(),
            weight: node.weight,
            outcome: node.outcome.clone().described(|hit| self.hit(hit), |it| self.object(it)),
            terms: terms.collect(),
            black: self.black(node, &unlit),
            unlit,
            transmittance: node.transmittance,
            radiance: node.radiance,
            contribution,
            own_contribution: leaving * own,
            share: self.share(contribution),
            children: children.collect(),
        }
    }

    fn hit(&self, hit: RecordedHit) -> HitExplanation {
        HitExplanation {
            object: self.object(hit.object),
            material: self.scene.materials[hit.material as usize].name.clone(),
            path: hit.path,
            t: hit.t,
            point: hit.point.into(),
            error: hit.error,
            normal: hit.normal.into(),
            shading_normal: hit.shading.into(),
            front: hit.front,
            angle_of_incidence: hit.angle_of_incidence,
            optics: hit.optics,
            textures: hit.textures,
            is_switched_off: !hit.shines,
        }
    }

    fn object(&self, index: u32) -> String {
        self.scene.objects[index as usize].name.clone()
    }

    fn light(&self, index: u32) -> String {
        self.scene.lights[index as usize].name.clone()
    }
}
