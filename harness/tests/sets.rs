//! The command `verify --before … --after …`: its exit statuses and its errors.

use std::io::Write;
use std::ops::Range;
use std::process::Stdio;

use groundtruth::film::{self, Film, Tone};
use groundtruth::math::Pcg32;
use groundtruth::rgb::Rgb;

use crate::kit::{Folder, Run};

/// A grey picture with noise, written into a folder.
fn picture(folder: &Folder, [side, seed]: [u32; 2], brightness: f64) -> String {
    let mut random = Pcg32::new(seed.into(), 1);
    let mut film = Film::new(side, side);
    for pixel in 0..side * side {
        film.set([pixel % side, pixel / side], Rgb::grey(brightness + 0.1 * random.uniform()));
    }
    let name = format!("{side}-{seed}-{brightness}.pfm");
    film::write(&film, &Tone::PLAIN, &folder.path().join(&name)).expect("written");
    name
}

/// Pictures of these seeds.
fn set(folder: &Folder, seeds: Range<u32>, brightness: f64) -> String {
    let names: Vec<String> = seeds.map(|seed| picture(folder, [16, seed], brightness)).collect();
    names.join(" ")
}

fn verify(folder: &Folder, before: &str, after: &str, more: &str) -> Run {
    folder.run(&format!("groundtruth verify --before {before} --after {after} {more}"))
}

/// Law: the exit status is 0 for sets that agree, 1 for sets that differ, 2 where it cannot be told or the sets cannot be
/// compared; each error says what to do. Oracle: how the pictures were made.
#[test]
fn every_exit_status() {
    let folder = &Folder::new();
    let [before, after] = [0..5, 5..10].map(|seeds| set(folder, seeds, 0.5));
    let brighter = set(folder, 5..10, 0.6);
    let words = ["agree: ", "would have been seen: ", "126 ways", "noise: "];
    verify(folder, &before, &after, "").expect(0, &words);
    let told = verify(folder, &before, &brighter, "-o page.html");
    assert!(told.expect(1, &["groundtruth compare"]).stdout.starts_with("differ: "));
    assert!(folder.text("page.html").contains("<h1>differ: "));
    // 0.6 is 20 % more than 0.5
    for (margin, expected) in [("50%", 0), ("25%", 0), ("15%", 1), ("1%", 1)] {
        verify(folder, &before, &brighter, &format!("--margin {margin}")).expect(expected, &[]);
    }
    let json = verify(folder, &before, &brighter, "--margin 1% --json").expect(1, &[]).json();
    assert_eq!(json["decision"], "differ");
    picture(folder, [8, 1], 0.5);
    let (few, others) = ("16-0-0.5.pfm 16-1-0.5.pfm", "16-5-0.5.pfm 16-6-0.5.pfm");
    for (before, after, more, words) in [
        (&*before, &*after, "--margin 0.001%", "cannot tell: "),
        ("16-0-0.5.pfm", "16-5-0.5.pfm", "", "cannot tell: "),
        (&*format!("{few} 16-0-0.5.pfm"), others, "", "has the same values as"),
        (few, "8-1-0.5.pfm", "", "all pictures must have one size"),
        (few, others, "--regions 8-1-0.5.pfm", "each pixel has a region"),
        (few, others, "--regions 16-0-0.5.pfm --level 2", "0.0001 to 0.2"),
        (few, others, "--replicas 9", "cannot be used with"),
    ] {
        verify(folder, before, after, more).expect(2, &[words]);
    }
    folder.run("groundtruth verify --before 16-0-0.5.pfm").expect(2, &["--after"]);
}

/// A picture of one value, written into a folder.
fn flat(folder: &Folder, [side, number]: [u32; 2], value: f32) -> String {
    let name = format!("{side}-{number}-{value:e}.pfm");
    let mut bytes = format!("PF\n{side} {side}\n-1.0\n").into_bytes();
    (0..3 * side * side).for_each(|_| bytes.extend(value.to_le_bytes()));
    folder.write(&name, bytes);
    format!("./{name}")
}

/// Values at the ends of what a file can hold.
const EXTREME: [f32; 9] =
    [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, f32::MAX, -f32::MAX, -5.0, 1e20, 0.0, 1e-45];

/// Law: pictures of extreme values are compared without a panic. `compare` finds a difference unless both values are numbers
/// or infinities that are the same; so does one picture a side, but that it cannot tell where no side has a number; one such
/// picture in a set of ordinary ones differs and is named. Oracle: the values.
#[test]
fn extreme_values_are_compared() {
    let folder = &Folder::new();
    for side in [1, 5] {
        for (a, b) in EXTREME.iter().flat_map(|a| EXTREME.map(|b| (*a, b))) {
            let [before, after] = [(0, a), (1, b)].map(|(at, it)| flat(folder, [side, at], it));
            let apart = f64::from(a) - f64::from(b);
            let told = folder.run(&format!("groundtruth compare {before} {after}"));
            let told = told.expect(i32::from(a != b), &[]);
            let is_named = told.stdout.contains("values that are no numbers");
            assert_eq!(is_named, a != b && !apart.is_finite(), "{told:?}");
            let expected = match [a, b].map(f32::is_finite) {
                // the noise of a single row is not known
                [true, true] if side == 1 && a != b && apart.is_finite() => 2,
                [true, true] => i32::from(a != b),
                [false, false] => 2,
                _ => 1,
            };
            verify(folder, &before, &after, "").expect(expected, &[]);
        }
    }
    let [before, after] = [0..5, 5..9].map(|seeds| set(folder, seeds, 9.0));
    for value in EXTREME {
        let odd = flat(folder, [16, 0], value);
        let told = verify(folder, &before, &format!("{after} {odd}"), "").expect(1, &[]);
        assert!(told.stdout.starts_with("differ: picture 5 after: "), "{told:?}");
    }
}

/// Law: a comparison that is interrupted while it reads ends with status 130 and says so, and leaves no page. Oracle: the
/// standard input, which ends after the signal; it is longer than a pipe holds, so that the program has begun to read.
#[test]
#[cfg(unix)]
fn an_interrupted_comparison_has_status_130() {
    let folder = Folder::new();
    let [before, after] = [1, 2].map(|seed| picture(&folder, [128, seed], 0.5));
    let bytes = folder.bytes(&before);
    assert!(bytes.len() > 1 << 17);
    let line = format!("exec groundtruth verify --before - --after {after} -o page.html");
    let mut command = folder.command(&line);
    let mut child =
        command.stdin(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("it starts");
    let mut input = child.stdin.take().expect("piped");
    input.write_all(&bytes).expect("it reads");
    folder.good(&format!("kill -INT {}", child.id()));
    drop(input);
    let output = child.wait_with_output().expect("it ends");
    let said = String::from_utf8(output.stderr).expect("UTF-8");
    assert_eq!(output.status.code(), Some(130), "{said}");
    assert!(said.ends_with("interrupted; nothing was written\n"), "{said}");
    assert!(!folder.path().join("page.html").exists(), "{said}");
}
