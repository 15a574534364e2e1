//! Runs of other programs.

use std::process::Command;
use std::time::{Duration, Instant};

use pictures::running::*;

use crate::verbs::equal;

/// Law: a program that does not end is ended at the limit, and what it said last is quoted, also if a process that
/// it started lives on; one that ends is not. Oracle: shells that sleep.
#[test]
fn a_program_that_does_not_end_is_ended_and_quoted() {
    let shell = |script: &str, limit| {
        run(Command::new("sh").args(["-c", script]), Duration::from_millis(limit))
    };
    let begun = Instant::now();
    let error = shell("echo first; echo last >&2; sleep 20 & sleep 20", 300).err();
    let error = error.expect("it sleeps on");
    assert!(error.contains("first\n  last") && error.contains("--time-limit"), "{error}");
    assert!(begun.elapsed() < Duration::from_secs(10));
    let run = shell("echo said >&2; exit 3", 60_000).expect("it ends");
    assert_eq!((run.status.code(), &*run.messages), (Some(3), &b"said\n"[..]));
}

/// Law: of what a program wrote, the last twelve lines are quoted, without empty ones. Oracle: numbered lines.
#[test]
fn the_last_twelve_lines_are_quoted() {
    for count in [0, 1, 11, 12, 13, 40] {
        let lines: String = (0..count).map(|line| format!("line {line}\n \n")).collect();
        let quoted: Vec<String> =
            (0..count).rev().take(12).map(|line| format!("line {line}")).rev().collect();
        equal(format!("of {count} lines"), last_lines(lines.as_bytes()), quoted.join("\n  "));
    }
}
