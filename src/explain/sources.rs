//! The contribution of each light and each lobe to a pixel, and its variation between samples.
//!
//! The light of a sample is divided in two ways: by where light enters a path, and by how it leaves the
//! first hit towards the camera. Both times the parts add up to the sample.

use std::cmp::Ordering;

use serde::Serialize;

use crate::math::Ray;
use crate::render;
use crate::rgb::Rgb;
use crate::scene::Scene;
use crate::trace::{Outcome, RayKind, Recorder, Term, TermSource};
use crate::world::{Hit, World};

/// The contributions of the sources of light to a pixel. The means of each list add up to the pixel; the
/// largest standard deviation comes first.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Sources {
    /// By where light enters: a light contributes its samples at every hit, a lobe the emission and
    /// background that its rays hit.
    pub by_entry: Vec<SourceExplanation>,
    /// By the first hit: a light contributes its samples there, a lobe all light along its rays from there.
    pub by_first_hit: Vec<SourceExplanation>,
}

/// A source of light. `Name` says how a light is named.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(tag = "source", rename_all = "snake_case")]
pub enum Source<Name = u32> {
    /// Emission that the camera's ray meets.
    Emission,
    /// The background that the camera's ray meets.
    Background,
    /// The samples of a light.
    Light {
        /// The light.
        light: Name,
    },
    /// The rays of a lobe.
    Lobe {
        /// The name of its kind.
        lobe: &'static str,
    },
}

/// The contribution of a source to a pixel.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SourceExplanation {
    /// The source.
    #[serde(flatten)]
    pub source: Source<String>,
    /// The exposure time times the mean of its contributions to the samples.
    pub mean: Rgb,
    /// The exposure time times the standard deviation of its contributions to the samples. None for a
    /// single sample.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub standard_deviation: Option<Rgb>,
}

/// The largest number of rays of a pixel that is explained: some seconds.
const MAX_RAYS: u64 = 1 << 25;

/// A pixel has too many rays to be explained.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "pixel ({}, {}) has more than {MAX_RAYS} rays, too many to be explained; lower max_depth or the \
     number of samples",
    .0[0], .0[1]
)]
pub struct TooManyRays(pub [u32; 2]);

/// The radiances of all samples of a pixel, and the contribution of each source.
pub(super) fn of(
    scene: &Scene,
    world: &World,
    pixel: [u32; 2],
) -> Result<(Vec<Rgb>, Sources), TooManyRays> {
    let mut rays_left = MAX_RAYS;
    let (mut radiances, mut entries, mut first_hits) = (Vec::new(), Vec::new(), Vec::new());
    for index in 0..world.samples_per_pixel() {
        let (radiance, by_entry, by_first_hit) = sample(world, pixel, index, &mut rays_left);
        if rays_left == 0 {
            return Err(TooManyRays(pixel));
        }
        radiances.push(radiance);
        entries.push(by_entry);
        first_hits.push(by_first_hit);
    }
    let [by_entry, by_first_hit] = [entries, first_hits].map(|sums| explain(scene, world, &sums));
    Ok((radiances, Sources { by_entry, by_first_hit }))
}

/// A sample's radiance, and the contribution of each source: by entry, and by the first hit.
fn sample(world: &World, pixel: [u32; 2], index: u32, rays_left: &mut u64) -> (Rgb, Sums, Sums) {
    let mut recorder = SourceRecorder { rays_left: *rays_left, ..SourceRecorder::default() };
    let radiance = render::sample(world, pixel, index, &mut recorder);
    *rays_left = recorder.rays_left;
    let weight = render::camera_sample(world, pixel, index).map_or(0.0, |sample| sample.weight);
    let [by_entry, by_first_hit] =
        [recorder.finished, recorder.first_hit].map(|sums| sums.times(Rgb::grey(weight)));
    (radiance, by_entry, by_first_hit)
}

/// The sources of all samples, the largest standard deviation first.
fn explain(scene: &Scene, world: &World, samples: &[Sums]) -> Vec<SourceExplanation> {
    let of_sample =
        |sums: &Sums| -> Vec<Source> { sums.0.iter().map(|(source, _)| *source).collect() };
    let mut sources: Vec<Source> = samples.iter().flat_map(of_sample).collect();
    sources.sort();
    sources.dedup();
    let explained = sources.into_iter().map(|source| {
        let values: Vec<Rgb> = samples.iter().map(|sums| sums.get(source)).collect();
        SourceExplanation {
            source: source.named(|light| scene.lights[light as usize].name.clone()),
            mean: render::expose(world, values.iter().copied()),
            standard_deviation: deviation(&values).map(|it| world.view.exposure_time * it),
        }
    });
    let mut explained: Vec<_> = explained.collect();
    explained.sort_by(|a, b| b.size().partial_cmp(&a.size()).unwrap_or(Ordering::Equal));
    explained
}

/// The standard deviation, by n − 1; none of a single value.
pub(super) fn deviation(values: &[Rgb]) -> Option<Rgb> {
    let mean = render::mean(values.iter().copied());
    let squares: Rgb = values.iter().map(|&value| (value - mean) * (value - mean)).sum();
    (values.len() > 1).then(|| (squares / (values.len() - 1) as f64).map(f64::sqrt))
}

impl SourceExplanation {
    /// The order of the list: the standard deviation, then the mean, averaged over the channels.
    fn size(&self) -> (f64, f64) {
        let deviation = self.standard_deviation.unwrap_or(Rgb::BLACK);
        (deviation.average(), self.mean.average())
    }
}

impl<Name> Source<Name> {
    fn named<Other>(self, name: impl Fn(Name) -> Other) -> Source<Other> {
        match self {
            Self::Emission => Source::Emission,
            Self::Background => Source::Background,
            Self::Light { light } => Source::Light { light: name(light) },
            Self::Lobe { lobe } => Source::Lobe { lobe },
        }
    }
}

/// The radiance from each source.
#[derive(Default)]
struct Sums(Vec<(Source, Rgb)>);

impl Sums {
    fn add(&mut self, source: Source, value: Rgb) {
        match self.0.iter_mut().find(|(known, _)| *known == source) {
            Some((_, sum)) => *sum += value,
            None => self.0.push((source, value)),
        }
    }

    fn get(&self, source: Source) -> Rgb {
        self.0.iter().find(|(known, _)| *known == source).map_or(Rgb::BLACK, |(_, sum)| *sum)
    }

    fn times(self, factor: Rgb) -> Self {
        Self(self.0.into_iter().map(|(source, sum)| (source, factor * sum)).collect())
    }
}

/// Adds up the sources from the ends of the rays to the camera, without a tree.
#[derive(Default)]
struct SourceRecorder {
    /// The sums of the rays that have begun and not ended.
    open: Vec<Sums>,
    /// What arrives along the ray that ended last, by entry.
    finished: Sums,
    /// What arrives along the camera's ray, by the first hit.
    first_hit: Sums,
    /// The number of rays that may still be cast.
    rays_left: u64,
}

impl Recorder for SourceRecorder {
    fn enter(&mut self, _: RayKind, _: &Ray, _: u32, _: Rgb) {
        self.open.push(Sums::default());
        self.rays_left = self.rays_left.saturating_sub(1);
    }

    fn is_full(&self) -> bool {
        self.rays_left == 0
    }

    fn outcome(&mut self, _: Outcome<&Hit<'_>>) {}

    fn term(&mut self, term: Term) {
        let source = match term.source {
            TermSource::Emission { .. } => Source::Emission,
            TermSource::Background { .. } => Source::Background,
            TermSource::Ambient { light, .. }
            | TermSource::Direct { light, .. }
            | TermSource::Light { light } => Source::Light { light },
            TermSource::Traced { lobe, .. } => Source::Lobe { lobe: lobe.name() },
        };
        if self.open.len() == 1 {
            self.first_hit.add(source, term.value);
        }
        let sums = self.open.last_mut().expect("a ray has begun");
        if !matches!(source, Source::Lobe { .. }) {
            sums.add(source, term.value);
            return;
        }
        for (entry, arriving) in std::mem::take(&mut self.finished).0 {
            let met = matches!(entry, Source::Emission | Source::Background);
            sums.add(if met { source } else { entry }, term.weight * arriving);
        }
    }

    fn leave(&mut self, transmittance: Rgb, _: Rgb) {
        let sums = self.open.pop().expect("a ray has begun");
        self.finished = sums.times(transmittance);
        if self.open.is_empty() {
            self.first_hit = std::mem::take(&mut self.first_hit).times(transmittance);
        }
    }
}
