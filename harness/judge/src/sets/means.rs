//! The means of the picture and of its regions, before and after.

use serde::Serialize;
use statrs::distribution::{ContinuousCDF, Normal};

use super::{Pairs, SetEvidence, Sets, SumKind};
use crate::verdict::{Answer, Areas};
use statistics::means::{difference, interval};

/// The mean of an area before and after, over all channels.
#[derive(Clone, Debug, Serialize)]
pub struct AreaMeans {
    /// The area.
    pub name: String,
    /// The mean before.
    pub before: f64,
    /// The mean after.
    pub after: f64,
    /// The difference as a part of the mean before, and the ends of its interval; `None` if the mean before is black.
    pub relative: Option<[f64; 3]>,
}

impl AreaMeans {
    /// Of the whole picture and of each region; all intervals together hold with the probability 1 − `level`.
    pub fn of(sets: &Sets, pairs: &Pairs, evidence: &SetEvidence<'_>, level: f64) -> Vec<Self> {
        let largest = sets.areas.levels() - 1;
        let whole = (SumKind::Tiles(largest), 0, "the whole picture".to_owned());
        let regions = sets.areas.objects.iter().enumerate();
        let regions = regions.map(|(index, (name, _))| (SumKind::Regions, index, name.to_string()));
        let is_divided = sets.areas.objects.len() > 1;
        let all: Vec<_> = std::iter::once(whole).chain(regions.filter(|_| is_divided)).collect();
        let confidence = 1.0 - level / all.len() as f64;
        let of = |(level, number, name): &(SumKind, usize, String)| {
            let pixels =
                sets.areas.pixels(evidence.sums.area(evidence.sums.places(*level, *number)[0]));
            let [before, after] =
                [&sets.before, &sets.after].map(|set| Areas::means(set, &pixels, 0..3));
            let of_pairs = pairs.0.iter().map(|[a, b]| after[*b] - before[*a]);
            let apart = match &*of_pairs.collect::<Vec<f64>>() {
                [] | [_] => difference(&after, &before, confidence),
                apart => interval(apart, confidence),
            };
            let average = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
            let [before, after] = [average(&before), average(&after)];
            let apart = apart.unwrap_or_else(|| {
                let deviation =
                    evidence.deviation_of_one(*level, *number) / (3 * pixels.len()) as f64;
                let half = Normal::standard().inverse_cdf(0.5 + 0.5 * confidence) * deviation;
                [0.0, -half, half].map(|it| after - before + it)
            });
            let relative = (before > 0.0).then(|| apart.map(|apart| apart / before));
            Self { name: name.clone(), before, after, relative }
        };
        all.iter().map(of).collect()
    }

    /// Whether all means are within this part of those before.
    pub fn within(all: &[Self], margin: f64) -> Answer {
        let apart = |means: &Self| match means.relative {
            Some([_, low, high]) => [low.max(-high), high.max(-low)],
            None if means.after == means.before => [0.0; 2],
            None => [f64::INFINITY; 2],
        };
        Answer::of(all.iter().map(apart), margin)
    }
}
