//! The time of each intersection routine.

use std::hint::black_box;

use super::FamilyData;
use super::judging::{Judged, JudgedRay};
use crate::clock::{Time, medians, time};

/// The smallest and the largest number of rounds; each round times both routines.
const ROUNDS: [usize; 2] = [3, 41];
/// The approximate number of calls in one round of a fast routine: some tens of microseconds.
const CALLS: usize = 2048;
/// The time for all rounds of a slow routine, in seconds.
const TIME_LIMIT: f64 = 0.01;

/// The data with the times of the rays.
pub fn timed(Judged { mut data, hits, misses }: Judged) -> FamilyData {
    let ([ours, textbook], hits_disturbed) = nanoseconds(&hits);
    let ([ours_miss, textbook_miss], misses_disturbed) = nanoseconds(&misses);
    (data.ours.hit_ns, data.ours.miss_ns) = (ours, ours_miss);
    (data.textbook.hit_ns, data.textbook.miss_ns) = (textbook, textbook_miss);
    data.disturbed = hits_disturbed || misses_disturbed;
    data
}

/// The nanoseconds for one call of the library's and of the textbook's routine, and whether a
/// measurement was disturbed. Both are called through a trait object for the same rays, and only
/// `t` is kept. (Keeping the whole [`Candidate`] would add 4 ns for a copy that callers do not
/// make.)
///
/// [`Candidate`]: groundtruth::shapes::Candidate
fn nanoseconds(cases: &[JudgedRay]) -> ([Option<f64>; 2], bool) {
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
    let [min, max] = ROUNDS;
    let affordable = TIME_LIMIT / once.cpu.max(1e-9);
    let repeats = CALLS.div_ceil(cases.len()).min((affordable / max as f64) as usize).max(1);
    let rounds = ((affordable / repeats as f64) as usize).clamp(min, max);
    let calls = (repeats * cases.len()) as f64;
    let times = medians(rounds, &mut [&mut || ours(repeats), &mut || textbook(repeats)]);
    let one = |time: Time| Some(1e9 * time.cpu / calls);
    ([one(times[0]), one(times[1])], times.iter().any(|time| time.is_disturbed()))
}
