//! The time of each intersection routine.

use std::hint::black_box;

use super::FamilyData;
use super::judging::{Case, Judged};
use crate::report::clock::{Time, medians, time};

/// The least and the largest number of rounds in which the two routines are timed in turn.
const ROUNDS: [usize; 2] = [3, 41];
/// Calls in one round, about, of quick ones: some tens of microseconds.
const CALLS: usize = 2048;
/// What the rounds of slow ones may take together, in seconds.
const PATIENCE: f64 = 0.01;

/// With the times of its rays filled in.
pub fn timed(Judged { mut data, hits, misses }: Judged) -> FamilyData {
    let ([ours, textbook], hits_disturbed) = nanoseconds(&hits);
    let ([ours_miss, textbook_miss], misses_disturbed) = nanoseconds(&misses);
    (data.ours.hit_ns, data.ours.miss_ns) = (ours, ours_miss);
    (data.textbook.hit_ns, data.textbook.miss_ns) = (textbook, textbook_miss);
    data.disturbed = hits_disturbed || misses_disturbed;
    data
}

/// Nanoseconds for one call of our routine and of the textbook's, and whether a measurement was disturbed.
/// Both are called through a trait object for the same rays, and only `t` is kept. (Keeping the whole
/// [`Candidate`] would also time its copy: 4 ns that no caller spends.)
///
/// [`Candidate`]: crate::shapes::Candidate
fn nanoseconds(cases: &[Case]) -> ([Option<f64>; 2], bool) {
    if cases.is_empty() {
        return ([None; 2], false);
    }
    let ours = |repeats: usize| {
        for _ in 0..repeats {
            for case in cases {
                let hit = black_box(case).ours.hit(&case.ray, case.span);
                black_box(hit.map(|candidate| candidate.t));
            }
        }
    };
    let textbook = |repeats: usize| {
        for _ in 0..repeats {
            for case in cases {
                black_box(black_box(case).textbook_hit());
            }
        }
    };
    let ((), once) = time(|| {
        ours(1);
        textbook(1);
    });
    let [fewest, most] = ROUNDS;
    let affordable = PATIENCE / once.cpu.max(1e-9);
    let repeats = CALLS.div_ceil(cases.len()).min((affordable / most as f64) as usize).max(1);
    let rounds = ((affordable / repeats as f64) as usize).clamp(fewest, most);
    let calls = (repeats * cases.len()) as f64;
    let times = medians(rounds, &mut [&mut || ours(repeats), &mut || textbook(repeats)]);
    let one = |time: Time| Some(1e9 * time.cpu / calls);
    ([one(times[0]), one(times[1])], times.iter().any(|time| time.is_disturbed()))
}
