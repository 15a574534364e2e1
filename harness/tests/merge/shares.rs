//! Shares of replicas and of rows: parts K/N, and audits.

use std::collections::BTreeSet;

use pictures::sums::SumsFile;

use super::expect;

/// A picture of ten rows that costs nothing.
const SMALL: &str = "render ch03/single-sphere --size 1x10 --samples 1";

/// Law: the N parts of any number of replicas have each seed once, in order, and none has two more than another; there is
/// none of K = N, nor of more parts than replicas. Oracle: the seeds that the files have.
#[test]
fn parts_have_each_seed_once() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = folder.path();
    for (replicas, counts) in [(1_u32, 1..2), (2, 1..3), (5, 1..6), (7, 3..6)] {
        let render = format!("{SMALL} --seed 9 --replicas {replicas}");
        for count in counts {
            let seeds = |k: u32| -> Vec<u64> {
                let file = format!("{replicas}-{count}-{k}.sums");
                expect(0, at, &format!("{render} --part {k}/{count} -o {file}"));
                let part = SumsFile::open(&at.join(file)).expect("a part");
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
    assert!(!at.join("no.sums").exists(), "a part that does not exist was written");
}

/// Law: an audit is of its share of the rows, to the nearest row, and of one at least; a share is above 0 and at most 1.
/// Oracle: ten rows, and shares on both sides of each border.
#[test]
fn an_audit_is_of_its_share_of_rows() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = folder.path();
    for k in 0..2 {
        expect(0, at, &format!("{SMALL} --replicas 2 --part {k}/2 -o {k}.sums"));
    }
    for (share, rows) in [
        ("0.001%", 1),
        ("14%", 1),
        ("16%", 2),
        ("0.24", 2),
        ("0.26", 3),
        ("94%", 9),
        ("96%", 10),
        ("100%", 10),
        ("1", 10),
    ] {
        let run = expect(0, at, &format!("merge 0.sums 1.sums -o mean.exr --audit {share}"));
        // of two parts
        let words = format!("; {} of 20 rows were rendered again", 2 * rows);
        assert!(
            run.stdout.contains(&words),
            "--audit {share}: expected `{words}`, found {}",
            run.stdout
        );
    }
    for share in ["0", "0%", "100.1%", "1.001", "-1", "nan", "%"] {
        expect(2, at, &format!("merge 0.sums 1.sums -o mean.exr --audit={share}"));
    }
}
