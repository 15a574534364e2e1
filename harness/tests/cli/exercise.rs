//! `groundtruth exercise` makes pictures of wrong programs for a class, and the key for the teacher.

use std::fs;

use super::run_in;

/// The words of the first text between two others.
fn between<'a>(text: &'a str, before: &str, after: &str) -> &'a str {
    let (_, rest) = text.split_once(before).expect(before);
    rest.split_once(after).expect(after).0
}

/// Law: what the class gets does not name the mistake, the printed command makes the same files again, and the key's
/// first command finds the mistake. Oracle: the bytes of the files, and `verify`.
#[test]
fn a_class_gets_pictures_and_its_teacher_the_key() {
    let folder = tempfile::tempdir().expect("a folder");
    let options = ["--count", "2", "--seed", "5", "--level", "hard", "--width", "40"];
    let make =
        |to: &str| run_in(folder.path(), &[&["exercise", "ch14", "-o", to], &options[..]].concat());
    let made = make("ex");
    assert_eq!(made.status, Some(0), "{}", made.stderr);
    let key = fs::read_to_string(folder.path().join("ex/teacher/key.html")).expect("the key");
    let name = between(&key, "<h2>1: ", "</h2>");
    let words = between(&key, "</h2>\n<p>", "</p>");
    let files = ["sheet.html", "1.png", "2.png", "scenes/1.toml", "scenes/2.toml"];
    let class = folder.path().join("ex/class");
    assert_eq!(make("again").status, Some(0));
    for file in files {
        let bytes = fs::read(class.join(file)).expect(file);
        assert_eq!(fs::read(folder.path().join("again/class").join(file)).expect(file), bytes);
        let text = String::from_utf8_lossy(&bytes);
        assert!(!text.contains(name) && !text.contains(words), "{file} tells: {name}");
    }
    let judged = run_in(&class, &["verify", "scenes/1.toml", "1.png"]);
    assert_eq!(judged.status, Some(1), "{}", judged.stderr);
    assert!(judged.stdout.contains(words), "{words}\n{}", judged.stdout);
}

/// Law: a folder that holds something is not written to, and what is no chapter with mistakes is said. Oracle: the
/// folder's files.
#[test]
fn what_is_there_stays() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("mine.txt"), "mine").expect("a file");
    let refused = |chapter: &str, to: &str, why: &str| {
        let run = run_in(folder.path(), &["exercise", chapter, "-o", to, "--width", "16"]);
        assert_eq!(run.status, Some(2));
        assert!(run.stderr.contains(why), "{}", run.stderr);
    };
    refused("ch14", ".", "the folder is not empty");
    refused("ch14", "mine.txt", "mine.txt: ");
    refused("ch07", "new", "no known mistakes of chapter 7");
    refused("seven", "new", "a chapter is written as ch28");
    let names: Vec<_> = fs::read_dir(folder.path()).expect("a folder").collect();
    assert_eq!(names.len(), 1);
    assert_eq!(fs::read_to_string(folder.path().join("mine.txt")).expect("a file"), "mine");
}
