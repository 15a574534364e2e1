//! The command `verify --before … --after …`: its exit statuses and its errors.

use std::io::Write;
use std::path::Path;
use std::process::{Command, Stdio};

use groundtruth::film::{self, Film, Tone};
use groundtruth::math::Pcg32;
use groundtruth::rgb::Rgb;

use super::structure::{read, root};

/// The exit status, and what was printed.
fn verify(arguments: &[&str]) -> (i32, String) {
    run(&[&["verify"], arguments].concat())
}

fn run(arguments: &[&str]) -> (i32, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_groundtruth"));
    let output = command.args(arguments).output().expect("the program runs");
    let printed = [output.stdout, output.stderr].concat();
    (output.status.code().expect("a status"), String::from_utf8(printed).expect("UTF-8"))
}

/// A grey picture with noise, written into a folder.
fn picture(folder: &Path, [side, seed]: [u32; 2], brightness: f64) -> String {
    let mut random = Pcg32::new(seed.into(), 1);
    let mut film = Film::new(side, side);
    for pixel in 0..side * side {
        film.set([pixel % side, pixel / side], Rgb::grey(brightness + 0.1 * random.uniform()));
    }
    let file = folder.join(format!("{side}-{seed}-{brightness}.pfm"));
    film::write(&film, &Tone::PLAIN, &file).expect("written");
    file.to_str().expect("UTF-8").to_owned()
}

/// Law: the exit status is 0 for sets that agree, 1 for sets that differ, 2 where it cannot be told or the sets cannot be
/// compared; each error says what to do. Oracle: how the pictures were made.
#[test]
fn every_exit_status() {
    let folder = tempfile::tempdir().expect("a folder");
    let set = |seeds: std::ops::Range<u32>, brightness| -> Vec<String> {
        seeds.map(|seed| picture(folder.path(), [16, seed], brightness)).collect()
    };
    let asked = |before: &[String], after: &[String], more: &[&str]| {
        let of = |files: &[String]| files.to_vec();
        let all = [vec!["--before".to_owned()], of(before), vec!["--after".to_owned()], of(after)];
        let all = all.concat();
        verify(&[&all.iter().map(String::as_str).collect::<Vec<&str>>(), more].concat())
    };
    let (before, after, brighter) = (set(0..5, 0.5), set(5..10, 0.5), set(5..10, 0.6));
    let (status, text) = asked(&before, &after, &[]);
    assert_eq!(status, 0, "{text}");
    for part in ["agree: ", "would have been seen: ", "126 ways", "noise: "] {
        assert!(text.contains(part), "no {part:?} in {text}");
    }
    let page = folder.path().join("page.html");
    let (status, text) = asked(&before, &brighter, &["-o", page.to_str().expect("UTF-8")]);
    assert_eq!(status, 1, "{text}");
    assert!(text.starts_with("differ: ") && text.contains("groundtruth compare"), "{text}");
    assert!(std::fs::read_to_string(page).expect("written").contains("<h1>differ: "));
    // 0.6 is 20 % more than 0.5
    for (margin, expected) in [("50%", 0), ("25%", 0), ("15%", 1), ("1%", 1)] {
        let (status, text) = asked(&before, &brighter, &["--margin", margin]);
        assert_eq!(status, expected, "--margin {margin}: {text}");
    }
    let (status, text) = asked(&before, &after, &["--margin", "0.001%"]);
    assert_eq!(status, 2, "--margin 0.001% of noise: {text}");
    let (status, json) = asked(&before, &brighter, &["--margin", "1%", "--json"]);
    let json: serde_json::Value = serde_json::from_str(&json).expect("JSON");
    assert_eq!((status, &json["decision"]), (1, &"differ".into()));
    let (status, text) = asked(&before[..1], &after[..1], &[]);
    assert!(status == 2 && text.contains("cannot tell: "), "{text}");
    let twice = [before[0].clone(), before[1].clone(), before[0].clone()];
    let small = [picture(folder.path(), [8, 1], 0.5)];
    let (one, more) = (&before[..2], &after[..2]);
    for (sets, more, words) in [
        ([&twice[..], more], vec![], "has the same values as"),
        ([one, &small[..]], vec![], "all pictures must have one size"),
        ([one, more], vec!["--regions", &*small[0]], "each pixel has a region"),
        ([one, more], vec!["--regions", &*before[0], "--level", "2"], "0.0001 to 0.2"),
        ([one, more], vec!["--replicas", "9"], "cannot be used with"),
    ] {
        let (status, text) = asked(sets[0], sets[1], &more);
        assert!(status == 2 && text.contains(words), "{words:?}: {text}");
    }
    let (status, text) = verify(&["--before", &before[0]]);
    assert!(status == 2 && text.contains("--after"), "{text}");
}

/// A picture of one value, written into a folder.
fn flat(folder: &Path, [side, number]: [u32; 2], value: f32) -> String {
    let file = folder.join(format!("{side}-{number}-{value:e}.pfm"));
    let mut bytes = format!("PF\n{side} {side}\n-1.0\n").into_bytes();
    (0..3 * side * side).for_each(|_| bytes.extend(value.to_le_bytes()));
    std::fs::write(&file, bytes).expect("written");
    file.to_str().expect("UTF-8").to_owned()
}

/// Values at the ends of what a file can hold.
const EXTREME: [f32; 9] =
    [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, f32::MAX, -f32::MAX, -5.0, 1e20, 0.0, 1e-45];

/// Law: pictures of extreme values are compared without a panic. `compare` finds a difference unless both values are numbers
/// or infinities that are the same; so does one picture a side, but that it cannot tell where no side has a number; one such
/// picture in a set of ordinary ones differs and is named. Oracle: the values.
#[test]
fn extreme_values_are_compared() {
    let folder = tempfile::tempdir().expect("a folder");
    for side in [1, 5] {
        for (a, b) in EXTREME.iter().flat_map(|a| EXTREME.map(|b| (*a, b))) {
            let [before, after] =
                [(0, a), (1, b)].map(|(at, it)| flat(folder.path(), [side, at], it));
            let (what, apart) = (format!("{side}: {a:e} and {b:e}"), f64::from(a) - f64::from(b));
            let (status, text) = run(&["compare", &before, &after]);
            assert_eq!(status, i32::from(a != b), "compare {what}: {text}");
            let is_named = text.contains("values that are no numbers");
            assert_eq!(is_named, a != b && !apart.is_finite(), "{what}: {text}");
            let expected = match [a, b].map(f32::is_finite) {
                [true, true] => i32::from(a != b),
                [false, false] => 2,
                _ => 1,
            };
            // the noise of a single row is not known
            let (status, text) = verify(&["--before", &before, "--after", &after]);
            let expected =
                if side == 1 && expected == 1 && apart.is_finite() { 2 } else { expected };
            assert_eq!(status, expected, "one picture, {what}: {text}");
        }
    }
    let set = |seeds: std::ops::Range<u32>| -> Vec<String> {
        seeds.map(|seed| picture(folder.path(), [16, seed], 9.0)).collect()
    };
    let (before, after) = (set(0..5), set(5..9));
    for value in EXTREME {
        let odd = flat(folder.path(), [16, 0], value);
        let sets = [
            vec!["--before".to_owned()],
            before.clone(),
            vec!["--after".to_owned()],
            after.clone(),
        ];
        let all = [sets.concat(), vec![odd]].concat();
        let (status, text) = verify(&all.iter().map(String::as_str).collect::<Vec<&str>>());
        assert!(status == 1 && text.starts_with("differ: picture 5 after: "), "{value:e}: {text}");
    }
}

/// Law: a comparison that is interrupted while it reads ends with status 130 and says so, and leaves no page. Oracle: the
/// standard input, which ends after the signal; it is longer than a pipe holds, so that the program has begun to read.
#[test]
#[cfg(unix)]
fn an_interrupted_comparison_has_status_130() {
    let folder = tempfile::tempdir().expect("a folder");
    let bytes = std::fs::read(picture(folder.path(), [128, 1], 0.5)).expect("written");
    assert!(bytes.len() > 1 << 17);
    let (after, page) = (picture(folder.path(), [128, 2], 0.5), folder.path().join("page.html"));
    let mut command = Command::new(env!("CARGO_BIN_EXE_groundtruth"));
    let command = command.args(["verify", "--before", "-", "--after", &after, "-o"]).arg(&page);
    let command = command.stdin(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().expect("it starts");
    let mut input = child.stdin.take().expect("piped");
    input.write_all(&bytes).expect("it reads");
    let kill = Command::new("kill").args(["-INT", &child.id().to_string()]).status();
    assert!(kill.expect("kill starts").success());
    drop(input);
    let output = child.wait_with_output().expect("it ends");
    let said = String::from_utf8(output.stderr).expect("UTF-8");
    assert_eq!(output.status.code(), Some(130), "{said}");
    assert!(said.ends_with("interrupted; nothing was written\n") && !page.exists(), "{said}");
}

/// Law: the tour of docs/ci.md can be taken: its lines render the sets, and its commands print what it shows, with these
/// exit statuses. Oracle: the document.
#[test]
fn the_tour_of_the_document_can_be_taken() {
    let page = read(&root().join("docs/ci.md"));
    let folder = tempfile::tempdir().expect("a folder");
    let programs = Path::new(env!("CARGO_BIN_EXE_groundtruth")).parent().expect("a folder");
    let path = format!("{}:{}", programs.display(), std::env::var("PATH").unwrap_or_default());
    let shell = |line: &str| {
        let mut shell = Command::new("sh");
        let shell = shell.args(["-c", line]).current_dir(folder.path()).env("PATH", &path);
        let output = shell.output().expect("a shell");
        (output.status.code(), String::from_utf8(output.stdout).expect("UTF-8"))
    };
    let blocks: Vec<&str> = page.split("```").collect();
    let rendered = blocks.iter().filter(|block| block.starts_with("sh\nmkdir reference"));
    let rendered: Vec<&str> = rendered.filter_map(|block| block.strip_prefix("sh\n")).collect();
    assert_eq!(rendered.len(), 1);
    assert_eq!(shell(rendered[0]).0, Some(0));
    let mut statuses = Vec::new();
    for block in blocks.iter().filter_map(|block| block.strip_prefix("console\n$ ")) {
        let (line, shown) = block.split_once('\n').expect("what is printed");
        let (status, printed) = shell(line);
        assert_eq!(printed, shown);
        statuses.push(status);
    }
    assert_eq!(statuses, [Some(0), Some(1)]);
}
