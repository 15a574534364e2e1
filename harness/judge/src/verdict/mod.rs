//! A picture of one of our scenes by another program, judged: is its difference from ours noise?
//!
//! Our replicas, pictures with other seeds, and the picture to be judged make up a [`Pool`]; [`Ranking`] says how far out
//! each is. More replicas are rendered only while theirs is among the farthest. Scenes without random numbers, and
//! values on which all replicas agree, are judged by rounding.

mod areas;
mod attempt;
mod case;
mod causes;
mod evidence;
mod excluded;
mod finding;
mod harmless;
mod hopeless;
mod judgeable;
mod linear;
mod lossy;
mod map;
mod means;
mod negative;
mod numbers;
mod page;
mod pictures_shown;
mod place;
mod planted;
mod plausible;
mod pool;
mod progress;
mod quantiser;
mod ranking;
mod reason;
mod reference;
mod replicas;
pub(crate) mod residuals;
mod sampling;
mod several;
mod share;
mod stored;
mod suspects;
mod text;
#[expect(clippy::module_inception, reason = "the file of the type of this name")]
mod verdict;

pub use areas::{Area, Areas};
pub use case::Case;
pub use causes::{Cause, Causes, Nearest};
pub use evidence::Evidence;
pub use excluded::{Exclusion, RayTolerance};
pub use finding::Finding;
pub use hopeless::is_refuted;
pub use judgeable::{refusal, refusal_of_alpha, refusal_of_seed};
pub use map::Map;
pub use means::{Answer, Means, Relative};
pub use negative::Negative;
pub use page::{STYLE, map_film, map_with_legend, page};
pub use pictures_shown::ShownPictures;
pub use place::Place;
pub use planted::{PlantedDefect, planted, smallest_gains};
pub use plausible::plausible;
pub use pool::{Against, Pool};
pub use progress::Progress;
pub use quantiser::Quantiser;
pub use ranking::{DifferenceKind, DifferingArea, Ranking};
pub use reference::{Mean, Reference};
pub use replicas::{Renders, Replicas};
pub use several::{WelchTest, several};
pub use stored::{Bright, Stored};
pub use verdict::{DecidedBy, DifferingRegion, Explanation, Verdict};

use groundtruth::math::ln;
use serde::Serialize;

/// What is said of a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Decision {
    /// Nothing was found.
    Agrees,
    /// It is farther out than all of ours.
    Differs,
    /// The user interrupted before enough replicas were rendered.
    Undecided,
}

/// What pictures are of and are held against, besides our replicas.
#[derive(Clone, Copy, Debug)]
pub struct PoolContext<'a> {
    /// Their areas.
    pub areas: &'a Areas,
    /// How their values are stored.
    pub stored: Stored,
    /// A mean of other pictures of ours, if one was rendered before.
    pub reference: Option<&'a Reference>,
}

/// A picture held against replicas.
#[derive(Clone, Debug)]
pub struct Evaluation {
    /// The replicas, and the judged picture as the last.
    pub pool: Pool,
    /// Its ranks.
    pub ranking: Ranking,
    /// What follows.
    pub decision: Decision,
    /// Whether no replica differs from another: the scene has no random numbers that this picture shows.
    pub is_fixed: bool,
    /// Whether the noise is so unlike ours that single pixels and pairs of them were left out.
    pub is_coarse: bool,
}

/// How strict a judgement is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Strictness {
    /// The probability of a false alarm.
    pub level: f64,
    /// The replicas that are rendered at first; at least 3.
    pub first: usize,
}

/// A picture that is so many times as far out as the farthest of enough of ours is not judged further.
const FAR_OUT: f64 = 100.0;

/// So many of ours are enough for that.
const ENOUGH: usize = 15;

/// So many of ours must be as far out as theirs for an early end.
const AS_FAR: usize = 3;

/// Noise from this part of ours to its inverse is like ours.
const ALIKE: f64 = 0.8;

/// The noise of a picture relative to that of these replicas, at least three; all are stored alike.
pub fn noise(theirs: &[f32], subject: PoolContext<'_>, known: &[Vec<f32>]) -> f64 {
    ranking::noise(&pool(theirs, subject, known))[known.len()]
}

/// Whether noise of this part of ours is like ours.
pub fn is_alike(noise: f64) -> bool {
    (ALIKE..=1.0 / ALIKE).contains(&noise)
}

/// Whether noise of the part `a` of some replicas is nearer to theirs than noise of the part `b` of others.
pub fn is_nearer(a: f64, b: f64) -> bool {
    ln(a).abs() < ln(b).abs()
}

/// The replicas, and the judged picture as the last.
fn pool(theirs: &[f32], subject: PoolContext<'_>, known: &[Vec<f32>]) -> Pool {
    let PoolContext { areas, stored, reference } = subject;
    let pictures = known.iter().cloned().chain([theirs.to_vec()]).collect();
    let mean = reference.map(|reference| reference.mean(stored));
    Pool::new(areas.size, stored, pictures).against_mean(mean)
}

impl Strictness {
    /// That of `verify`, if nothing else is said.
    pub const USUAL: Self = Self { level: 0.01, first: 8 };

    /// The most replicas that can change the decision.
    pub fn most(self) -> usize {
        ((1.0 / self.level).ceil() as usize).max(self.first + 1) - 1
    }
}

impl Evaluation {
    /// Judges a picture by its stored values; `replicas` gives the next of our pictures, stored alike, or `None` if the
    /// user interrupts; it is told what is known so far. `known` are those that exist already. `None` if there are too few
    /// to say anything.
    pub fn of(
        theirs: &[f32],
        subject: PoolContext<'_>,
        strictness: Strictness,
        known: &mut Vec<Vec<f32>>,
        mut replicas: impl FnMut(Option<&Self>) -> Option<Vec<f32>>,
    ) -> Option<Self> {
        let mut so_far: Option<Self> = None;
        let mut wanted = strictness.first;
        loop {
            while known.len() < wanted
                && let Some(picture) = replicas(so_far.as_ref())
            {
                known.push(picture);
            }
            let is_interrupted = known.len() < wanted;
            if known.len() < 3 {
                return None;
            }
            let judged = Self::now(theirs, subject, known);
            let is_over = judged.is_over(strictness);
            if is_over || is_interrupted {
                let decision = judged.decided(strictness, is_over);
                return Some(Self { decision, ..judged });
            }
            so_far = Some(judged);
            wanted = (2 * known.len()).min(strictness.most());
        }
    }

    /// A picture held against the replicas that there are.
    fn now(theirs: &[f32], subject: PoolContext<'_>, known: &[Vec<f32>]) -> Self {
        let (pool, areas) = (pool(theirs, subject, known), subject.areas);
        let (last, is_fixed) = (known.len(), pool.is_fixed_but_for(known.len()));
        let noise = ranking::noise(&pool);
        let is_coarse = !is_alike(noise[last]);
        let from = if is_coarse { 2.min(areas.levels() - 1) } else { 0 };
        let ranking = Ranking::with_noise(&pool, areas, from, noise);
        Self { pool, ranking, decision: Decision::Undecided, is_fixed, is_coarse }
    }

    fn is_over(&self, strictness: Strictness) -> bool {
        let theirs = self.pool.count() - 1;
        self.is_fixed
            || theirs >= strictness.most()
            || self.ranking.as_far_as(theirs) >= AS_FAR
            || theirs >= ENOUGH && self.ranking.times_as_far(theirs) > FAR_OUT
    }

    fn decided(&self, strictness: Strictness, is_over: bool) -> Decision {
        let theirs = self.pool.count() - 1;
        let is_farthest = self.ranking.as_far_as(theirs) == 0;
        match (self.is_fixed, is_over) {
            // the values in which it is alone are the only ones that can differ
            (true, _) if self.ranking.scores[theirs] > 0.0 => Decision::Differs,
            (true, _) => Decision::Agrees,
            (_, false) => Decision::Undecided,
            _ if is_farthest && self.ranking.times_as_far(theirs) > FAR_OUT => Decision::Differs,
            _ if self.ranking.probability(theirs) <= strictness.level => Decision::Differs,
            _ => Decision::Agrees,
        }
    }
}
