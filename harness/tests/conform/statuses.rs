//! The command line of `conform`: exit statuses, files, errors.

use std::path::Path;
use std::process::{Command, Output};

use conform::{Profile, Reply, Status, Stop, Subject, ours};
use serde_json::Value;

use super::altered::{card_with, each};

const GROUNDTRUTH: &str = env!("CARGO_BIN_EXE_groundtruth");

fn run(arguments: &[&str]) -> Output {
    Command::new(GROUNDTRUTH).arg("conform").args(arguments).output().expect("it starts")
}

fn errors(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

/// A program that says every sphere is missed.
const BLIND: [&str; 4] =
    ["--", "sh", "-c", "$0 probe | sed -u 's/\"answer\":.*/\"answer\":null}/'"];

fn blind(arguments: &[&str]) -> Output {
    let all: Vec<&str> = ["intersect.sphere.ordinary", "--cases", "8"]
        .iter()
        .chain(arguments)
        .chain(&BLIND)
        .copied()
        .collect();
    run(&[&all[..], &[GROUNDTRUTH]].concat())
}

fn read(path: &Path) -> String {
    std::fs::read_to_string(path).expect("it was written")
}

#[test]
fn words_that_select_nothing_are_refused_with_a_hint() {
    let output = run(&["shapes/tours", "--", "true"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(errors(&output).contains("did you mean `shapes/torus`?"), "{}", errors(&output));
    let output = run(&["ch03", "--only", "lobe.*", "--", "true"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(errors(&output).contains("no family matches --only"), "{}", errors(&output));
    let output = run(&["ch03"]);
    assert_eq!(output.status.code(), Some(2), "a program is needed");
}

#[test]
fn the_card_is_a_page_and_a_report_for_continuous_integration() {
    let folder = tempfile::tempdir().expect("a folder");
    let [page, junit] = ["card.html", "junit.xml"].map(|name| folder.path().join(name));
    let [shown_page, shown_junit] = [&page, &junit].map(|path| path.to_str().expect("text"));
    let output = blind(&["-o", shown_page, "--junit", shown_junit]);
    assert_eq!(output.status.code(), Some(1), "{}", errors(&output));
    let card = String::from_utf8_lossy(&output.stdout);
    for text in ["ch03", "intersect.sphere.ordinary:", "expected  t = ", "1 of 1 families failed"] {
        assert!(card.contains(text), "{text} is not in {card}");
    }
    let page = read(&page);
    assert!(page.contains("intersect.sphere.ordinary") && page.contains("groundtruth probe"));
    let junit = read(&junit);
    assert!(junit.contains(
        "<testsuite name=\"ch03\" tests=\"1\" skipped=\"0\" errors=\"0\" failures=\"1\""
    ));
    assert!(junit.contains("<testcase name=\"intersect.sphere.ordinary\""), "{junit}");
}

/// Law: a known failure is no failure, and a known failure that passes is one. Oracle: a program that is wrong, and our
/// probe.
#[test]
fn known_failures_are_known_and_must_fail() {
    let folder = tempfile::tempdir().expect("a folder");
    let known = folder.path().join("known");
    let shown = known.to_str().expect("text");
    assert_eq!(blind(&["--write-known", shown]).status.code(), Some(1));
    assert_eq!(read(&known), "intersect.sphere.ordinary\n");
    assert_eq!(blind(&["--known", shown]).status.code(), Some(0));
    let ours =
        ["intersect.sphere.ordinary", "--cases", "8", "--known", shown, "--", GROUNDTRUTH, "probe"];
    let output = run(&ours);
    assert_eq!(output.status.code(), Some(1));
    assert!(errors(&output).contains("known to fail, but does not"), "{}", errors(&output));
    std::fs::write(&known, "# ours\nintersect.spere.ordinary\n").expect("written");
    let output = run(&ours);
    assert_eq!(output.status.code(), Some(2));
    assert!(
        errors(&output).contains("known:2: no family `intersect.spere.ordinary`"),
        "{}",
        errors(&output)
    );
}

#[test]
fn a_fresh_seed_is_printed_and_another_each_time() {
    let seed = || {
        let output = run(&[
            "fresnel.cosine",
            "--fresh",
            "--json",
            "--cases",
            "4",
            "--",
            GROUNDTRUTH,
            "probe",
        ]);
        let card: Value = serde_json::from_slice(&output.stdout).expect("JSON");
        card["seed"].as_u64().expect("a seed")
    };
    assert_ne!(seed(), seed());
}

/// Law: a run that is interrupted, or ended as `timeout` does, prints what it has, with status 130. Oracle: a signal to
/// a slow program's judge.
#[test]
fn an_interrupted_run_prints_what_it_has() {
    std::thread::scope(|scope| {
        for signal in ["-INT", "-TERM"] {
            scope.spawn(move || prints_what_it_has(signal));
        }
    });
}

fn prints_what_it_has(signal: &str) {
    let mut run = Command::new(GROUNDTRUTH)
        .args([
            "conform",
            "ch19",
            "--json",
            "--",
            "sh",
            "-c",
            "$0 probe | while read -r l; do sleep 0.01; echo \"$l\"; done",
        ])
        .arg(GROUNDTRUTH)
        .stdout(std::process::Stdio::piped())
        .spawn()
        .expect("it starts");
    std::thread::sleep(std::time::Duration::from_millis(1500));
    let kill = Command::new("kill").args([signal, &run.id().to_string()]).status().expect("kill");
    assert!(kill.success());
    let mut text = String::new();
    std::io::Read::read_to_string(&mut run.stdout.take().expect("piped"), &mut text).expect("text");
    assert_eq!(run.wait().expect("it ends").code(), Some(130));
    let card: Value = serde_json::from_str(&text).expect("JSON");
    assert_eq!(card["complete"], Value::Bool(false));
}

#[test]
fn each_language_has_an_adapter_to_start_from() {
    for (language, has) in
        [("python", "import json"), ("cpp", "int main"), ("rust", "fn main"), ("java", "void main")]
    {
        let output = run(&["--init", language]);
        assert_eq!(output.status.code(), Some(0), "{}", errors(&output));
        assert!(String::from_utf8_lossy(&output.stdout).contains(has), "{language}");
    }
}

/// A program that looks through middles of pixels alone, and whose cameras look backwards.
struct MiddlesOnly;

impl Subject for MiddlesOnly {
    fn ask(&mut self, questions: &[Value]) -> Vec<Reply> {
        let reply = |question: &Value| {
            if !question["camera_ray"]["place"].is_null() {
                return Err(Stop::Unsupported("place".to_owned()));
            }
            let mut answer = ours(question).expect("an answer");
            each(&mut answer["direction"], |x| -x);
            Ok(answer)
        };
        questions.iter().map(reply).collect()
    }
}

/// Law: a program that lacks a field of many cases is judged by the others, even if it lacks the first two. Oracle: its
/// mistake.
#[test]
fn a_family_is_not_given_up_for_its_first_two_cases() {
    let card = card_with(&mut MiddlesOnly, &["camera_ray.pinhole.values"], Profile::Book, 2, false);
    assert!(card.rows[0].is_unsupported(), "the first two cases have a place: {card}");
    let card =
        card_with(&mut MiddlesOnly, &["camera_ray.pinhole.values"], Profile::Book, 48, false);
    assert!(card.count(Status::Wrong) > 10, "{card}");
}

/// Law: whatever a program answers, the card for continuous integration is a document of XML 1.0. Oracle: the production
/// `Char` of the specification, and a program that answers characters outside it.
#[test]
fn a_card_holds_no_character_that_xml_does_not() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("card \u{ffff}.xml");
    let answer = r#"s/"answer":.*/"answer":"\xef\xbf\xbe\\u0001\\ufffe \&<]]>"}/"#;
    let program = format!("$0 probe | sed -u '{answer}'");
    let asked = ["conform", "intersect.sphere.ordinary", "--cases", "8", "--junit"];
    let mut command = Command::new(GROUNDTRUTH);
    command.args(asked).arg(&file).args(["--", "sh", "-c", &program, GROUNDTRUTH, "\u{fffe}"]);
    assert_eq!(command.output().expect("it starts").status.code(), Some(1));
    let card = read(&file);
    let is_held = |c: char| matches!(u32::from(c), 9 | 10 | 13 | 0x20..=0xd7ff | 0xe000..=0xfffd | 0x1_0000..);
    assert!(card.contains("fffe") && card.chars().all(is_held), "{card}");
}
