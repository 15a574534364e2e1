//! Honest sets of pictures of other renderers: Mitsuba's paths, and POV-Ray's jittered lamp.

use std::path::Path;
use std::process::Command;

use judge::sets::SetsDecision;
use pictures::compare::{Picture, Transfer};
use rayon::prelude::*;

use super::renders::chosen;
use super::synthetic::verdict;

/// Pictures of each renderer.
const POOL: usize = 60;

/// Pairs of sets of them, five a side.
const PAIRS: u64 = 170;

const SIDE: u32 = 64;

/// The pictures of Mitsuba's Cornell box; `None` if there is no Mitsuba.
fn of_mitsuba(folder: &Path) -> Option<Vec<Picture>> {
    let script = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/sets/cornell.py");
    let mut python = Command::new("python3");
    let done = python.args([script, &POOL.to_string()]).current_dir(folder).output();
    done.is_ok_and(|done| done.status.success()).then(|| {
        let read = |seed| Picture::read(&folder.join(format!("{seed}.exr")), None);
        (0..POOL).map(|seed| read(seed).expect("written")).collect()
    })
}

/// The pictures of a jittered lamp by POV-Ray; `None` if there is no POV-Ray.
fn of_pov(folder: &Path) -> Option<Vec<Picture>> {
    let scene = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/sets/jitter.pov");
    let picture = |number: usize| {
        let file = folder.join(format!("{number}.png"));
        let mut pov = Command::new("povray");
        pov.args([format!("+I{scene}"), format!("+O{}", file.display())]);
        pov.arg(format!("Declare=Seed={}", 16 * number + 3));
        pov.args([format!("+W{SIDE}"), format!("+H{}", SIDE * 3 / 2)]);
        pov.args(["-D", "+WT1", "+AM1", "+A0.0", "+R3", "+J1.0", "+FN16", "File_Gamma=1.0"]);
        let done = pov.current_dir(folder).output().ok()?;
        assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
        let whole = Picture::read(&file, Some(Transfer::Linear)).expect("written");
        let values = whole.values[(SIDE * SIDE / 2) as usize..].to_vec();
        Some(Picture { values, size: [SIDE; 2], ..whole })
    };
    (0..POOL).map(picture).collect()
}

/// Law: of honest pairs of sets of each renderer, few differ. Oracle: the binomial distribution at the level: of 170, more
/// than 8 have a probability below 1e-4. And pictures of one renderer are not all the same, so that the law says something.
#[test]
#[ignore = "cost and programs: cargo test --release -p judge sets::others -- --ignored --nocapture"]
fn few_honest_sets_of_other_renderers_differ() {
    let folders = [0, 1].map(|_| tempfile::tempdir().expect("a folder"));
    let [mitsuba, pov] = folders.each_ref().map(|folder| folder.path());
    for (name, pool) in [("Mitsuba", of_mitsuba(mitsuba)), ("POV-Ray", of_pov(pov))] {
        let Some(pool) = pool else {
            println!("not tried: there is no {name}");
            continue;
        };
        for (index, picture) in pool.iter().enumerate() {
            let is_same = |other: &Picture| other.values == picture.values;
            assert!(!pool[..index].iter().any(is_same), "{name}: picture {index} comes twice");
        }
        let differs = |seed: &u64| {
            let [before, after] = chosen(&pool, [5, 5], *seed);
            verdict(&before, &after).decision == SetsDecision::Differ
        };
        let alarms = (0..PAIRS).into_par_iter().filter(differs).count();
        println!("{name}: {alarms} of {PAIRS}");
        assert!(alarms <= 8, "{name}: {alarms} of {PAIRS}");
    }
}
