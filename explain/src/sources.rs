//! The contribution of each light and each lobe to a pixel, and its variation between samples.
//!
//! The light of a sample is divided in two ways: by where light enters a path, and by how it leaves
//! the first hit towards the camera. Both times the parts add up to the sample.

use std::sync::Arc;

use groundtruth::math::Ray;
use groundtruth::render;
use groundtruth::rgb::Rgb;
use groundtruth::trace::{Outcome, RayKind, Recorder, Term, TermSource};
use groundtruth::world::{Names, World};
use serde::Serialize;

/// The contributions of the sources of light to a pixel. The means of each list add up to the
/// pixel; the largest standard deviation comes first.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Sources {
    /// By where light enters: a light contributes its samples at every hit, a lobe the emission and
    /// background that its rays hit.
    pub by_entry: Vec<SourceExplanation>,
    /// By the first hit: a light contributes its samples there, a lobe all light along its rays
    /// from there.
    pub by_first_hit: Vec<SourceExplanation>,
}

/// A source of light.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(tag = "source", rename_all = "snake_case")]
pub enum Source {
    /// Emission that the camera's ray meets.
    Emission,
    /// The background that the camera's ray meets.
    Background,
    /// The samples of a light.
    Light {
        /// Its index in the scene.
        #[serde(skip)]
        index: u32,
        /// Its name.
        light: Arc<str>,
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
    pub source: Source,
    /// The exposure time times the mean of its contributions to the samples.
    pub mean: Rgb,
    /// The exposure time times the standard deviation of its contributions to the samples. None for
    /// a single sample.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub standard_deviation: Option<Rgb>,
}

impl Sources {
    /// What the samples have by entry and by first hit, times the exposure time.
    pub fn of(samples: [&[Sums]; 2], exposure_time: f64) -> Self {
        let [by_entry, by_first_hit] = samples.map(|sums| explain(exposure_time, sums));
        Self { by_entry, by_first_hit }
    }
}

/// The sources of all samples, the largest standard deviation first.
fn explain(exposure_time: f64, samples: &[Sums]) -> Vec<SourceExplanation> {
    let mut sources: Vec<&Source> =
        samples.iter().flat_map(|sums| sums.0.iter().map(|(source, _)| source)).collect();
    sources.sort();
    sources.dedup();
    let explained = sources.into_iter().map(|source| {
        let values: Vec<Rgb> = samples.iter().map(|sums| sums.get(source)).collect();
        SourceExplanation {
            source: source.clone(),
            mean: exposure_time * render::mean(values.iter().copied()),
            standard_deviation: deviation(&values).map(|it| exposure_time * it),
        }
    });
    let mut explained: Vec<_> = explained.collect();
    explained.sort_by(|a, b| {
        let ([a, of_a], [b, of_b]) = (a.size(), b.size());
        // an order of all numbers: a source of NaN is the first
        b.total_cmp(&a).then(of_b.total_cmp(&of_a))
    });
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
    fn size(&self) -> [f64; 2] {
        let deviation = self.standard_deviation.unwrap_or(Rgb::BLACK);
        [deviation.average(), self.mean.average()]
            .map(|x| if x.is_nan() { f64::NAN } else { x + 0.0 })
    }
}

/// The radiance of a sample from each source.
#[derive(Default)]
pub struct Sums(Vec<(Source, Rgb)>);

impl Sums {
    /// Adds what comes from a source.
    pub fn add(&mut self, source: Source, value: Rgb) {
        match self.0.iter_mut().find(|(known, _)| *known == source) {
            Some((_, sum)) => *sum += value,
            None => self.0.push((source, value)),
        }
    }

    fn get(&self, source: &Source) -> Rgb {
        self.0.iter().find(|(known, _)| known == source).map_or(Rgb::BLACK, |(_, sum)| *sum)
    }

    fn times(self, factor: Rgb) -> Self {
        Self(self.0.into_iter().map(|(source, sum)| (source, factor * sum)).collect())
    }
}

/// Adds up the sources from the ends of the rays to the camera, without a tree.
pub(super) struct SourceRecorder {
    names: Arc<Names>,
    /// The sums of the rays that have begun and not ended.
    open: Vec<Sums>,
    /// What arrives along the ray that ended last, by entry.
    finished: Sums,
    /// What arrives along the camera's ray, by the first hit.
    first_hit: Sums,
}

impl SourceRecorder {
    /// Records a sample of this world.
    pub(super) fn of(world: &World) -> Self {
        let [finished, first_hit] = [Sums::default(), Sums::default()];
        Self { names: Arc::clone(&world.names), open: Vec::new(), finished, first_hit }
    }

    /// What a sample has by entry and by first hit, with this weight from the filter.
    pub(super) fn weighed(self, weight: f64) -> [Sums; 2] {
        [self.finished, self.first_hit].map(|sums| sums.times(Rgb::grey(weight)))
    }
}

impl Recorder for SourceRecorder {
    fn enter(&mut self, _: RayKind, _: &Ray, _: u32, _: Rgb) {
        self.open.push(Sums::default());
    }

    fn term(&mut self, term: Term) {
        let source = match term.source {
            TermSource::Emission { .. } => Source::Emission,
            TermSource::Background { .. } => Source::Background,
            TermSource::Ambient { light, .. }
            | TermSource::Direct { light, .. }
            | TermSource::Light { light } => Source::Light {
                index: light,
                light: Arc::clone(&self.names.lights[light as usize]),
            },
            TermSource::Traced { lobe, .. } => Source::Lobe { lobe: lobe.name() },
        };
        if self.open.len() == 1 {
            self.first_hit.add(source.clone(), term.value);
        }
        let sums = self.open.last_mut().expect("a ray has begun");
        if !matches!(source, Source::Lobe { .. }) {
            sums.add(source, term.value);
            return;
        }
        for (entry, arriving) in std::mem::take(&mut self.finished).0 {
            let met = matches!(entry, Source::Emission | Source::Background);
            sums.add(if met { source.clone() } else { entry }, term.weight * arriving);
        }
    }

    fn leave(&mut self, _: Outcome, transmittance: Rgb, _: Rgb) {
        let sums = self.open.pop().expect("a ray has begun");
        self.finished = sums.times(transmittance);
        if self.open.is_empty() {
            self.first_hit = std::mem::take(&mut self.first_hit).times(transmittance);
        }
    }
}
