//! Pictures of any scene by any renderer, before and after a change, with other seeds: is their mean the same?
//!
//! No scene of ours is needed, and nothing of ours is rendered. If the change did nothing, it is chance which pictures are
//! before and which after: the difference that is there is held against those of other divisions of the same pictures, in
//! areas of every size ([`AreaSums`], [`Rank`]). Pictures with equal seeds are compared in pairs, of which the noise is gone but
//! for what the change did to it; few pictures by tests of means, and one picture a side by its own details ([`Method`]).

mod divisions;
mod evidence;
mod fixed;
mod means;
mod noise;
mod odd;
mod page;
mod power;
mod sums;
mod text;

use std::collections::BTreeMap;
use std::sync::atomic::{AtomicBool, Ordering};

use serde::Serialize;

use crate::verdict::{Answer, Areas};
use pictures::compare::{Decoded, Picture, Transfer, changes_that_explain, distance_of};

pub use divisions::{Divisions, Rank};
pub use evidence::Reason;
pub use means::AreaMeans;
pub use noise::{Noise, Pairs};
pub use odd::Odd;
pub use page::page;
pub use power::Power;
pub use sums::{AreaSums, Design, Pattern, SumKind, SummedPictures};

use evidence::{Found, SetEvidence};

/// Who follows a comparison of two sets, and may end it.
#[derive(Clone, Copy)]
pub struct Watch<'a> {
    /// Called for each division that is tried, on any thread.
    pub tried: &'a (dyn Fn() + Sync),
    /// Set to end early.
    pub interrupted: &'a AtomicBool,
}

impl Watch<'_> {
    fn is_interrupted(&self) -> bool {
        self.interrupted.load(Ordering::Relaxed)
    }
}

/// The pictures of one scene before and after a change.
#[derive(Clone, Debug)]
pub struct Sets {
    /// Their tiles, and the regions that the user gave.
    pub areas: Areas,
    /// The radiances of each picture before, three a pixel, row by row from the top left.
    pub before: Vec<Vec<f32>>,
    /// The same after.
    pub after: Vec<Vec<f32>>,
    /// The variance of each value by rounding when it was stored.
    pub rounding: Vec<f64>,
}

/// More colours in a picture of regions are no regions.
const MOST_REGIONS: usize = 4096;

impl Sets {
    /// The sets of these pictures, all of one size; `regions` has a colour for each region.
    ///
    /// # Errors
    /// If it is of another size, or has too many colours.
    pub fn new(
        [before, after]: [Vec<Picture>; 2],
        regions: Option<&Picture>,
    ) -> Result<Self, String> {
        let size = before[0].size.map(|side| side as usize);
        let decoded = Decoded::new(&before[0]);
        let rounding = |value: &f32| {
            let [low, high] = decoded.interval(*value);
            // evenly spread over the interval
            Some((high - low) * (high - low) / 12.0).filter(|it| it.is_finite()).unwrap_or(0.0)
        };
        let rounding = before[0].values.as_flattened().iter().map(rounding).collect();
        let areas = match regions {
            None => Areas::tiles(size),
            Some(regions) => regions_of(regions, before[0].size)?,
        };
        Ok(Self {
            areas,
            before: before.into_iter().map(radiances).collect(),
            after: after.into_iter().map(radiances).collect(),
            rounding,
        })
    }

    /// The numbers of pictures before and after.
    pub fn sizes(&self) -> [usize; 2] {
        [self.before.len(), self.after.len()]
    }

    /// All pictures, those before first.
    fn all(&self) -> impl Iterator<Item = &Vec<f32>> {
        self.before.iter().chain(&self.after)
    }

    /// The mean of a set.
    fn mean(&self, set: &[Vec<f32>]) -> Vec<f64> {
        let mut mean = vec![0.0; self.rounding.len()];
        for picture in set {
            mean.iter_mut().zip(picture).for_each(|(sum, x)| *sum += f64::from(*x));
        }
        mean.iter_mut().for_each(|sum| *sum /= set.len() as f64);
        mean
    }

    /// The mean of all pictures.
    fn mean_of_all(&self) -> Vec<f64> {
        let [n, m] = self.sizes().map(|count| count as f64);
        let [before, after] = [&self.before, &self.after].map(|set| self.mean(set));
        before.iter().zip(after).map(|(a, b)| (n * a + m * b) / (n + m)).collect()
    }

    /// Values that are no numbers in some picture become 0 in all; whether all do.
    fn without_not_finite(mut self) -> (Self, bool) {
        let is_finite = |index: usize| self.all().all(|picture| picture[index].is_finite());
        let bad: Vec<usize> = (0..self.rounding.len()).filter(|index| !is_finite(*index)).collect();
        for picture in self.before.iter_mut().chain(&mut self.after) {
            bad.iter().for_each(|index| picture[*index] = 0.0);
        }
        let are_all = bad.len() == self.rounding.len();
        (self, are_all)
    }

    /// Whether all pictures of each set have the same values: there is no noise, or only one picture.
    fn is_fixed(&self) -> bool {
        let is_same = |set: &[Vec<f32>]| set.iter().all(|picture| *picture == set[0]);
        is_same(&self.before) && is_same(&self.after)
    }
}

/// The radiances of a picture, in the place of its values.
fn radiances(mut picture: Picture) -> Vec<f32> {
    if picture.step.is_some() {
        let decoded = Decoded::new(&picture);
        let linear = |color: &[f32; 3]| decoded.linear(*color).map(|value| value as f32);
        picture.values = picture.values.iter().map(linear).collect();
    }
    picture.values.into_flattened()
}

/// The regions of a picture with a colour for each.
fn regions_of(picture: &Picture, size: [u32; 2]) -> Result<Areas, String> {
    let ([width, height], [w, h]) = (picture.size, size);
    if picture.size != size {
        return Err(format!(
            "it has {width} × {height} pixels, the pictures {w} × {h}; each pixel has a region"
        ));
    }
    let mut areas = Areas::tiles(size.map(|side| side as usize));
    areas.objects.clear();
    let mut known: BTreeMap<[u32; 3], u32> = BTreeMap::new();
    for (pixel, color) in picture.values.iter().enumerate() {
        let next = known.len() as u32;
        let region = *known.entry(color.map(f32::to_bits)).or_insert(next);
        if region == next {
            if known.len() > MOST_REGIONS {
                return Err(format!(
                    "it has more than {MOST_REGIONS} colours; a picture of regions has one for each, without smooth edges"
                ));
            }
            let [r, g, b] = color.map(|value| (255.0 * value).round() as u8);
            areas.objects.push((format!("region #{r:02x}{g:02x}{b:02x}").into(), 0));
        }
        areas.objects[region as usize].1 += 1;
        areas.object_of[pixel] = region;
    }
    Ok(areas)
}

/// How two sets were compared.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Method {
    /// By rounding: there is no noise.
    Rounding,
    /// By pictures with values that are no numbers, or far out of their set: only one side has some.
    Odd,
    /// By other divisions of the pictures.
    Divisions {
        /// Their number.
        count: usize,
        /// Whether there are no others.
        is_all: bool,
    },
    /// By other signs of the differences of pairs with equal seeds.
    Signs {
        /// The number of pairs.
        pairs: usize,
        /// The number of signs.
        count: usize,
        /// Whether there are no others.
        is_all: bool,
    },
    /// By tests of the means of areas.
    Areas {
        /// Why not by divisions.
        because: Reason,
    },
    /// By tests of the mean differences of pairs with equal seeds, in areas.
    PairedAreas {
        /// The number of pairs.
        pairs: usize,
        /// Why not by signs.
        because: Reason,
    },
    /// By the finest details of one difference.
    OnePicture,
}

/// What is said of two sets.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum SetsDecision {
    /// No difference of the means is seen.
    Agree,
    /// The means differ.
    Differ,
    /// No difference is seen, but there is one picture a side, whose noise is only estimated, or no number on both sides.
    CannotTell,
}

/// An area in which sets differ.
#[derive(Clone, Debug, Serialize)]
pub struct AreaDifference {
    /// What it is.
    pub name: String,
    /// Left column, top row, columns, rows.
    pub bounds: [usize; 4],
    /// The mean over its pixels before, of its channel or all.
    pub before: f64,
    /// The same after.
    pub after: f64,
    /// Whether it is this mean that differs, and not what the name says.
    pub is_mean: bool,
}

/// What is known of two sets of pictures.
#[derive(Clone, Debug, Serialize)]
pub struct SetsVerdict {
    /// What follows.
    pub decision: SetsDecision,
    /// The numbers of pictures before and after.
    pub pictures: [usize; 2],
    /// How it was found.
    pub method: Method,
    /// The probability that sets without a difference of their means are so far apart; of no noise, 0 or 1.
    pub probability: f64,
    /// The probability of a false alarm that was allowed.
    pub level: f64,
    /// Where the means differ: areas that have no pixel in common, the farthest first.
    pub areas: Vec<AreaDifference>,
    /// The simple change of all pictures that explains the difference.
    pub explained_by: Option<String>,
    /// The mean of the whole picture and of each region.
    pub means: Vec<AreaMeans>,
    /// The noise after, held against that before; `None` if there is one picture a side, or no noise.
    pub noise: Option<Noise>,
    /// What stands out in each picture, before first.
    pub odd: Vec<Odd>,
    /// What would have been seen, if nothing is.
    pub power: Option<Power>,
    /// The margin, and whether all means are within it.
    pub margin: Option<(f64, Answer)>,
    /// The mean before and after.
    #[serde(skip)]
    pub shown: [Picture; 2],
    /// For each pixel, the difference in standard deviations, largest channel.
    #[serde(skip)]
    pub z: Vec<f64>,
}

/// Of means that are less than so many times as far apart as noise puts them, chance explains the rest.
const SEEN: f64 = 1.1;

/// Pictures with shorter sides have no cause.
const SHORTEST: usize = 3;

/// At most so many areas are named.
const LISTED: usize = 5;

impl SetsVerdict {
    /// Compares two sets; a false alarm has this probability. Each has one picture or more. `None` if it is interrupted.
    pub fn of(sets: Sets, level: f64, watch: Watch<'_>) -> Option<Self> {
        let pictures = sets.sizes();
        let odd = Odd::of(&sets);
        let (sets, is_nothing_left) = sets.without_not_finite();
        let is_exact = sets.is_fixed() && (pictures != [1, 1] || sets.before[0] == sets.after[0]);
        let pairs = Pairs::of(&sets);
        let noise = Noise::of(&sets, level);
        let evidence = SetEvidence::of(&sets, (&pairs, &noise), level, watch);
        let mut found = match is_exact {
            true => Found { probability: 1.0, sums: Vec::new() },
            false => evidence.found(),
        };
        let fixed = sets.fixed_apart();
        let sum = |(pixel, channel, difference): &(usize, usize, f64)| {
            (evidence.sums.smallest(*pixel)[*channel], *difference)
        };
        found.sums.extend(fixed.iter().map(sum));
        let is_one_sided = {
            let (before, after) = odd.split_at(pictures[0]);
            before.iter().any(Odd::is_broken) != after.iter().any(Odd::is_broken)
        };
        if is_one_sided || !fixed.is_empty() {
            found.probability = 0.0;
        }
        let differs = is_one_sided || !found.sums.is_empty();
        let method = match is_exact {
            _ if is_one_sided => Method::Odd,
            true => Method::Rounding,
            false => evidence.method.clone(),
        };
        let decision = match (differs, &method) {
            (true, _) => SetsDecision::Differ,
            (false, Method::OnePicture) => SetsDecision::CannotTell,
            (false, _) if is_nothing_left => SetsDecision::CannotTell,
            (false, _) => SetsDecision::Agree,
        };
        let shown = [&sets.before, &sets.after].map(|set| {
            let mean: Vec<f32> = sets.mean(set).into_iter().map(|value| value as f32).collect();
            Picture::of_radiance(&mean, sets.areas.size.map(|side| side as u32))
        });
        let explained_by = (differs && !is_one_sided).then(|| explained(&sets, &shown)).flatten();
        let verdict = Self {
            decision,
            pictures,
            level,
            explained_by,
            means: AreaMeans::of(&sets, &pairs, &evidence, level),
            noise: (!is_exact && pictures.iter().all(|count| *count > 1)).then_some(noise),
            odd,
            power: (!differs && !is_exact).then(|| Power::of(&sets, &evidence)),
            margin: None,
            z: evidence.z_of_pixels(&sets.areas),
            shown,
            probability: found.probability,
            areas: areas(&sets, &evidence, found),
            method,
        };
        (!watch.is_interrupted()).then_some(verdict)
    }

    /// Also says whether all means are within this part of those before.
    pub fn hold_to(&mut self, margin: f64) {
        self.margin = Some((margin, AreaMeans::within(&self.means, margin)));
    }
}

/// The areas that differ, those of the largest difference first, without those that overlap one before them.
fn areas(sets: &Sets, evidence: &SetEvidence<'_>, mut found: Found) -> Vec<AreaDifference> {
    let [before, after] = [&sets.before, &sets.after].map(|set| sets.mean(set));
    found.sums.sort_by(|a, b| b.1.total_cmp(&a.1));
    let all = found.sums.iter().map(|(index, _)| (evidence.sums.area(*index), *index));
    let of = |(index, pixels): (usize, Vec<usize>)| {
        let (kind, channel, _) = evidence.sums.place(index);
        let channels = match kind {
            SumKind::Tiles(_) => channel..channel + 1,
            _ => 0..3,
        };
        let mean = |values: &[f64]| {
            let value = |pixel: &usize| values[3 * pixel..][channels.clone()].iter().sum::<f64>();
            pixels.iter().map(value).sum::<f64>() / (channels.len() * pixels.len()) as f64
        };
        AreaDifference {
            name: evidence.sums.name(index),
            bounds: sets.areas.bounds(&pixels),
            before: mean(&before),
            after: mean(&after),
            is_mean: kind != SumKind::Patterns,
        }
    };
    sets.areas.apart(all, LISTED).into_iter().map(of).collect()
}

/// The simple change of the mean after that explains most of its difference from the mean before.
fn explained(sets: &Sets, shown: &[Picture; 2]) -> Option<String> {
    // of a row or a column, a shift by a pixel leaves nothing that could differ
    if sets.areas.size.iter().any(|side| *side < SHORTEST) {
        return None;
    }
    let [before, after] = shown.each_ref().map(Decoded::new);
    // two halves of the pictures before are apart by noise alone
    let (first, second) = sets.before.split_at(sets.before.len() / 2);
    let noise = if first.is_empty() {
        0.0
    } else {
        let size = shown[0].size;
        let halves = [first, second].map(|half| {
            let mean: Vec<f32> = sets.mean(half).into_iter().map(|value| value as f32).collect();
            Picture::of_radiance(&mean, size)
        });
        let [a, b] = halves.each_ref().map(Decoded::new);
        let [n, m] = sets.sizes().map(|count| 1.0 / count as f64);
        let of_halves = 1.0 / first.len() as f64 + 1.0 / second.len() as f64;
        distance_of(&a, &b) * ((n + m) / of_halves).sqrt()
    };
    if distance_of(&before, &after) < SEEN * noise {
        return None;
    }
    let (change, _) = changes_that_explain(&before, &after, noise).into_iter().next()?;
    Some(change.words(["before", "after"], Transfer::Linear))
}
