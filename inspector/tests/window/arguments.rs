//! The command line, as far as it needs no window.

use std::process::{Command, Output};

fn inspector(arguments: &[&str]) -> Output {
    let program = env!("CARGO_BIN_EXE_inspector");
    Command::new(program).args(arguments).output().expect("the program starts")
}

/// Law: a scene that cannot be opened is told on standard error, in the library's words, with
/// status 2 and without a window.
#[test]
fn a_bad_scene_is_told_before_there_is_a_window() {
    let missing = "no-such-folder/scene.toml";
    let error = groundtruth::scene::read(missing.as_ref()).expect_err("it is not there");
    for (name, expected) in [
        (missing, error.to_string()),
        ("ch99/nothing", "no scene `ch99/nothing`: neither a gallery name nor a file".to_owned()),
    ] {
        let output = inspector(&[name]);
        assert_eq!(output.status.code(), Some(2));
        assert_eq!(String::from_utf8_lossy(&output.stderr), format!("error: {expected}\n"));
    }
}

/// Law: `--help` says what the argument is, and a pixel that is none is refused.
#[test]
fn help_is_given_and_arguments_are_checked() {
    let help = inspector(&["--help"]);
    assert!(help.status.success());
    assert!(String::from_utf8_lossy(&help.stdout).contains("ch28/glass-sphere"));
    let output = inspector(&["--pixel", "left"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&output.stderr).contains("written as 200,150"));
}
