//! Which parts count: each seed once, whatever the parts are.

use std::collections::BTreeSet;
use std::path::PathBuf;

use groundtruth::film::Film;
use groundtruth::math::Pcg32;
use groundtruth::rgb::Rgb;
use pictures::sums::{self, Contradiction, Header, MergeError, Seeds, Sums};

use super::header::header;
use crate::verbs::{equal, near};

/// A part of these seeds. The replica of seed s is 4ˢ in one pixel: a sum says which seeds are in it, and how often.
fn part(folder: &std::path::Path, seeds: &BTreeSet<u64>) -> PathBuf {
    let mut sums = Sums::new(header([2, 1]));
    for seed in seeds {
        let mut film = Film::new(2, 1);
        film.set([1, 0], Rgb::new(0.0, (1_u64 << (2 * seed)) as f64, -1.0));
        sums.add(&film, *seed).expect("it fits");
    }
    let name: Vec<String> = seeds.iter().map(u64::to_string).collect();
    let file = folder.join(format!("{}.sums", name.join("-")));
    sums.write(&file).expect("written");
    file
}

/// The merged seeds, or `None` for an overlap: no two parts of other seeds may share one.
fn expected(parts: &[&BTreeSet<u64>]) -> Option<BTreeSet<u64>> {
    let overlap = parts.iter().any(|a| parts.iter().any(|b| a != b && !a.is_disjoint(b)));
    (!overlap).then(|| parts.iter().flat_map(|it| it.iter().copied()).collect())
}

/// Law: each seed is in the sum of parts once, in any order of the parts and also if a part comes twice; the other seeds of 0
/// to 7 are missing. Parts that overlap are refused, with their common seeds. Oracle: sets of
/// numbers, for all pairs and some random triples and quadruples; powers of 4, whose sum tells how often each was added.
#[test]
fn each_seed_counts_once() {
    let folder = tempfile::tempdir().expect("a folder");
    let set =
        |bits: u64| -> BTreeSet<u64> { (0..4).filter(|seed| bits >> seed & 1 == 1).collect() };
    let sets: Vec<BTreeSet<u64>> = (1..16).map(set).collect();
    let files: Vec<PathBuf> = sets.iter().map(|seeds| part(folder.path(), seeds)).collect();
    let all = |i: usize| (0..15).map(move |j| vec![i, j]);
    let mut cases: Vec<Vec<usize>> = (0..15).flat_map(all).collect();
    let random = &mut Pcg32::new(1, 31);
    for _ in 0..150 {
        let count = 3 + random.below(2);
        cases.push((0..count).map(|_| random.below(15) as usize).collect());
    }
    let (mut refused, mut merged) = (0, 0);
    for case in cases {
        let parts: Vec<&BTreeSet<u64>> = case.iter().map(|index| &sets[*index]).collect();
        let paths: Vec<PathBuf> = case.iter().map(|index| files[*index].clone()).collect();
        match (sums::merged(&paths, || ()), expected(&parts)) {
            (Ok(plan), Some(seeds)) => {
                merged += 1;
                let sums = &plan.sums;
                let what = format!("{parts:?}");
                let found: Vec<u64> = sums.header().seeds.iter().collect();
                equal(format!("seeds of {what}"), found, seeds.iter().copied().collect());
                let power = |seed: &u64| (1_u64 << (2 * seed)) as f64;
                let mean = seeds.iter().map(power).sum::<f64>() / seeds.len() as f64;
                let [_, green, blue] = sums.mean().get([1, 0]).to_array();
                near(format!("mean of {what}"), green, mean, 1e-12 * mean);
                near(format!("mean of −1 in {what}"), blue, -1.0, 0.0);
                let missing: Vec<u64> = plan.missing().iter().collect();
                let rest: Vec<u64> = (0..8).filter(|seed| !seeds.contains(seed)).collect();
                equal(format!("missing of {what}"), missing, rest);
                let count = plan.used.len() + plan.twice.len();
                equal(format!("parts of {what}"), count, parts.len());
            }
            (Err(error), None) => {
                refused += 1;
                let MergeError::Contradiction(Contradiction::Overlap { both, common }) = &error
                else {
                    panic!("{parts:?} overlap, but: {error}")
                };
                let of = |path: &PathBuf| -> &BTreeSet<u64> {
                    let index = files.iter().position(|file| file == path);
                    &sets[index.expect("one of the parts")]
                };
                let [a, b] = both.each_ref().map(of);
                let shared: Vec<u64> = a.intersection(b).copied().collect();
                equal(format!("common seeds of {parts:?}"), common.iter().collect(), shared);
                assert!(a != b, "{a:?} and {b:?} are no overlap");
            }
            (Ok(_), None) => panic!("{parts:?} overlap, and are merged"),
            (Err(error), Some(_)) => panic!("{parts:?} do not overlap, but: {error}"),
        }
    }
    assert!(refused > 30 && merged > 30, "{refused} refused, {merged} merged: both must be tried");
}

/// Law: sums of another program version, scene, size or number of samples may not be added, and the first of these is named
/// with both values; what the picture does not depend on may differ. Oracle: each field changed alone.
#[test]
fn each_field_of_the_picture_counts() {
    let ours = || header([12, 8]);
    let seeds = Seeds::range(3, 1).expect("it fits");
    let cases: [(Header, Option<&str>); 7] = [
        (Header { program: "2".to_owned(), ..ours() }, Some("another program version (2, not 1)")),
        (Header { size: [13, 8], ..ours() }, Some("another size (13x8, not 12x8)")),
        (Header { size: [12, 9], ..ours() }, Some("another size (12x9, not 12x8)")),
        (Header { samples: 5, ..ours() }, Some("another samples a replica (5, not 4)")),
        (
            Header { scene: "6".repeat(64), ..ours() },
            Some("another scene (666666666666, not 555555555555)"),
        ),
        (Header { arguments: Vec::new(), seeds, ..ours() }, None),
        (ours(), None),
    ];
    for (theirs, expected) in cases {
        equal("difference", theirs.difference(&ours()).as_deref(), expected);
    }
}
