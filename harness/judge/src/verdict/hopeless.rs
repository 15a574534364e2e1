//! Explanations that a few pictures of ours refute, so that no more of them are rendered.
//!
//! An explanation says that the picture agrees with replicas of a changed scene. Whether it does may take 99 of them,
//! and most explanations that are tried are wrong.

use super::{Evaluation, Exclusion, PoolContext, Strictness};

/// An explanation is refuted if theirs is farther out than the farthest of so many of ours, by more than this factor.
///
/// Noise exceeds the standard deviation of 4 values 100 times with a probability of 2e-6, that of 8 values 10 times with
/// one of 2e-5 (Student's t). Of 46 right explanations the largest factors were 29 and 3.1, of 19 wrong ones the median
/// was 25 for both.
const REFUTED: [(usize, f64); 2] = [(4, 100.0), (8, 10.0)];

/// The numbers of replicas after which an explanation may be refuted; no more than are rendered at first.
pub(super) fn steps(strictness: Strictness) -> impl Iterator<Item = usize> {
    REFUTED.into_iter().map(|(count, _)| count).filter(move |count| *count <= strictness.first)
}

/// Whether a picture, by its stored values, is too far out of these replicas to agree with more of them.
pub(super) fn is_hopeless(
    mut theirs: Vec<f32>,
    exclusion: Exclusion<'_>,
    subject: PoolContext<'_>,
    known: &[Vec<f32>],
) -> bool {
    exclusion.is_unlike_fixed(&theirs, known) || {
        exclusion.exclude(&mut theirs, known);
        is_refuted(&theirs, subject, known)
    }
}

/// Whether 4 or 8 pictures of ours refute that theirs is one more of them; both are stored alike.
pub fn is_refuted(theirs: &[f32], subject: PoolContext<'_>, known: &[Vec<f32>]) -> bool {
    let factor = Evaluation::now(theirs, subject, known).ranking.times_as_far(known.len());
    REFUTED.iter().any(|(count, most)| *count == known.len() && factor > *most)
}
