//! The example in Python of docs/probe.md, for those who installed the command as the README says.

use std::path::Path;
use std::process::{Command, Output};

const GROUNDTRUTH: &str = env!("CARGO_BIN_EXE_groundtruth");

/// The example, run where the command is on the path; `None` without Python.
fn run(program: &str) -> Option<Output> {
    let folder = Path::new(GROUNDTRUTH).parent().expect("it is in a folder");
    let old = std::env::var_os("PATH").unwrap_or_default();
    let path =
        std::env::join_paths(std::iter::once(folder.to_owned()).chain(std::env::split_paths(&old)));
    let mut command = Command::new("python3");
    command.env("PATH", path.expect("no folder has a separator in it"));
    command.args(["-c", program]).output().ok()
}

/// Law: the example runs as it stands, and finds nothing; with a sphere that is a little too large it finds rays.
/// Oracle: what it prints.
#[test]
fn the_example_in_python_compares_spheres() {
    let document = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/probe.md");
    let document = std::fs::read_to_string(document).expect("it is there");
    let (_, rest) = document.split_once("```python\n").expect("an example in Python");
    let (program, _) = rest.split_once("```").expect("its end");
    let Some(output) = run(program) else { return };
    let (stdout, stderr) =
        (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    assert!(output.status.success(), "{stderr}");
    assert_eq!(stdout.trim_end(), "1000 rays compared");
    let wrong = program.replace("- r * r", "- 1.001 * r * r");
    assert_ne!(wrong, program);
    let output = run(&wrong).expect("Python is there");
    let lines = String::from_utf8_lossy(&output.stdout).lines().count();
    assert!(lines > 100, "only {lines} lines");
}

/// Law: the README says where the command is that its builds leave. Oracle: the program that is tested.
#[test]
fn the_readme_says_where_the_command_is() {
    let root = concat!(env!("CARGO_MANIFEST_DIR"), "/..");
    let readme = std::fs::read_to_string(format!("{root}/README.md")).expect("it is there");
    let (_, rest) = readme.split_once("the command in `").expect("a sentence");
    let said = Path::new(rest.split('`').next().expect("a path"));
    let tested = Path::new(env!("CARGO_BIN_EXE_groundtruth"));
    assert_eq!(said.file_stem(), tested.file_stem());
    assert_eq!(said.parent(), Some(Path::new("target/debug")));
}
