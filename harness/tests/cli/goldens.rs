//! Which goldens are checked and shown.

use std::collections::BTreeSet;
use std::path::Path;

use super::run_in;

const FOLDER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../goldens");

/// The names that a check reports as the same.
fn checked(names: &[&str]) -> Vec<String> {
    let run = run_in(Path::new("."), &[&["goldens", "check", "--folder", FOLDER], names].concat());
    assert_eq!(run.status, Some(0), "{names:?}: {}{}", run.stdout, run.stderr);
    let lines = run.stdout.lines().filter_map(|line| line.strip_prefix("same "));
    lines.map(|line| line.trim().to_owned()).collect()
}

/// Law: a name means one golden, a chapter all of its goldens, each once. Oracle: the manifest.
#[test]
fn goldens_are_checked_by_name_and_by_chapter() {
    let manifest = std::fs::read_to_string(format!("{FOLDER}/manifest.toml")).expect("it is there");
    let of_chapter = manifest.matches("scene = \"ch03/").count();
    let found = checked(&["ch28/glass-sphere", "ch03", "ch03/single-sphere"]);
    assert_eq!(found.len(), of_chapter + 1, "{found:?}");
    assert!(found.contains(&"ch28/glass-sphere".to_owned()));
    assert!(found[..of_chapter].iter().all(|name| name.starts_with("ch03/")), "{found:?}");
}

/// Law: the parts of a check are disjoint and together are all, also if there are more parts than goldens; a part
/// that is none has status 2. Oracle: the whole list.
#[test]
fn the_parts_of_a_check_are_disjoint_and_together_all() {
    let all = checked(&["ch03"]);
    assert!(all.len() > 2, "{all:?}");
    for count in [1, 2, all.len() + 1] {
        let part = |k| checked(&["ch03", "--part", &format!("{k}/{count}")]);
        let mut found: Vec<String> = (0..count).flat_map(part).collect();
        found.sort();
        assert_eq!(found, all, "{count} parts");
    }
    for part in ["2/2", "0/0", "1"] {
        let arguments = ["goldens", "check", "ch03", "--folder", FOLDER, "--part", part];
        assert_eq!(run_in(Path::new("."), &arguments).status, Some(2), "{part}");
    }
}

/// Law: for an unknown name, similar names are suggested, and the status is 2.
#[test]
fn an_unknown_golden_gets_a_suggestion() {
    let run = run_in(Path::new("."), &["goldens", "check", "glass-sphere", "--folder", FOLDER]);
    assert_eq!(run.status, Some(2));
    assert!(run.stderr.contains("no golden `glass-sphere`"), "{}", run.stderr);
    assert!(run.stderr.contains("did you mean `ch28/glass-sphere`"), "{}", run.stderr);
}

/// Law: goldens of one's own scene files stand in a folder of one's own; the check asks for nothing of the gallery, and
/// each command that it prints acts on that folder. Oracle: the printed command, run by a shell.
#[test]
#[cfg(unix)]
fn goldens_of_ones_own_files_are_kept_in_a_folder_of_ones_own() {
    let here = tempfile::tempdir().expect("a folder");
    let run = |arguments: &[&str]| run_in(here.path(), arguments);
    let export = run(&["export", "ch03/three-objects"]).stdout;
    let scene = here.path().join("mine.toml");
    std::fs::write(&scene, &export).expect("written");
    let folder = ["--folder", "my goldens"];
    let accept = |names: &[&str]| {
        let start = &["goldens", "accept", "--size", "12x12", "--because", "seen"];
        run(&[&start[..], names, &folder].concat())
    };
    let accepted = accept(&["mine.toml", "mine.toml.normals", "ch03/single-sphere"]);
    assert_eq!(accepted.status, Some(0), "{}", accepted.stderr);
    assert!(accepted.stdout.ends_with("my goldens: 3 goldens\n"), "{}", accepted.stdout);
    let check = || run(&[&["goldens", "check"][..], &folder].concat());
    assert!(check().stdout.ends_with("checked 3, all the same\n"), "{}", check().stdout);
    // a sphere that is seen less of
    std::fs::write(&scene, export.replacen("radius = 80.0", "radius = 60.0", 1)).expect("written");
    let changed = check();
    assert_eq!(changed.status, Some(1), "{}", changed.stdout);
    let commands: Vec<&str> = changed
        .stdout
        .lines()
        .filter_map(|line| line.split_once("groundtruth "))
        .map(|it| it.1)
        .collect();
    assert_eq!(commands.len(), 3, "{}", changed.stdout);
    let page = run(&["goldens", "review", "-o", "-", folder[0], folder[1]]).stdout;
    let escaped =
        "groundtruth goldens accept mine.toml --because &quot;…&quot; --folder 'my goldens'";
    assert!(page.contains(escaped) || page.contains(&escaped.replace('\'', "&#39;")), "{page}");
    assert!(page.contains("groundtruth explain mine.toml --size 12x12"), "{page}");
    for command in commands {
        let line = format!("'{}' {}", super::GROUNDTRUTH, command);
        let mut shell = std::process::Command::new("sh");
        let done = shell.args(["-c", &line]).current_dir(here.path()).output().expect("a shell");
        assert!(done.status.success(), "{line}: {}", String::from_utf8_lossy(&done.stderr));
    }
    assert!(check().stdout.ends_with("checked 3, all the same\n"), "{}", check().stdout);
    // another file of the same name
    std::fs::create_dir(here.path().join("other")).expect("made");
    std::fs::write(here.path().join("other/mine.toml"), export).expect("written");
    let refused = accept(&["other/mine.toml"]);
    assert_eq!(refused.status, Some(2));
    assert!(
        refused.stderr.contains("golden `mine.toml` is of the file mine.toml"),
        "{}",
        refused.stderr
    );
}

/// Law: a review of a chapter shows each of its goldens.
#[test]
fn a_review_of_a_chapter_shows_its_goldens() {
    let folder = tempfile::tempdir().expect("a folder");
    let run = run_in(folder.path(), &["goldens", "review", "ch03", "--folder", FOLDER]);
    let count = checked(&["ch03"]).len();
    let lines: Vec<&str> = run.stdout.lines().collect();
    let verdict = format!("same: none of {count} goldens differs");
    assert_eq!(lines[..2], [&*verdict, &*format!("review.html: shows {count}")], "{lines:?}");
}

/// Law: the parts of the controls cover each golden once, together see what the whole sees, and have status 0. Oracle: the
/// controls of the chapter.
#[test]
fn controls_of_parts_are_those_of_the_whole() {
    let controls = |more: &[&str]| {
        let start = ["goldens", "check", "ch03", "--controls", "--folder", FOLDER];
        let run = run_in(Path::new("."), &[&start, more].concat());
        assert_eq!(run.status, Some(0), "{more:?}: {}", run.stderr);
        let goldens = run.stdout.split(' ').next().and_then(|count| count.parse::<usize>().ok());
        let of = |word: &str| -> BTreeSet<String> {
            let lines = run.stdout.lines().filter_map(|line| line.strip_prefix(word));
            lines.map(|line| line.trim().split(':').next().expect("a field").to_owned()).collect()
        };
        (goldens.expect("a count"), of("seen "), of("unseen "))
    };
    let whole = controls(&[]);
    let parts = ["0/3", "1/3", "2/3"].map(|part| controls(&["--part", part]));
    assert_eq!(parts.iter().map(|part| part.0).sum::<usize>(), whole.0, "goldens of all parts");
    let seen: BTreeSet<String> = parts.iter().flat_map(|part| part.1.clone()).collect();
    let unseen: BTreeSet<String> = parts.iter().flat_map(|part| part.2.clone()).collect();
    assert_eq!(seen, whole.1, "fields that some part sees");
    assert_eq!(&unseen - &seen, whole.2, "fields that no part sees");
    for field in ["shape sphere.radius", "shape plane.normal", "camera.eye"] {
        assert!(whole.1.contains(field), "{field} is not among {:?}", whole.1);
    }
    assert!(whole.2.contains("scene.about"), "scene.about is not among {:?}", whole.2);
}
