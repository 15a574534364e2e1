//! Sets of seeds, and two parts at once.

use std::collections::BTreeSet;

use pictures::sums::{Seeds, Sums};

use super::command;
use crate::kit::Folder;

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

/// Law: of two different parts that are rendered into one file at once, one is refused with status 2, and the file holds
/// all of the other. Oracle: two processes, and the seeds of the file.
#[test]
fn two_parts_at_once_do_not_lose_one() {
    let at = &Folder::new();
    let run = |part: u32| {
        let size = "ch18/rectangle --size 60x40 --samples 16 --seed 1 --replicas 8";
        let line = format!("render {size} --part {part}/2 -o one.sums");
        command(at, &line).stderr(std::process::Stdio::piped()).spawn().expect("it starts")
    };
    let ended = [run(0), run(1)].map(|child| child.wait_with_output().expect("it ends"));
    let statuses = ended.each_ref().map(|it| it.status.code());
    let kept = statuses.iter().position(|status| *status == Some(0)).expect("one is written");
    assert_eq!(statuses[1 - kept], Some(2), "one is refused");
    let said = String::from_utf8_lossy(&ended[1 - kept].stderr).into_owned();
    assert!(said.contains("write to another file"), "{said}");
    let part = Sums::read(&at.path().join("one.sums")).expect("whole");
    assert_eq!(part.header().seeds, Seeds::range(1 + 4 * kept as u64, 4).expect("they fit"));
    assert_eq!(at.names(), ["one.sums"]);
}
