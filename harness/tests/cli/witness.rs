//! Other renderers on the command line: what cannot be said, and a program that is missing.

use std::path::Path;

use super::run_in;

/// Law: all that cannot be said is printed, a line each, with exit status 2, and no file is written;
/// without these terms it is. Oracle: figure 15.8 has four materials with highlights.
#[test]
fn an_export_that_cannot_be_said_lists_why() {
    let folder = tempfile::tempdir().expect("a folder");
    let arguments = ["export", "ch15/set", "--format", "pov", "-o", "scene.pov"];
    let run = run_in(folder.path(), &arguments);
    assert_eq!(run.status, Some(2), "{}", run.stderr);
    let highlights = run.stderr.lines().filter(|line| line.contains(": recipe.phong.ks: "));
    assert_eq!(highlights.count(), 4, "{}", run.stderr);
    assert!(!folder.path().join("scene.pov").exists());
    let run = run_in(folder.path(), &[&arguments[..], &["--without", "phong"]].concat());
    assert_eq!(run.status, Some(0), "{}", run.stderr);
    assert!(folder.path().join("scene.pov").exists());
}

/// Law: without the program the status is 2, and the message names what to write.
#[test]
fn a_missing_program_is_named() {
    let sphere = ["verify", "ch03/single-sphere", "--by", "pov", "--size", "8x8", "--program"];
    let missing = [&sphere[..], &["no/such/povray"]].concat();
    let run = run_in(Path::new("."), &missing);
    assert_eq!(run.status, Some(2), "{}", run.stderr);
    assert!(
        run.stderr.contains("--program no/such/povray: there is no such file"),
        "{}",
        run.stderr
    );
}

/// Law: a Python that has no Mitsuba is named, with what to install, and the status is 2. Oracle: `false` starts, and
/// imports nothing.
#[cfg(unix)]
#[test]
fn a_python_without_mitsuba_is_named() {
    let sphere = ["verify", "ch03/single-sphere", "--by", "mitsuba", "--size", "8x8", "--program"];
    let missing = [&sphere[..], &["/bin/false"]].concat();
    let run = run_in(Path::new("."), &missing);
    assert_eq!(run.status, Some(2), "{}", run.stderr);
    assert!(run.stderr.contains("pip install mitsuba"), "{}", run.stderr);
}

/// Law: the meshes of a scene become files beside the output, whose names begin with its own; without an
/// output it is refused. Oracle: the names.
#[test]
fn further_files_are_written_beside_the_output() {
    let folder = tempfile::tempdir().expect("a folder");
    let without = "ambient,smooth";
    let scene = ["export", "ch17/corner", "--format", "mitsuba", "--without", without];
    let run = run_in(folder.path(), &scene);
    assert_eq!(run.status, Some(2), "{}", run.stdout);
    assert!(run.stderr.contains("several files"), "{}", run.stderr);
    let run = run_in(folder.path(), &[&scene[..], &["-o", "ball.xml"]].concat());
    assert_eq!(run.status, Some(0), "{}", run.stderr);
    let text = std::fs::read_to_string(folder.path().join("ball.xml")).expect("written");
    assert!(text.contains("value=\"ball-0.ply\""), "{text}");
    assert!(folder.path().join("ball-0.ply").exists());
}

/// Law: the commands that explain a difference take as many samples as both sides did; a program is found by its
/// place from here. Oracle: a program that gives the picture of another scene for POV-Ray's.
#[cfg(unix)]
#[test]
fn explanations_take_the_samples_of_the_pictures() {
    use std::os::unix::fs::PermissionsExt;
    let folder = tempfile::tempdir().expect("a folder");
    let other = ["render", "ch03/three-objects", "--size", "8x8", "-o", "other.png"];
    assert_eq!(run_in(folder.path(), &other).status, Some(0));
    let script = format!(
        "#!/bin/sh\n[ \"$1\" = --version ] || cp '{}' scene.png\n",
        folder.path().join("other.png").display()
    );
    let program = folder.path().join("povray");
    std::fs::write(&program, script).expect("it is written");
    let mode = std::fs::Permissions::from_mode(0o755);
    std::fs::set_permissions(&program, mode).expect("it may be started");
    let sphere = ["verify", "ch03/single-sphere", "--by", "pov", "--size", "8x8", "--program"];
    let run = run_in(folder.path(), &[&sphere[..], &["povray"]].concat());
    assert_eq!(run.status, Some(1), "{}{}", run.stdout, run.stderr);
    let explain = "groundtruth explain ch03/single-sphere ";
    let commands: Vec<&str> = run.stdout.lines().filter(|line| line.contains(explain)).collect();
    assert!(!commands.is_empty(), "{}", run.stdout);
    for command in commands {
        assert!(command.ends_with(" --size 8x8 --samples 1"), "{command}");
    }
}

/// Law: a renderer that does not end is ended at the time limit, with status 2 and what it said last. Oracle: a script
/// that sleeps.
#[cfg(unix)]
#[test]
fn a_renderer_that_does_not_end_is_ended() {
    use std::os::unix::fs::PermissionsExt;
    let folder = tempfile::tempdir().expect("a folder");
    let script = folder.path().join("povray");
    std::fs::write(&script, "#!/bin/sh\necho tracing row 3 >&2\nexec sleep 100\n")
        .expect("written");
    let all = std::fs::Permissions::from_mode(0o755);
    std::fs::set_permissions(&script, all).expect("mine");
    let sphere = ["verify", "ch03/single-sphere", "--by", "pov", "--size", "8x8"];
    let limited = [&sphere[..], &["--program", "./povray", "--time-limit", "1"]].concat();
    let run = run_in(folder.path(), &limited);
    assert_eq!(run.status, Some(2), "{}", run.stderr);
    for said in ["tracing row 3", "--time-limit"] {
        assert!(run.stderr.contains(said), "{}", run.stderr);
    }
}
