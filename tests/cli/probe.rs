//! The probe as a process: its exit status, and an answer at once.

use std::io::{BufRead, BufReader, Write};
use std::process::{Command, Stdio};

use super::GROUNDTRUTH;

fn probe_process(input: &[u8]) -> (Option<i32>, String) {
    let mut child = Command::new(GROUNDTRUTH)
        .arg("probe")
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("it starts");
    child.stdin.take().expect("piped").write_all(input).expect("it reads");
    let output = child.wait_with_output().expect("it ends");
    (output.status.code(), String::from_utf8(output.stdout).expect("UTF-8"))
}

#[test]
fn the_exit_status_is_0_unless_a_line_got_an_error() {
    let good = "{\"fresnel\": {\"cos_i\": 1, \"eta\": 1}}\n";
    assert_eq!(probe_process(b"").0, Some(0));
    assert_eq!(probe_process(format!("{good}\n{good}").as_bytes()).0, Some(0));
    let (status, output) = probe_process(format!("{good}{{}}\n{good}").as_bytes());
    assert_eq!(status, Some(2));
    assert_eq!(output.lines().count(), 3);
}

/// Law: an answer can be read before the next question is asked.
#[test]
fn each_answer_is_written_at_once() {
    let mut child = Command::new(GROUNDTRUTH)
        .arg("probe")
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("it starts");
    let mut stdin = child.stdin.take().expect("piped");
    let mut stdout = BufReader::new(child.stdout.take().expect("piped"));
    for id in 0..3 {
        writeln!(stdin, r#"{{"id": {id}, "fresnel": {{"cos_i": 1, "eta": 1}}}}"#)
            .expect("it reads");
        let mut answer = String::new();
        stdout.read_line(&mut answer).expect("it answers");
        assert!(answer.starts_with(&format!(r#"{{"id":{id},"#)), "{answer}");
    }
    drop(stdin);
    assert!(child.wait().expect("it ends").success());
}
