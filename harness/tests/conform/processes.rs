//! Processes that misbehave: each gets its status, the run ends, and nothing is left running.

use std::path::PathBuf;
use std::process::{Command, Output};
use std::time::{Duration, Instant};

use serde_json::Value;

/// A run of `conform` over a few families, with a shell script for the program; `$P` is our probe.
fn conform(script: &str, arguments: &[&str]) -> Output {
    let groundtruth = env!("CARGO_BIN_EXE_groundtruth");
    Command::new(groundtruth)
        .arg("conform")
        .args(["--cases", "24", "--timeout", "1", "--start-timeout", "5"])
        .args(arguments)
        .args(["--", "sh", "-c", script])
        .env("P", format!("{groundtruth} probe"))
        .output()
        .expect("groundtruth starts")
}

const FEW: [&str; 3] = ["intersect.sphere.ordinary", "intersect.sphere.grazing", "--json"];

/// How many cases of each status a run counted.
fn counts(output: &Output) -> std::collections::BTreeMap<String, u64> {
    let text = String::from_utf8_lossy(&output.stdout);
    let errors = String::from_utf8_lossy(&output.stderr);
    let card: Value =
        serde_json::from_str(&text).unwrap_or_else(|e| panic!("{e}: {text} {errors}"));
    let mut all = std::collections::BTreeMap::new();
    for family in card["families"].as_array().expect("families") {
        for (status, count) in family["counts"].as_object().expect("counts") {
            *all.entry(status.clone()).or_default() += count.as_u64().unwrap_or(0);
        }
    }
    all
}

/// Law: a misbehaving program's cases get this status, and the exit status is 1. Oracle: the script.
fn has_status(script: &str, status: &str) {
    let begun = Instant::now();
    let output = conform(script, &FEW);
    let counts = counts(&output);
    assert!(counts[status] > 0, "{script}: {counts:?}");
    assert_eq!(output.status.code(), Some(1), "{script}: {counts:?}");
    assert!(begun.elapsed() < Duration::from_secs(60), "{script}");
}

/// Law: a program that answers nothing ends the run with status 2, and what was received is printed. Oracle: the
/// script.
fn answers_nothing(script: &str, printed: &str) {
    let output = conform(script, &FEW);
    let errors = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{script}: {errors}");
    assert!(errors.contains(printed), "{script}: {errors}");
}

#[test]
fn our_probe_passes() {
    let output = conform("exec $P", &FEW);
    assert_eq!(output.status.code(), Some(0), "{:?}", counts(&output));
}

#[test]
fn a_program_that_hangs_is_hung() {
    answers_nothing("cat > /dev/null", "no answer within");
    // answers the first, then no more
    has_status("sed -u 1q | $P; cat > /dev/null", "hung");
}

#[test]
fn a_program_that_ends_has_died() {
    answers_nothing("exit 3", "exit status: 3");
    has_status("sed -u 20q | $P", "died");
}

#[test]
fn a_program_that_is_not_there_is_said_so() {
    let groundtruth = env!("CARGO_BIN_EXE_groundtruth");
    let output = Command::new(groundtruth)
        .args(["conform", "fresnel", "--", "/no/such/program"])
        .output()
        .expect("groundtruth starts");
    let errors = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{errors}");
    assert!(errors.contains("cannot start /no/such/program"), "{errors}");
}

#[test]
fn a_closed_output_is_a_death() {
    answers_nothing("exec >&-; exec sleep 100", "closed its output");
}

#[test]
fn a_banner_is_garbled() {
    answers_nothing("echo My tracer 1.0; exec $P", "My tracer 1.0");
    // only now and then
    has_status("$P | sed -u '9a still well'", "garbled");
}

#[test]
fn two_answers_to_one_question_are_garbled() {
    has_status("$P | sed -u p", "garbled");
}

#[test]
fn garbage_is_garbled() {
    answers_nothing("sed -u 's/.*/garbage/'", "not a JSON object: garbage");
    has_status("$P | sed -u '7s/answer/antwort/'", "garbled");
}

#[test]
fn a_flood_is_garbled() {
    answers_nothing("yes", "not a JSON object: y");
    // a line that never ends
    answers_nothing("tr '\\0' 'a' < /dev/zero", "a line longer than");
}

#[test]
fn a_refusal_is_refused_and_unsupported_is_no_failure() {
    has_status("$P | sed -u 's/\"answer\":.*/\"error\":\"no\"}/'", "refused");
    let output = conform("$P | sed -u 's/\"answer\":.*/\"unsupported\":\"no\"}/'", &FEW);
    // but nothing else is no verdict
    assert_eq!(output.status.code(), Some(2), "{:?}", counts(&output));
    assert!(counts(&output)["unsupported"] > 0);
    let some = "$P | sed -u '/\"t\"/!s/\"answer\":.*/\"unsupported\":\"no\"}/'";
    let output = conform(some, &["intersect.sphere.ordinary", "fresnel.cosine", "--json"]);
    assert_eq!(output.status.code(), Some(0), "{:?}", counts(&output));
}

#[test]
fn standard_error_is_read_and_not_judged() {
    let output = conform("head -c 100000000 /dev/zero >&2; exec $P", &FEW);
    assert_eq!(output.status.code(), Some(0), "{:?}", counts(&output));
}

#[test]
fn slow_answers_are_waited_for() {
    let slow = "$P | while IFS= read -r line; do sleep 0.01; printf '%s\\n' \"$line\"; done";
    let output = conform(slow, &FEW);
    assert_eq!(output.status.code(), Some(0), "{:?}", counts(&output));
}

/// Law: answers may come in any order: they are matched by id. Oracle: a program that answers each chunk of questions
/// from the last to the first.
#[test]
fn answers_may_come_out_of_order() {
    if Command::new("python3").arg("--version").output().is_err() {
        println!("skipped: no python3");
        return;
    }
    let script = r#"exec python3 -c '
import os, subprocess, sys
p = subprocess.Popen([sys.argv[1], "probe"], stdin=subprocess.PIPE, stdout=subprocess.PIPE)
while chunk := os.read(0, 1 << 20):
    answers = []
    for line in chunk.splitlines(True):
        p.stdin.write(line); p.stdin.flush()
        if line.endswith(b"\n"): answers.append(p.stdout.readline())
    os.write(1, b"".join(reversed(answers)))
' ${P% probe}"#;
    let output = conform(script, &FEW);
    assert_eq!(output.status.code(), Some(0), "{:?}", counts(&output));
}

/// Law: whatever a program's children do, nothing is left when the run has ended. Oracle: the system's list of
/// processes.
#[test]
fn nothing_is_left_running() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("pids");
    let shown = file.display();
    // children that ignore requests to end
    let script = format!(
        "sh -c \"trap '' TERM INT HUP; sleep 300 & echo \\$! >> {shown}; wait\" & echo $! >> {shown}; \
         trap '' TERM INT HUP; echo $$ >> {shown}; $P"
    );
    let output = conform(&script, &FEW);
    assert_eq!(output.status.code(), Some(0), "{:?}", counts(&output));
    let pids = std::fs::read_to_string(&file).expect("the script wrote it");
    assert!(pids.lines().count() >= 3, "{pids}");
    std::thread::sleep(Duration::from_millis(200));
    for pid in pids.lines() {
        let status = std::fs::read_to_string(PathBuf::from(format!("/proc/{pid}/status")));
        // one that has ended may wait for its parent to take note
        let is_running = status.is_ok_and(|status| !status.contains("State:\tZ"));
        assert!(!is_running, "{pid} is running");
    }
}

/// Law: a program that prints NaN or an infinity as its language does is wrong where it prints it, and is not ended: each
/// case is judged. Oracle: our probe, with `t` replaced in its lines.
#[test]
fn numbers_that_are_not_finite_are_wrong_answers() {
    for word in ["NaN", "-nan", "-nan(ind)", "Infinity", "1e999", "null"] {
        let script = format!("$P | sed -u -E 's/\"t\":[-+0-9.e]+/\"t\":{word}/'");
        let output = conform(&script, &["intersect.sphere.ordinary", "--json"]);
        let counts = counts(&output);
        assert!(counts["wrong"] > 10, "{word}: {counts:?}");
        assert_eq!(counts["garbled"] + counts["died"] + counts["hung"], 0, "{word}: {counts:?}");
    }
}

/// Law: an infinity that is right is right as `Infinity`, too. Oracle: the distance of a sun.
#[test]
fn a_right_infinity_may_be_printed_without_quotes() {
    let script = "$P | sed -u 's/\"inf\"/Infinity/'";
    let output = conform(script, &["light.directional", "--json"]);
    assert_eq!(output.status.code(), Some(0), "{:?}", counts(&output));
}
