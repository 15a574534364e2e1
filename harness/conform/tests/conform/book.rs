//! The book's formulas as they are printed (`examples/conform/book`): what fails is what docs/book-card.md says.

use ask::{Limits, Program, Subject};
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Duration;

use conform::family::Judge;
use conform::{Judgement, Options, Profile, run, suite};
use serde_json::Value;

use super::altered::{families, options};

/// Cases of a family: enough for those that fail by the book, and soon asked.
const CASES: usize = 8;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// The program; `None` without Python, and says so.
fn program() -> Option<Program> {
    if Command::new("python3").arg("--version").output().is_err() {
        println!("skipped: there is no python3");
        return None;
    }
    let file = root().join("examples/conform/book/book.py").to_string_lossy().into_owned();
    let limits = Limits { answer: Duration::from_secs(20), start: Duration::from_secs(60) };
    Some(Program::new(vec!["python3".to_owned(), file], limits, <_>::default()))
}

/// A family that fails, as the document shows it.
struct Shown {
    family: String,
    by_the_book: bool,
    question: Value,
    answer: Value,
    right: String,
}

/// What stands in the document as
/// ```text
/// family: 3 of 48 wrong
/// → question
/// ← answer
/// = what is right
/// ```
fn shown() -> Vec<Shown> {
    let document = fs::read_to_string(root().join("docs/book-card.md")).expect("the document");
    let lines: Vec<&str> = document.lines().collect();
    let json = |text: &str| serde_json::from_str(text).unwrap_or_else(|e| panic!("{text}: {e}"));
    let entry = |lines: &[&str]| {
        let question = lines[1].strip_prefix("→ ")?;
        let answer = lines[2].strip_prefix("← ").expect("an answer under its question");
        let right = lines[3].strip_prefix("= ").expect("what is right under the answer");
        let (family, counts) = lines[0].split_once(": ").expect("a family and counts");
        Some(Shown {
            family: family.to_owned(),
            by_the_book: counts.ends_with("in both profiles"),
            question: json(question),
            answer: json(answer),
            right: right.to_owned(),
        })
    };
    let all: Vec<Shown> = lines.windows(4).filter_map(entry).collect();
    assert!(!all.is_empty(), "the document shows no question");
    all
}

fn names<'a>(all: impl IntoIterator<Item = &'a Shown>) -> BTreeSet<String> {
    all.into_iter().map(|shown| shown.family.clone()).collect()
}

/// Whether answers are the same but for the last digits of sines and cosines, which are another platform's own.
fn is_like(a: &Value, b: &Value) -> bool {
    const LAST_DIGITS: f64 = 1e-6;
    match (a, b) {
        (Value::Object(a), Value::Object(b)) => {
            a.len() == b.len() && a.iter().all(|(key, a)| b.get(key).is_some_and(|b| is_like(a, b)))
        }
        (Value::Array(a), Value::Array(b)) => {
            a.len() == b.len() && a.iter().zip(b).all(|(a, b)| is_like(a, b))
        }
        (Value::Number(a), Value::Number(b)) => {
            let [a, b] = [a, b].map(|x| x.as_f64().unwrap_or(f64::NAN));
            (a - b).abs() <= LAST_DIGITS * b.abs().max(1.0)
        }
        (a, b) => a == b,
    }
}

/// What fails of the first cases of the document's seed, so that what it found in more cases is all of it.
fn failed(program: &mut Program, profile: Profile) -> BTreeSet<String> {
    let options = Options { profile, seed: 1, ..options(CASES) };
    let card = run(program, &suite::all(), &options, &mut |_| ()).expect("it answers");
    card.rows.iter().filter(|row| row.is_failed()).map(|row| row.name.clone()).collect()
}

/// Law: in the profile `book`, those families fail that the document names, and no other. Oracle: the judges.
#[test]
fn by_the_book_what_fails_is_what_the_document_says() {
    let Some(mut program) = program() else { return };
    let all = shown();
    let expected = names(all.iter().filter(|shown| shown.by_the_book));
    assert_eq!(failed(&mut program, Profile::Book), expected);
}

/// Law: in the profile `careful`, no family fails that the document does not name. Oracle: the judges. (That those it
/// names fail, says the next law.)
#[test]
fn with_care_nothing_fails_that_the_document_does_not_say() {
    let Some(mut program) = program() else { return };
    let unknown = &failed(&mut program, Profile::Careful) - &names(&shown());
    assert!(unknown.is_empty(), "{unknown:?} fail, but are not in docs/book-card.md");
}

/// Law: each question of the document is answered as it says, the answer is wrong, and it says what is right. Oracle:
/// the judges.
#[test]
fn each_question_of_the_document_is_answered_wrongly() {
    let Some(mut program) = program() else { return };
    let all = shown();
    let questions: Vec<Value> = all.iter().map(|shown| shown.question.clone()).collect();
    for (shown, reply) in all.iter().zip(program.ask(&questions)) {
        let Shown { family, question, answer, right, .. } = shown;
        let Ok(theirs) = reply else { panic!("{family}: {question}: {reply:?}") };
        assert!(is_like(&theirs, answer), "{family}: {question}: {theirs}, not {answer}");
        let of_name = families(&[family]);
        let Judge::Answer(judge, rules) = of_name[0].judge else {
            panic!("{family} is judged by a law")
        };
        for profile in Profile::ALL {
            let is_asked = profile == Profile::Careful || shown.by_the_book;
            for answer in [answer, &theirs] {
                match judge(question, answer, profile, rules) {
                    Judgement::Wrong(wrong) => assert_eq!(&wrong.expected, right, "{family}"),
                    other => assert!(!is_asked, "{family}: {question}: {other:?}"),
                }
            }
        }
    }
}

/// Law: the files of known failures are the families that the document names. Oracle: the document.
#[test]
fn known_failures_are_those_of_the_document() {
    let known = |file: &str| -> BTreeSet<String> {
        let text = fs::read_to_string(root().join("examples/conform/book").join(file));
        let text = text.unwrap_or_else(|e| panic!("{file}: {e}"));
        text.lines().filter(|line| !line.starts_with('#')).map(str::to_owned).collect()
    };
    let all = shown();
    assert_eq!(known("careful.known"), names(&all));
    assert_eq!(known("book.known"), names(all.iter().filter(|shown| shown.by_the_book)));
}
