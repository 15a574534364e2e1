//! Runs the bodies of the fuzz targets without a fuzzer: over the committed corpus, over random
//! changes of it, and over random bytes. The inputs are the same in every run; `FUZZ_ROUNDS` multiplies their
//! number, `FUZZ_SEED` changes them.

#[path = "../../fuzz/src/bodies/mod.rs"]
mod bodies;

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};

use groundtruth::math::{Pcg32, hash};

/// The number of changed and of random inputs for each target: they take some seconds in all.
const ROUNDS: u32 = 4000;
/// Random inputs are shorter than this.
const LONGEST: u32 = 600;
/// Longer files of the corpus are run only unchanged, because they are slow.
const SMALL: usize = 10_000;

fn number(name: &str) -> Option<u32> {
    std::env::var(name).ok()?.parse().ok()
}

fn corpus(target: &str) -> Vec<(PathBuf, Vec<u8>)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../fuzz/corpus").join(target);
    let entries = std::fs::read_dir(&folder).expect("every target has a corpus");
    let mut paths: Vec<_> =
        entries.map(|entry| entry.expect("the folder can be read").path()).collect();
    paths.sort();
    let read = |path: PathBuf| {
        let bytes = std::fs::read(&path).expect("the file can be read");
        (path, bytes)
    };
    paths.into_iter().map(read).collect()
}

/// Runs the body; if it fails, keeps the bytes and says where.
fn check(target: &str, body: fn(&[u8]), bytes: &[u8], what: &str) {
    if let Err(problem) = catch_unwind(AssertUnwindSafe(|| body(bytes))) {
        let kept = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("fuzz-{target}"));
        std::fs::write(&kept, bytes).expect("the input can be kept");
        eprintln!("target {target}, {what}: the bytes are in {}", kept.display());
        std::panic::resume_unwind(problem);
    }
}

/// The bytes with a few of them changed, cut out, or doubled.
fn mutated(bytes: &[u8], random: &mut Pcg32) -> Vec<u8> {
    let mut bytes = bytes.to_vec();
    for _ in 0..=random.below(4) {
        let length = bytes.len() as u32;
        if length == 0 {
            break;
        }
        let at = random.below(length) as usize;
        let end = (at + 1 + random.below(16) as usize).min(bytes.len());
        match random.below(5) {
            0 => bytes[at] = random.next_u32() as u8,
            1 => bytes[at] ^= 1 << random.below(8),
            2 => drop(bytes.drain(at..end)),
            3 => {
                let again = bytes[at..end].to_vec();
                let to = random.below(length) as usize;
                bytes.splice(to..to, again);
            }
            _ => bytes.truncate(at),
        }
    }
    bytes
}

fn exercise(name: &str) {
    let &(_, body) =
        bodies::TARGETS.iter().find(|(target, _)| *target == name).expect("it is a target");
    let corpus = corpus(name);
    assert!(!corpus.is_empty(), "every target has a corpus");
    for (path, bytes) in &corpus {
        check(name, body, bytes, &path.display().to_string());
    }
    let seed = u64::from(number("FUZZ_SEED").unwrap_or(2007));
    let mut random = Pcg32::new(hash(&[seed, name.len() as u64, u64::from(name.as_bytes()[0])]), 0);
    let small: Vec<_> = corpus.iter().filter(|(_, bytes)| bytes.len() <= SMALL).collect();
    for round in 0..ROUNDS * number("FUZZ_ROUNDS").unwrap_or(1) {
        let (path, bytes) = small[random.below(small.len() as u32) as usize];
        let changed = mutated(bytes, &mut random);
        check(name, body, &changed, &format!("change {round} of {}", path.display()));
        let length = random.below(LONGEST);
        let any: Vec<u8> = (0..length).map(|_| random.next_u32() as u8).collect();
        check(name, body, &any, &format!("random bytes {round}"));
    }
}

macro_rules! targets {
    ($($target:ident)*) => {
        $(
            #[test]
            fn $target() {
                exercise(stringify!($target));
            }
        )*

        #[test]
        fn every_target_is_run() {
            let run = [$(stringify!($target)),*];
            assert!(bodies::TARGETS.iter().map(|(name, _)| *name).eq(run));
            for target in run {
                let file = format!("../fuzz/fuzz_targets/{target}.rs");
                assert!(Path::new(env!("CARGO_MANIFEST_DIR")).join(&file).exists(), "{file}");
            }
        }
    };
}

targets!(bvh image obj ply probe_line scene_file shapes transforms);
