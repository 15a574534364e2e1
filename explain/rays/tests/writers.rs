use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::Arc;

use rays::{Outcome, Purpose, RayVerdict, Traced, WRITERS, read, world_of};

/// A language, the command that builds its tracer in a folder, and the one that runs it there.
const TRACERS: &[(&str, &str, &str)] = &[
    ("c", "cc -O1 -std=c99 tracer.c -o tracer -lm", "./tracer"),
    ("cpp", "c++ -O1 -std=c++11 tracer.cpp -o tracer -pthread", "./tracer"),
    ("java", "javac Tracer.java Rays.java", "java -cp . Tracer"),
    ("javascript", "node --check tracer.mjs", "node tracer.mjs"),
    ("python", "python3 -m py_compile tracer.py", "python3 tracer.py"),
    ("rust", "rustc -O --edition 2021 tracer.rs", "./tracer"),
];

/// Those that every machine has on which this is tested.
const ALWAYS: [&str; 3] = ["c", "cpp", "rust"];

pub fn shell(folder: &Path, line: &str) -> bool {
    let run = Command::new("sh").args(["-c", line]).current_dir(folder).env("RAYS", "/16").output();
    let run = run.expect("a shell");
    let is_missing = run.status.code() == Some(127);
    assert!(is_missing || run.status.success(), "{line}: {}", String::from_utf8_lossy(&run.stderr));
    !is_missing
}

/// The log at this path.
pub fn traced(path: &Path) -> Traced {
    let log = read(std::fs::File::open(path).expect("a log")).expect("a log");
    assert_eq!(log.damaged, [], "{}", path.display());
    let world = world_of(&log, Path::new(""), |name| Err(name.to_owned())).expect("objects");
    Traced::of(log, world.map(|(_, world)| Arc::new(world)))
}

fn assert_holds(name: &str, traced: Traced) {
    let verdict = RayVerdict::of(traced);
    assert!(!verdict.is_broken(), "{name}: {}", verdict.text());
    assert!(verdict.of_outcome(Outcome::Held).count() >= 5, "{name}: {}", verdict.text());
}

/// Law: what the writer of each language writes of an honest tracer can be read whole and breaks no law. Oracle: six tracers
/// that share no code, with other scenes and habits each.
#[test]
fn an_honest_tracer_breaks_no_law() {
    let root = PathBuf::from(env!("CARGO_MANIFEST_DIR"));
    for (language, build, run) in TRACERS {
        let folder = tempfile::tempdir().expect("a folder");
        for from in [root.join("writers"), root.join("../../examples/rays")] {
            for entry in std::fs::read_dir(from).expect("files").flatten() {
                if entry.path().is_file() {
                    std::fs::copy(entry.path(), folder.path().join(entry.file_name()))
                        .expect("a copy");
                }
            }
        }
        let is_built = shell(folder.path(), build);
        assert!(is_built || !ALWAYS.contains(language), "no compiler of {language}");
        if is_built && shell(folder.path(), &format!("{run} > picture")) {
            let traced = traced(&folder.path().join("rays.jsonl"));
            let has_camera = traced.log.rays.iter().any(|ray| ray.is(&Purpose::Camera));
            assert!(has_camera, "{language}");
            assert_holds(language, traced);
        }
    }
}

/// Law: no habit of honest programs breaks a law: vectors in single beside numbers in double, six decimals, marks for a miss,
/// shadow rays from the lamp, no kinds, lengths for `t`. Oracle: logs of right tracers, rewritten so.
#[test]
fn no_honest_habit_breaks_a_law() {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/honest");
    let mut count = 0;
    for entry in std::fs::read_dir(folder).expect("logs").flatten() {
        let name = entry.file_name().to_string_lossy().into_owned();
        assert_holds(&name, traced(&entry.path()));
        // and without the objects and the head
        let text = std::fs::read_to_string(entry.path()).expect("a log");
        let rays =
            text.lines().filter(|line| line.contains("origin")).collect::<Vec<_>>().join("\n");
        let bare = Traced::of(read(rays.as_bytes()).expect("a log"), None);
        let verdict = RayVerdict::of(bare);
        assert!(!verdict.is_broken(), "{name} without objects: {}", verdict.text());
        count += 1;
    }
    assert_eq!(count, 32);
}

/// Law: light that is added where a ray hits a lamp by chance, though the lamp is sampled, too, counts twice, in a program that
/// knows no MIS weights. Oracle: the same log without what is emitted there, which is among the honest ones.
#[test]
fn light_that_counts_twice_is_told() {
    let file = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/light-twice.jsonl");
    let verdict = RayVerdict::of(traced(&file));
    let (law, asked, _) = verdict.first().expect("a broken law");
    assert_eq!(law.name, "mis-weights");
    let cause = law.cause(asked.roots()).expect("a cause");
    assert!(cause.contains("light counts twice"), "{cause}");
}

/// Law: a writer needs at most 120 lines. Oracle: counting.
#[test]
fn writers_are_short() {
    for (name, text) in WRITERS {
        assert!(text.lines().count() <= 120, "{name}");
    }
}
