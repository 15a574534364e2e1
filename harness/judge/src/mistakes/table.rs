//! Measures which scenes of the gallery show which mistakes.

use std::path::Path;

use gallery::Entry;
use groundtruth::invalid::Invalid;
use groundtruth::rgb::Rgb;
use groundtruth::scene::Scene;
use groundtruth::world::DEFAULT_SEED;

use super::{Mistake, Probed, all, replicas};

/// The width of the measured pictures, in pixels.
pub const WIDTH: u32 = 48;
/// The most samples of their pixels.
pub const SAMPLES: u32 = 4;
/// A pixel is changed if a channel changes by more than this, relative to the larger of the channel and the picture's
/// mean.
pub const CHANGE: f64 = 0.02;
/// A scene shows a mistake if at least this share of its pixels is changed.
pub const SHARE: f64 = 0.005;

/// How much a mistake changes a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Effect {
    /// The share of changed pixels.
    pub share: f64,
    /// The largest relative change of a channel.
    pub largest: f64,
}

impl Effect {
    /// The effect of replacing a picture by another of its size.
    pub fn of(ours: &[Rgb], theirs: &[Rgb]) -> Self {
        let changes = changes(ours, theirs);
        let count = changes.iter().filter(|change| **change > CHANGE).count();
        let largest = changes.iter().copied().fold(0.0, f64::max);
        Self { share: count as f64 / changes.len() as f64, largest }
    }

    /// Whether it is large enough to be seen.
    pub fn is_shown(&self) -> bool {
        self.share >= SHARE
    }
}

/// The largest relative change of a channel of each pixel of a picture that is replaced by another of its size.
pub(super) fn changes(ours: &[Rgb], theirs: &[Rgb]) -> Vec<f64> {
    let mean = ours.iter().flat_map(|it| it.to_array()).sum::<f64>() / (3 * ours.len()) as f64;
    let change = |(a, b): (&Rgb, &Rgb)| {
        let [a, b] = [a, b].map(|it| it.to_array());
        let relative = |i: usize| match (b[i] - a[i]).abs() {
            0.0 => 0.0,
            difference => difference / a[i].max(mean),
        };
        relative(0).max(relative(1)).max(relative(2))
    };
    ours.iter().zip(theirs).map(change).collect()
}

/// A scene so many pixels wide, with at most so many samples.
pub fn sized(mut scene: Scene, width: u32, samples: u32) -> Scene {
    let image = &mut scene.image;
    let height = (u64::from(image.height) * u64::from(width)).div_ceil(u64::from(image.width));
    image.resize(width, height.max(1) as u32);
    image.samples = image.samples.min(samples);
    scene
}

/// Those of these mistakes that a scene shows, in the size of the table, with their effects. Files that the scene names are in
/// the folder.
///
/// # Errors
/// If the scene has no world.
pub fn shown(
    mistakes: &[&'static Mistake],
    scene: &Scene,
    folder: &Path,
) -> Result<Vec<(&'static Mistake, Effect)>, Invalid> {
    let small = sized(scene.clone(), WIDTH, SAMPLES);
    let Probed { ours, altered } = replicas(mistakes, (&small, folder, DEFAULT_SEED))?;
    let effects = altered.iter().map(|(it, theirs)| (*it, Effect::of(&ours, theirs)));
    Ok(effects.filter(|(_, effect)| effect.is_shown()).collect())
}

/// The lines of a scene in the table: `scene,mistake,share,largest`.
///
/// # Errors
/// As [`shown`].
pub fn lines(entry: &Entry) -> Result<String, Invalid> {
    let line = |(mistake, effect): &(&Mistake, Effect)| {
        let Effect { share, largest } = effect;
        format!("{},{},{share:.4},{largest:.3e}\n", entry.name, mistake.name)
    };
    Ok(shown(&all(), &(entry.build)(), Path::new(""))?.iter().map(line).collect())
}
