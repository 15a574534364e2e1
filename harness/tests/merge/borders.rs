//! Borders: one seed that two parts share, and outputs that would lose one of two files.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use pictures::sums::{Seeds, Sums};

use super::{SCENE, command, expect, parts, read};

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

/// Law: parts that share exactly one seed, the last of one and the first of the other, are refused in both orders, and
/// the seed is named; neighbours that share none are merged. Oracle: the seeds asked for.
#[test]
fn parts_that_share_one_seed_are_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = folder.path();
    for (name, seed, count) in [("a", 1, 3), ("b", 3, 2), ("c", 4, 2)] {
        let render = format!("render {SCENE} --seed {seed} --replicas {count} -o {name}.sums");
        expect(0, at, &render);
    }
    let shared = [("a.sums b.sums", 3), ("b.sums a.sums", 3), ("c.sums b.sums", 4)];
    for (files, seed) in shared {
        let run = expect(1, at, &format!("merge {files} -o mean.exr"));
        assert!(run.stderr.contains(&format!("seed {seed}")), "{}", run.stderr);
        assert!(!at.join("mean.exr").exists());
    }
    expect(0, at, "merge a.sums c.sums -o mean.exr");
}

/// Law: of several outputs, or an output and a part, that are one file by whatever path, none is written, and the status
/// is 2. Oracle: the bytes of the part, and the folder.
#[test]
fn an_output_that_would_lose_a_file_is_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = folder.path();
    let file = &parts(at, "a", 1, 2)[0];
    let before = read(at, file);
    for line in [
        "merge a0.sums -o m.exr --standard-error m.exr",
        "merge a0.sums -o m.exr --standard-error ./m.exr",
        "merge a0.sums -o a0.sums",
        "merge a0.sums -o ./a0.sums",
    ] {
        let run = expect(2, at, line);
        assert!(run.stderr.contains("would be lost"), "{line}: {}", run.stderr);
        assert!(!at.join("m.exr").exists());
        assert_eq!(read(at, file), before);
    }
}

/// Law: of two different parts that are rendered into one file at once, one is refused with status 2, and the file holds
/// all of the other. Oracle: two processes, and the seeds of the file.
#[test]
fn two_parts_at_once_do_not_lose_one() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = folder.path();
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
    let part = Sums::read(&at.join("one.sums")).expect("whole");
    assert_eq!(part.header().seeds, Seeds::range(1 + 4 * kept as u64, 4).expect("they fit"));
    assert_eq!(names(at), ["one.sums"]);
}

/// The names in a folder.
fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).expect("there");
    entries.map(|it| it.expect("readable").file_name().to_string_lossy().into_owned()).collect()
}

/// Law: a named pipe as part or output is refused at once. Oracle: `mkfifo`; the test would wait for ever.
#[cfg(unix)]
#[test]
fn a_named_pipe_is_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = folder.path();
    parts(at, "a", 1, 1);
    let made = std::process::Command::new("mkfifo").arg(at.join("p.sums")).status();
    assert!(made.expect("it starts").success());
    for line in [
        "merge p.sums -o m.exr".to_owned(),
        "merge a0.sums -o p.sums".to_owned(),
        format!("render {SCENE} --replicas 1 -o p.sums"),
    ] {
        let run = expect(2, at, &line);
        assert!(run.stderr.contains("p.sums"), "{line}: {}", run.stderr);
    }
}
