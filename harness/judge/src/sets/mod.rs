//! Pictures of any scene by any renderer, before and after a change, with other seeds: is their mean the same?
//!
//! No scene of ours is needed, and nothing of ours is rendered. If the change did nothing, it is chance which pictures are
//! before and which after: the difference that is there is held against those of other divisions of the same pictures, in
//! areas of every size ([`AreaSums`], [`Rank`]). Pictures with equal seeds are compared in pairs, of which the noise is gone but
//! for what the change did to it; few pictures by tests of means, and one picture a side by its own details ([`Method`]).

mod divisions;
mod evidence;
mod fixed;
mod given;
mod means;
mod noise;
mod odd;
mod page;
mod power;
mod sums;
mod text;

use std::sync::atomic::{AtomicBool, Ordering};

use serde::Serialize;

use crate::verdict::Answer;
use crate::verdict::residuals::mean_of;
use pictures::compare::{Decoded, Picture, Transfer, changes_that_explain, distance_of};

pub use divisions::{Divisions, Rank};
pub use evidence::Reason;
pub use given::Sets;
pub use means::AreaMeans;
pub use noise::{Noise, Pairs};
pub use odd::Odd;
pub use page::page;
pub use power::Power;
pub use sums::{AreaSums, Design, SumKind};

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
        let evidence = SetEvidence::of(&sets, (&pairs, &noise), (level, watch));
        let mut found = match is_exact {
            true => Found { probability: 1.0, sums: Vec::new() },
            false => evidence.found(&evidence.sums),
        };
        let fixed = sets.fixed_apart();
        let sum = |(pixel, channel, difference): &(usize, usize, f64)| {
            (evidence.sums.smallest(*pixel)[*channel], *difference)
        };
        found.sums.extend(fixed.iter().map(sum));
        let (before, after) = odd.split_at(pictures[0]);
        let is_one_sided = before.iter().any(Odd::is_broken) != after.iter().any(Odd::is_broken);
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
        let shown = [&sets.before, &sets.after].map(|set| sets.mean_picture(set));
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
    let [before, after] = [&sets.before, &sets.after].map(|set| mean_of(set));
    found.sums.sort_by(|a, b| b.1.total_cmp(&a.1));
    let all = found.sums.iter().map(|(index, _)| (evidence.sums.area(*index), *index));
    let of = |(index, pixels): (usize, Vec<usize>)| {
        let (kind, channel, _) = evidence.sums.place(index);
        let is_tile = matches!(kind, SumKind::Tiles(_));
        let channels = if is_tile { channel..channel + 1 } else { 0..3 };
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
        let halves = [first, second].map(|half| sets.mean_picture(half));
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
