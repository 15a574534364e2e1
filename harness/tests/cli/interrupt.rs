//! Interrupting a picture.

use std::io::{BufRead, BufReader};
use std::process::{Command, Stdio};
use std::time::Duration;

use super::{GROUNDTRUTH, files_in};

/// Law: an interrupted rendering ends soon with status 130, says so, and leaves no file.
#[test]
fn an_interrupted_picture_leaves_no_file() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut child = Command::new(GROUNDTRUTH)
        .current_dir(folder.path())
        .args(["render", "ch28/glass-sphere", "--size", "4000x4000", "-o", "a.png"])
        .stderr(Stdio::piped())
        .spawn()
        .expect("it starts");
    let mut stderr = BufReader::new(child.stderr.take().expect("piped")).lines();
    let first = stderr.next().expect("a line").expect("text");
    assert_eq!(first, "note: this will take about 2e9 rays");
    // the note comes just before the handler of the signal
    std::thread::sleep(Duration::from_millis(500));
    let kill = Command::new("kill").args(["-INT", &child.id().to_string()]).status();
    assert!(kill.expect("kill starts").success());
    let rest: Vec<String> = stderr.map(|line| line.expect("text")).collect();
    assert_eq!(rest.last().map(String::as_str), Some("interrupted; nothing was written"));
    assert_eq!(child.wait().expect("it ends").code(), Some(130));
    assert_eq!(files_in(folder.path()), [""; 0]);
}
