//! How long each routine takes.

use std::hint::black_box;

use super::FamilyData;
use super::judging::{Case, Judged};
use crate::math::Span;
use crate::report::clock::medians;

/// So often are the two routines timed in turn.
const ROUNDS: usize = 41;
/// Calls in one round, about: some tens of microseconds.
const CALLS: usize = 2048;

/// With the times of its rays filled in.
pub fn timed(Judged { mut data, hits, misses }: Judged) -> FamilyData {
    let [ours, textbook] = nanoseconds(&hits);
    let [ours_miss, textbook_miss] = nanoseconds(&misses);
    (data.ours.hit_ns, data.ours.miss_ns) = (ours, ours_miss);
    (data.textbook.hit_ns, data.textbook.miss_ns) = (textbook, textbook_miss);
    data
}

/// For one call of ours and of the textbook's: both through a reference to a trait's object, for the
/// same rays, and of both answers `t` alone is kept. (To keep the whole [`Candidate`], face and
/// parameters, would time the copy of it: 4 ns that no caller spends.)
///
/// [`Candidate`]: crate::shapes::Candidate
fn nanoseconds(cases: &[Case]) -> [Option<f64>; 2] {
    if cases.is_empty() {
        return [None; 2];
    }
    let repeats = CALLS.div_ceil(cases.len());
    let mut ours = || {
        for _ in 0..repeats {
            for case in cases {
                let hit = black_box(case).ours.hit(&case.ray, Span::AHEAD);
                black_box(hit.map(|candidate| candidate.t));
            }
        }
    };
    let mut textbook = || {
        for _ in 0..repeats {
            for case in cases {
                black_box(black_box(case).textbook.hit(&case.ray));
            }
        }
    };
    let calls = (repeats * cases.len()) as f64;
    let times = medians(ROUNDS, &mut [&mut ours, &mut textbook]);
    let one = |seconds: f64| Some(1e9 * seconds / calls);
    [one(times[0]), one(times[1])]
}
