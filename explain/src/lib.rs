//! Why a pixel has its colour: the ray tree in words and numbers, for people and for scripts.
//!
//! A [`RecordedRay`] is explained by its contribution to the pixel, the lights that add nothing,
//! and why it is black. [`Sources`] are the contributions of each light and each lobe to the pixel,
//! over all samples. The command line prints them and the inspector shows them; neither computes
//! anything.

mod excess;
mod formula;
mod lines;
mod omissions;
mod optics;
mod outline;
mod page;
mod sources;
mod tree;
mod unlit;
mod unsent;
mod why_unlit;
mod written;

use serde::Serialize;

use groundtruth::render::{self, CameraSample, Renderer};
use groundtruth::rgb::Rgb;
use groundtruth::scene::Scene;
use groundtruth::trace::{RayBudget, TermSource, TooManyRays};
use groundtruth::world::World;
use sources::SourceRecorder;

pub use formula::{Formula, MISTAKEN};
pub use lines::{quoted, unblocked};
pub use omissions::omissions;
pub use optics::Optics;
pub use outline::{Outline, Row};
pub use page::{Shown, table};
pub use sources::{Source, SourceExplanation, Sources, Sums};
pub use tree::{RayTree, RecordedHit, RecordedRay, RecordedTerm, RecordedTexture};
pub use unlit::{Unlit, UnlitLight, lines};
pub use why_unlit::add_unlit;
pub use written::Factor;

/// The largest number of rays of a pixel that is explained: some seconds.
const MAX_RAYS: u64 = 1 << 23;

/// A pixel explained: its samples and their sum.
#[derive(Clone, Debug, Serialize)]
pub struct PixelExplanation {
    /// x right and y down from the top left, from 0.
    pub pixel: [u32; 2],
    /// What was ignored or clamped in the scene's files and what the tracer leaves out, a sentence
    /// each.
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
    /// The standard error of the mean for independent samples; the error of well-spread samples is
    /// smaller. None for a single sample.
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
    pub ray: Option<RecordedRay>,
}

/// Sentences for the user: what was ignored or clamped in the scene's files, which materials
/// reflect more light than they receive, and what the tracer leaves out.
pub fn notes(scene: &Scene, world: &World) -> Vec<String> {
    world.notes.iter().cloned().chain(excess::excess(scene)).chain(omissions(world)).collect()
}

/// Explains a pixel (x right, y down): one of its samples, or all.
///
/// # Errors
/// If its samples have so many rays that tracing them would take minutes or more.
pub fn pixel(
    scene: &Scene,
    renderer: &impl Renderer,
    pixel: [u32; 2],
    only: Option<u32>,
) -> Result<PixelExplanation, TooManyRays> {
    let world = renderer.world();
    let mut budget = RayBudget::up_to(MAX_RAYS);
    let (mut samples, mut radiances) = (Vec::new(), Vec::new());
    let [mut by_entry, mut by_first_hit] = [Vec::new(), Vec::new()];
    for index in 0..world.samples_per_pixel() {
        let (mut sources, budget) = (SourceRecorder::of(world), &mut budget);
        let (radiance, sources, tree) = if only.is_none_or(|only| only == index) {
            let mut both = (sources, RayTree::of(world));
            let radiance = renderer.sample(pixel, index, &mut both, budget);
            (radiance, both.0, Some(both.1))
        } else {
            (renderer.sample(pixel, index, &mut sources, budget), sources, None)
        };
        budget.check(|| format!("pixel ({}, {})", pixel[0], pixel[1]))?;
        let camera = render::camera_sample(world, pixel, index);
        let weight = camera.as_ref().map_or(0.0, |camera| camera.weight);
        let [entry, first_hit] = sources.weighed(weight);
        by_entry.push(entry);
        by_first_hit.push(first_hit);
        radiances.push(radiance);
        samples.extend(tree.map(|tree| explained((scene, world), camera, index, radiance, tree)));
    }
    let exposure_time = world.view.exposure_time;
    Ok(PixelExplanation {
        pixel,
        notes: notes(scene, world),
        samples_per_pixel: world.samples_per_pixel(),
        exposure_time,
        samples,
        statistics: Statistics::of(&radiances),
        sources: Sources::of([&by_entry, &by_first_hit], exposure_time),
        radiance: render::expose(world, radiances.iter().copied()),
        radiances,
    })
}

/// Explains one sample of a pixel.
pub fn sample(scene: &Scene, world: &World, pixel: [u32; 2], index: u32) -> SampleExplanation {
    let mut tree = RayTree::of(world);
    let radiance = render::sample(world, pixel, index, &mut tree);
    explained((scene, world), render::camera_sample(world, pixel, index), index, radiance, tree)
}

fn explained(
    (scene, world): (&Scene, &World),
    camera: Option<CameraSample>,
    index: u32,
    radiance: Rgb,
    tree: RayTree,
) -> SampleExplanation {
    let complete = tree.is_complete();
    let Some(CameraSample { pixel, film, lens, weight, .. }) = camera else {
        let (film, lens, weight, ray) = (None, None, 0.0, None);
        return SampleExplanation { index, film, lens, weight, radiance, complete, ray };
    };
    let mut ray = tree.into_root();
    if let Some(root) = &mut ray {
        add_unlit((world, &scene.lights), world.draws(pixel, index), root);
        let weight = Rgb::grey(weight);
        Explaining { scene, sample: weight * root.radiance }.explain(root, weight);
    }
    SampleExplanation { index, film: Some(film), lens, weight, radiance, complete, ray }
}

impl Statistics {
    /// The statistics of at least one sample.
    pub fn of(radiances: &[Rgb]) -> Self {
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
    /// The radiance of the sample.
    sample: Rgb,
}

impl Explaining<'_> {
    /// A contribution as a part of the sample.
    fn share(&self, contribution: Rgb) -> f64 {
        match self.sample.is_black() {
            true => 0.0,
            false => contribution.average() / self.sample.average(),
        }
    }

    /// Works out the contributions of a ray and of those after it, and why it is black.
    /// `throughput` is the weight at the eye of the radiance that arrives at the ray's origin.
    fn explain(&self, ray: &mut RecordedRay, throughput: Rgb) {
        if let Some(optics) = ray.hit.as_mut().and_then(|hit| hit.optics.as_mut()) {
            optics.scales_radiance = self.scene.transparency.scales_radiance;
        }
        // the throughput of light that leaves the surface: through the medium too
        let leaving = throughput * ray.transmittance;
        for term in &mut ray.terms {
            term.contribution = leaving * term.value;
            term.share = self.share(term.contribution);
        }
        for child in &mut ray.children {
            // one shadow ray serves several lobes: their weights add up
            let terms = ray.terms.iter().filter(|term| term.ray == Some(child.number));
            let weight: Rgb = terms.clone().map(|term| term.weight).sum();
            let mut traced = terms.filter(|it| matches!(it.source, TermSource::Traced { .. }));
            if let Some(term) = traced.next() {
                // a renderer that alters terms knows it only after the ray
                child.weight = term.weight;
            }
            self.explain(child, leaving * weight);
        }
        let own_terms = ray.terms.iter().filter(|term| term.ray.is_none());
        ray.own_contribution = leaving * own_terms.map(|term| term.value).sum::<Rgb>();
        ray.contribution = throughput * ray.radiance;
        ray.share = self.share(ray.contribution);
        ray.black = self.black(ray);
    }
}
