//! The commands `render --replicas` and `merge`: parts, and every exit status.

mod borders;
mod damage;
#[path = "../pictures/tests/sums/header.rs"]
mod header;
#[cfg(unix)]
mod interrupt;
mod means;
mod merged;
mod shares;

use std::fs;
use std::hash::{BuildHasher, RandomState};
use std::io::Write;
use std::path::Path;
use std::process::{Command, Stdio};

use serde_json::Value;

const GROUNDTRUTH: &str = env!("CARGO_BIN_EXE_groundtruth");

/// A small picture with noise.
pub const SCENE: &str = "ch18/rectangle --size 12x8 --samples 4";

/// The result of a run of the program.
pub struct Run {
    pub status: Option<i32>,
    pub stdout: String,
    pub stderr: String,
}

pub fn command(folder: &Path, line: &str) -> Command {
    let mut command = Command::new(GROUNDTRUTH);
    command.current_dir(folder).args(line.split_whitespace()).stdin(Stdio::null());
    command
}

/// Runs the program in a folder, with these arguments.
pub fn run(folder: &Path, line: &str) -> Run {
    let output = command(folder, line).output().expect("it starts");
    let text = |bytes| String::from_utf8(bytes).expect("UTF-8");
    Run { status: output.status.code(), stdout: text(output.stdout), stderr: text(output.stderr) }
}

/// Runs the program, and fails unless it ends with this status.
pub fn expect(status: i32, folder: &Path, line: &str) -> Run {
    let run = run(folder, line);
    assert_eq!(run.status, Some(status), "{line}: {}{}", run.stdout, run.stderr);
    run
}

/// The answer of the probe to a question.
pub fn probe(folder: &Path, question: &str) -> Value {
    let mut child = Command::new(GROUNDTRUTH)
        .current_dir(folder)
        .arg("probe")
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("it starts");
    let mut stdin = child.stdin.take().expect("piped");
    writeln!(stdin, "{question}").expect("it reads");
    drop(stdin);
    let output = child.wait_with_output().expect("it ends");
    let answer: Value = serde_json::from_slice(&output.stdout).expect("a line of JSON");
    assert!(answer.get("answer").is_some(), "{answer}");
    answer["answer"].clone()
}

/// Renders replicas from seed 1 on, as this number of parts: `a0.sums`, `a1.sums` …
pub fn parts(folder: &Path, name: &str, count: u32, replicas: u32) -> Vec<String> {
    let part = |k: u32| {
        let file = format!("{name}{k}.sums");
        let line = format!("render {SCENE} --seed 1 --replicas {replicas} --part {k}/{count}");
        expect(0, folder, &format!("{line} -o {file}"));
        file
    };
    (0..count).map(part).collect()
}

pub fn read(folder: &Path, file: &str) -> Vec<u8> {
    fs::read(folder.join(file)).unwrap_or_else(|e| panic!("{file}: {e}"))
}

/// Law: 1, 3 and 7 parts in any order give the same bytes, also if they are merged in two steps. Oracle: one part.
#[test]
fn any_division_and_any_order_give_the_same_bytes() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = folder.path();
    let whole = &parts(at, "one", 1, 7)[0];
    let (three, seven) = (parts(at, "three", 3, 7), parts(at, "seven", 7, 7));
    let reversed: Vec<String> = seven.iter().rev().cloned().collect();
    let turned = format!("{} {} {}", three[1], three[2], three[0]);
    for files in [whole.clone(), three.join(" "), turned, seven.join(" "), reversed.join(" ")] {
        let run = expect(0, at, &format!("merge {files} -o mean.sums"));
        assert_eq!(
            run.stdout,
            "whole: 7 of 7 replicas\nnext: groundtruth merge mean.sums -o mean.exr --standard-error error.exr\n"
        );
        assert_eq!(read(at, "mean.sums"), read(at, whole), "{files}");
    }
    expect(1, at, &format!("merge {} {} -o two.sums", three[2], three[1]));
    expect(0, at, &format!("merge two.sums {} -o mean.sums --standard-error e.exr", three[0]));
    assert_eq!(read(at, "mean.sums"), read(at, whole));
    expect(0, at, &format!("merge {whole} -o b.exr"));
    expect(0, at, &format!("merge {} -o a.exr", seven.join(" ")));
    assert_eq!(read(at, "a.exr"), read(at, "b.exr"));
}

/// Law: 64 parts in any order give the bytes of one part. Oracle: one part; orders drawn at random.
#[test]
fn many_parts_in_random_order_give_the_same_bytes() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = folder.path();
    let whole = &parts(at, "whole", 1, 100)[0];
    let mut files = parts(at, "a", 64, 100);
    for _ in 0..4 {
        let order = RandomState::new();
        files.sort_by_cached_key(|file| order.hash_one(file));
        let files = files.join(" ");
        expect(0, at, &format!("merge {files} -o mean.sums"));
        assert_eq!(read(at, "mean.sums"), read(at, whole), "{files}");
    }
}

/// Law: what is missing is printed as commands, and with what these render nothing is missing. Oracle: the commands.
#[test]
fn the_commands_for_missing_replicas_render_them() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = folder.path();
    let files = parts(at, "a", 5, 9);
    let run = expect(1, at, &format!("merge {} {} -o mean.sums", files[1], files[3]));
    let lines: Vec<&str> = run.stdout.lines().collect();
    assert_eq!(lines[0], "not whole: 4 of 9 replicas");
    assert_eq!(lines[1], "missing: seeds 1, 4 to 5, 8 to 9; render and merge them as well");
    let mut all = format!("{} {}", files[1], files[3]);
    for line in &lines[2..] {
        let arguments = line
            .trim_start_matches("next:")
            .trim()
            .strip_prefix("groundtruth ")
            .expect("a command");
        expect(0, at, arguments);
        all += &format!(" {}", arguments.rsplit(' ').next().expect("a file"));
    }
    expect(0, at, &format!("merge {all} -o mean.sums"));
    expect(0, at, &format!("merge {} -o whole.sums", files.join(" ")));
    assert_eq!(read(at, "mean.sums"), read(at, "whole.sums"));
}

/// Law: a part that comes twice counts once, and is named. Oracle: the bytes of a merge without it.
#[test]
fn what_comes_twice_counts_once() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = folder.path();
    let whole = &parts(at, "whole", 1, 6)[0];
    let halves = parts(at, "half", 2, 6);
    let both = halves.join(" ");
    fs::copy(at.join(&halves[0]), at.join("copy.sums")).expect("copied");
    let run = expect(0, at, &format!("merge {both} copy.sums -o mean.sums"));
    assert_eq!(run.stderr, "note: copy.sums has the same sums as half0.sums, and is left out\n");
    assert_eq!(read(at, "mean.sums"), read(at, whole));
}

/// Law: parts that overlap, and are not of the same seeds, are refused, both named, and nothing is written. Oracle: the seeds
/// asked for.
#[test]
fn parts_that_overlap_are_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = folder.path();
    expect(0, at, &format!("render {SCENE} --seed 1 --replicas 4 -o a.sums"));
    expect(0, at, &format!("render {SCENE} --seed 3 --replicas 4 -o b.sums"));
    let run = expect(1, at, "merge a.sums b.sums -o mean.exr");
    assert_eq!(
        run.stderr,
        "error: b.sums and a.sums both have seeds 3 to 4: render one of them anew, with the other seeds alone\n"
    );
    assert!(!at.join("mean.exr").exists());
}

/// Law: a part of another scene, size or number of samples is refused by `merge` and by a continued `render`, with
/// status 2 and its name; the same scene under another name is not. Oracle: the arguments.
#[test]
fn another_scene_is_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = folder.path();
    parts(at, "a", 1, 2);
    for (other, what) in [
        ("ch18/sphere --size 12x8 --samples 4", "another scene ("),
        ("ch18/rectangle --size 13x8 --samples 4", "another size (13x8, not 12x8)"),
        ("ch18/rectangle --size 12x8 --samples 9", "another samples a replica (9, not 4)"),
        ("ch18/rectangle --size 12x8 --samples 4 --tracer whitted", "another scene ("),
    ] {
        expect(0, at, &format!("render {other} --seed 3 --replicas 2 -o b.sums"));
        let run = expect(2, at, "merge a0.sums b.sums -o mean.exr");
        assert!(run.stderr.starts_with(&format!("error: b.sums: is of {what}")), "{}", run.stderr);
        let before = read(at, "b.sums");
        expect(2, at, &format!("render {SCENE} --seed 3 --replicas 2 -o b.sums"));
        assert_eq!(read(at, "b.sums"), before);
        fs::remove_file(at.join("b.sums")).expect("removed");
    }
    expect(0, at, "export ch18/rectangle --size 12x8 --samples 4 -o scene.toml");
    expect(0, at, "render scene.toml --seed 3 --replicas 2 -o b.sums");
    expect(0, at, "merge a0.sums b.sums -o mean.exr");
    // seeds that are not of this part
    expect(2, at, &format!("render {SCENE} --seed 1 --replicas 2 -o b.sums"));
}

/// Law: a scene is the same wherever it and its files are, and another one when a file has changed. Oracle: copies.
#[test]
fn a_changed_mesh_file_makes_another_scene() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = folder.path();
    let scenes = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../scenes"));
    for (seed, copy) in [(1, "a"), (2, "b"), (3, "c")] {
        fs::create_dir(at.join(copy)).expect("made");
        let mut mesh = fs::read(scenes.join("knot.ply")).expect("there");
        if copy == "c" {
            // the last bit of the first coordinate
            let end = mesh.windows(11).position(|bytes| bytes == b"end_header\n");
            mesh[end.expect("it has a header") + 11] ^= 1;
        }
        fs::write(at.join(copy).join("knot.ply"), mesh).expect("written");
        fs::copy(scenes.join("knot.toml"), at.join(copy).join("knot.toml")).expect("copied");
        let scene = format!("{copy}/knot.toml --size 6x4 --samples 1");
        expect(0, at, &format!("render {scene} --seed {seed} --replicas 1 -o {copy}.sums"));
    }
    expect(0, at, "merge a.sums b.sums -o mean.sums");
    let run = expect(2, at, "merge a.sums c.sums -o mean.exr");
    assert!(run.stderr.starts_with("error: c.sums: is of another scene ("), "{}", run.stderr);
}

/// Law: more replicas onto an existing part render only those that are missing. Oracle: a part in one run.
#[test]
fn a_part_is_continued() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = folder.path();
    expect(0, at, &format!("render {SCENE} --replicas 3 -o a.sums"));
    expect(0, at, &format!("render {SCENE} --replicas 5 -o a.sums"));
    expect(0, at, &format!("render {SCENE} --replicas 5 -o b.sums"));
    assert_eq!(read(at, "a.sums"), read(at, "b.sums"));
    expect(0, at, &format!("render {SCENE} --replicas 5 -o a.sums"));
    assert_eq!(read(at, "a.sums"), read(at, "b.sums"));
}

/// Law: what cannot be meant has status 2, and no file is left.
#[test]
fn bad_arguments_have_status_2() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = folder.path();
    for line in [
        "--replicas 4 -o a.exr",
        "-o a.sums",
        "--replicas 0 -o a.sums",
        "--replicas 4 --part 4/4 -o a.sums",
        "--replicas 4 --part 0/0 -o a.sums",
        "--replicas 4 --part 0/5 -o a.sums",
        "--part 0/5 -o a.png",
        "--replicas 4 --crop 0,0,2x2 -o a.sums",
        "--replicas 4 --seed 18446744073709551615 -o a.sums",
        "--replicas 4 -o no/a.sums",
    ] {
        expect(2, at, &format!("render {SCENE} {line}"));
    }
    for line in ["-o a.exr", "none.sums -o a.exr", "none.sums -o a.png"] {
        expect(2, at, &format!("merge {line}"));
    }
    assert_eq!(fs::read_dir(at).expect("there").count(), 0);
}
