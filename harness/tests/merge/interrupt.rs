//! Replicas that are interrupted by signals.

use std::fs;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use super::{command, expect};
use crate::kit::Folder;

/// Many replicas of a tenth of a second or less each.
const SLOW: &str = "render ch18/rectangle --size 60x40 --samples 4 --seed 1 --replicas 60";

/// Starts a rendering, and signals it after some time.
fn interrupted(folder: &Folder, signal: &str, after: Duration) -> Option<i32> {
    let mut child = started(folder, SLOW);
    std::thread::sleep(after);
    send(signal, &child);
    child.wait().expect("it ends").code()
}

/// Starts a rendering of `a.sums`.
fn started(folder: &Folder, line: &str) -> Child {
    let mut command = command(folder, &format!("{line} -o a.sums"));
    command.stderr(Stdio::null()).spawn().expect("it starts")
}

fn send(signal: &str, child: &Child) {
    let kill = Command::new("kill").args([signal, &child.id().to_string()]).status();
    assert!(kill.expect("kill starts").success());
}

/// Law: a part that was interrupted by either signal is valid, and continued it is that of one run; the status is 130.
/// Oracle: the bytes of one run.
#[test]
fn an_interrupted_part_is_valid_and_is_continued() {
    let at = &Folder::new();
    let start = Instant::now();
    expect(0, at, &format!("{SLOW} -o whole.sums"));
    let whole = start.elapsed();
    for signal in ["-INT", "-TERM"] {
        let mut share = whole / 3;
        // on a busy machine it may have ended before, or not have begun
        let is_partial = (0..20).any(|_| {
            let _ = fs::remove_file(at.path().join("a.sums"));
            let status = interrupted(at, signal, share);
            if status == Some(130) && at.path().join("a.sums").exists() {
                return true;
            }
            share = if status == Some(0) { share / 2 } else { share + share / 4 };
            false
        });
        assert!(is_partial, "it was never interrupted between two replicas");
        let run = expect(1, at, "merge a.sums -o mean.exr");
        assert!(run.stdout.starts_with("not whole: ") && run.stdout.contains(" of 60 replicas"));
        expect(0, at, &format!("{SLOW} -o a.sums"));
        assert_eq!(at.bytes("a.sums"), at.bytes("whole.sums"), "{signal}");
    }
}

/// Replicas of a second or more each.
const SLOWER: &str = "render ch18/rectangle --size 120x80 --samples 64 --seed 1";

/// Law: after a second signal the replica under way is cancelled at once, and never added: the part holds the finished
/// replicas only, and the status is 130. Oracle: the mean of as many replicas, rendered by themselves.
#[test]
fn a_second_signal_drops_the_replica_under_way() {
    let at = &Folder::new();
    let start = Instant::now();
    expect(0, at, &format!("{SLOWER} --replicas 1 -o one.sums"));
    let one = start.elapsed();
    expect(0, at, "merge one.sums -o one.pfm");
    expect(0, at, &format!("{SLOWER} --replicas 2 -o two.sums"));
    expect(0, at, "merge two.sums -o two.pfm");
    let mut share = one / 4;
    // on a busy machine the replica may have ended before the second signal, or not have begun at the first one
    let is_cancelled = (0..20).any(|_| {
        fs::copy(at.path().join("one.sums"), at.path().join("a.sums")).expect("copied");
        let mut child = started(at, &format!("{SLOWER} --replicas 3"));
        std::thread::sleep(share);
        let first = Instant::now();
        send("-INT", &child);
        std::thread::sleep(Duration::from_millis(50));
        send("-INT", &child);
        let status = child.wait().expect("it ends").code();
        let took = first.elapsed();
        if status != Some(130) {
            share = if status == Some(0) { share / 2 } else { share + share / 4 };
            return false;
        }
        let run = expect(1, at, "merge a.sums -o a.pfm");
        let count = if run.stdout.starts_with("not whole: 1 of 3") { "one" } else { "two" };
        let expected = at.bytes(&format!("{count}.pfm"));
        assert!(at.bytes("a.pfm") == expected, "it holds an unfinished replica: {}", run.stdout);
        // one that ended by itself may have had less time than the first: the machine was busier then
        share = if count == "two" { share / 2 } else { share };
        count == "one" && took < one * 3 / 4
    });
    assert!(is_cancelled, "no replica was ever cancelled");
    expect(0, at, &format!("{SLOWER} --replicas 3 -o a.sums"));
    expect(0, at, &format!("{SLOWER} --replicas 3 -o three.sums"));
    assert_eq!(at.bytes("a.sums"), at.bytes("three.sums"));
}
