//! The commands `render --replicas` and `merge`: what cases cannot say.

#[cfg(unix)]
mod interrupt;

use std::collections::BTreeSet;
use std::process::Command;

use pictures::sums::Seeds;
use xxhash_rust::xxh3::xxh3_128;

use crate::kit::{Folder, Run};

fn command(at: &Folder, line: &str) -> Command {
    at.command(&format!("exec groundtruth {line}"))
}

/// Runs the program, and fails unless it ends with this status.
fn expect(status: i32, at: &Folder, line: &str) -> Run {
    at.run(&format!("groundtruth {line}")).expect(status, &[])
}

/// Where the sums begin: after two lines.
fn body(bytes: &[u8]) -> usize {
    let ends = (0..bytes.len()).filter(|at| bytes[*at] == b'\n');
    ends.take(2).last().expect("two lines") + 1
}

/// The bytes of a part with another sum at a pixel, as a faulty machine would write them.
fn faulty(good: &[u8], pixel: usize) -> Vec<u8> {
    let mut bad = good[..good.len() - 16].to_vec();
    bad[body(good) + 168 * pixel + 9] ^= 4;
    bad.extend(xxh3_128(&bad).to_le_bytes());
    bad
}

/// Law: a part of a faulty machine is found if the same part comes from another machine too. Oracle: the planted difference.
#[test]
fn a_faulty_machine_is_found() {
    let at = &Folder::new();
    at.good(
        "for k in 0 1; do groundtruth render ch18/rectangle --size 12x8 --samples 4 --seed 1 \
         --replicas 4 --part $k/2 -o a$k.sums; done",
    );
    // pixel 5, 3 of 12 columns
    at.write("bad.sums", faulty(&at.bytes("a1.sums"), 3 * 12 + 5));
    let run = expect(1, at, "merge a0.sums a1.sums bad.sums -o mean.exr");
    let text = "error: bad.sums and a1.sums have the same seeds 3 to 4 but differ at pixel 5, 3: one of the \
                machines is faulty; render them a third time to see which\n";
    assert_eq!(run.stderr, text);
    assert!(!at.path().join("mean.exr").exists());
}

/// All sets of seeds below 6, with the set of numbers that each is.
fn sets() -> Vec<(Seeds, BTreeSet<u64>)> {
    let of_bits = |bits: u64| {
        let numbers: BTreeSet<u64> = (0..6).filter(|seed| bits >> seed & 1 == 1).collect();
        let one = |seed: &u64| Seeds::range(*seed, 1).expect("it fits");
        let seeds = numbers.iter().map(one).fold(Seeds::default(), |all, it| all.union(&it));
        (seeds, numbers)
    };
    (0..64).map(of_bits).collect()
}

/// Law: union, intersection, difference, count and order of any two sets of seeds are those of sets of
/// numbers, at every border; so are those of the largest seeds. Oracle: `BTreeSet`, over all pairs of sets of six seeds.
#[test]
fn sets_of_seeds_are_sets_of_numbers() {
    let sets = sets();
    for (a, numbers) in &sets {
        assert_eq!(a.iter().collect::<BTreeSet<u64>>(), *numbers);
        assert_eq!((a.count(), a.is_empty()), (numbers.len() as u64, numbers.is_empty()));
        for (b, others) in &sets {
            let found = [a.union(b), a.intersection(b), a.without(b)];
            let expected = [numbers | others, numbers & others, numbers - others];
            for (found, expected) in found.iter().zip(expected) {
                let place = expected.iter().fold(0, |bits, seed| bits | 1_usize << seed);
                assert_eq!(*found, sets[place].0, "{a} and {b}");
            }
        }
    }
    let last = Seeds::range(u64::MAX - 1, 1).expect("the last one");
    assert_eq!(Seeds::range(u64::MAX - 1, 2), None);
    assert_eq!(Seeds::range(u64::MAX - 3, 3).expect("they fit").intersection(&last), last);
}
