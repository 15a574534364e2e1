//! Shares of replicas: parts K/N.

use std::collections::BTreeSet;

use pictures::sums::Sums;

use super::expect;
use crate::kit::Folder;

/// A picture of ten rows that costs nothing.
const SMALL: &str = "render ch03/single-sphere --size 1x10 --samples 1";

/// Law: the N parts of any number of replicas have each seed once, in order, and none has two more than another; there is
/// none of K = N, nor of more parts than replicas. Oracle: the seeds that the files have.
#[test]
fn parts_have_each_seed_once() {
    let at = &Folder::new();
    for (replicas, counts) in [(1_u32, 1..2), (2, 1..3), (5, 1..6), (7, 3..6)] {
        let render = format!("{SMALL} --seed 9 --replicas {replicas}");
        for count in counts {
            let seeds = |k: u32| -> Vec<u64> {
                let file = format!("{replicas}-{count}-{k}.sums");
                expect(0, at, &format!("{render} --part {k}/{count} -o {file}"));
                let part = Sums::read(&at.path().join(file)).expect("a part");
                part.header().seeds.iter().collect()
            };
            let parts: Vec<Vec<u64>> = (0..count).map(seeds).collect();
            let all: Vec<u64> = parts.concat();
            let expected: Vec<u64> = (9..9 + u64::from(replicas)).collect();
            assert_eq!(all, expected, "seeds of {replicas} replicas in {count} parts");
            let lengths: BTreeSet<usize> = parts.iter().map(Vec::len).collect();
            let apart = lengths.last().zip(lengths.first()).map(|(most, least)| most - least);
            assert!(apart <= Some(1), "{replicas} replicas in {count}: parts of {lengths:?} seeds");
            expect(2, at, &format!("{render} --part {count}/{count} -o no.sums"));
        }
        let more = replicas + 1;
        expect(2, at, &format!("{render} --part 0/{more} -o no.sums"));
    }
    assert!(!at.path().join("no.sums").exists(), "a part that does not exist was written");
}
