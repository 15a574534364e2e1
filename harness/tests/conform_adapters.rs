//! The adapters of `examples/conform`: the right ones pass, of the wrong one each mistake is found, and the document
//! shows what is printed. Where a language is missing, its tests say so and pass.

use ask::{Language, Limits, Program, Reply, Stop, Subject};
use std::collections::BTreeSet;
use std::time::Duration;

use conform::probe::QUESTIONS;
use conform::{Card, Options, Profile, Status, run, suite};
use serde_json::Value;

use crate::kit::{Folder, has, root, text_of};

// a Rust adapter is compiled with this test, and asked without a process
#[allow(dead_code, clippy::disallowed_methods)]
#[path = "../../examples/conform/adapter.rs"]
mod adapter;
mod document;
#[allow(dead_code)]
#[path = "../../examples/conform/init.rs"]
mod init;
mod programs;
mod wrong;

/// What the adapters answer.
const ANSWERED: [&str; 6] = [
    "shapes/sphere",
    "shapes/plane",
    "shapes/triangle",
    "lobes/lambertian",
    "optics/fresnel",
    "cameras/pinhole",
];

/// A Rust adapter: from a line to a line.
pub struct Called(pub fn(&str) -> String);

impl Subject for Called {
    fn ask(&mut self, questions: &[Value]) -> Vec<Reply> {
        let reply = |question: &Value| {
            let mut line = question.clone();
            line["id"] = 7.into();
            let reply: Value = serde_json::from_str(&self.0(&line.to_string())).expect("JSON");
            assert_eq!(reply["id"], 7);
            match (reply.get("answer"), reply.get("unsupported")) {
                (Some(answer), _) => Ok(answer.clone()),
                (_, Some(why)) => Err(Stop::Unsupported(why.to_string())),
                _ => Err(Stop::Refused(reply["error"].to_string())),
            }
        };
        questions.iter().map(reply).collect()
    }
}

fn example(name: &str) -> String {
    root().join("examples/conform").join(name).to_string_lossy().into_owned()
}

fn text_of_example(name: &str) -> String {
    text_of(&format!("examples/conform/{name}"))
}

fn program(command: &[&str]) -> Program {
    let limits = Limits { answer: Duration::from_secs(20), start: Duration::from_secs(60) };
    Program::new(command.iter().map(|&word| word.to_owned()).collect(), limits, <_>::default())
}

/// The card of the families that one of the words selects; of all, if there are none.
fn card(subject: &mut dyn Subject, words: &[&str], cases: usize) -> Card {
    let mut families = suite::all();
    families
        .retain(|family| words.is_empty() || words.iter().any(|word| family.is_selected_by(word)));
    let interrupted = <_>::default();
    let options = Options { profile: Profile::Careful, seed: 1, cases, shrink: true, interrupted };
    run(subject, &families, &options, &mut |_| ()).expect("it answers")
}

const FLAGS: &str = "-std=c++17 -Wall -Wextra -Werror";

/// An executable made of a C++ file; `None` without a compiler.
fn compiled(file: &str, folder: &Folder) -> Option<String> {
    has("g++").then(|| {
        folder.good(&format!("g++ {FLAGS} -Wpedantic -o adapter $ROOT/examples/conform/{file}"));
        folder.path().join("adapter").to_string_lossy().into_owned()
    })
}

fn assert_all_right(subject: &mut dyn Subject) {
    let card = card(subject, &ANSWERED, 6);
    assert!(!card.is_failed(), "{card}");
    assert_eq!(card.count(Status::Unsupported), 0, "{card}");
    assert!(card.count(Status::Pass) > 200, "{card}");
    let whole = self::card(subject, &[], 1);
    assert!(!whole.is_failed(), "{whole}");
}

/// Law: all answers are right. Oracle: the judges.
#[test]
fn the_adapter_in_rust_is_right() {
    assert_all_right(&mut Called(adapter::reply));
}

/// Law: all answers are right. Oracle: the judges.
#[test]
fn the_adapter_in_cpp_is_right() {
    let folder = Folder::new();
    if let Some(executable) = compiled("adapter.cpp", &folder) {
        assert_all_right(&mut program(&[&executable]));
    }
}

/// Law: all answers are right, and the exit status says so; what is not answered is unsupported. Oracle: the judges.
#[test]
fn the_adapter_in_python_is_right() {
    if has("python3") {
        let adapter = example("adapter.py");
        assert_all_right(&mut program(&["python3", &adapter]));
        Folder::new().good(&format!("groundtruth conform --cases 1 -- python3 {adapter}"));
    }
}

fn assert_all_unsupported(subject: &mut dyn Subject) {
    let card = card(subject, &[], 1);
    let asked: u64 = card.rows.iter().map(|row| row.total()).sum();
    assert_eq!(card.count(Status::Unsupported), asked, "{card}");
    let questions = card.rows.iter().filter(|row| row.total() > 0);
    let names: BTreeSet<&str> = questions.filter_map(|row| row.name.split('.').next()).collect();
    // the message is the question's name
    for row in &card.rows {
        for (_, text, question) in &row.messages {
            assert!(question.get(text.trim_matches('"')).is_some(), "{text}: {question}");
        }
    }
    assert_eq!(names, QUESTIONS.iter().copied().collect(), "all are asked");
}

/// Law: what `--init` prints is the file, runs, and says to every question of the probe that it is unsupported. Oracle: counts,
/// and the names of the questions.
#[test]
fn an_adapter_to_fill_in_runs_and_supports_nothing() {
    for (name, language, file) in [
        ("python", Language::Python, "init.py"),
        ("cpp", Language::Cpp, "init.cpp"),
        ("rust", Language::Rust, "init.rs"),
        ("java", Language::Java, "init.java"),
    ] {
        let printed = Folder::new().good(&format!("groundtruth conform --init {name}"));
        assert_eq!(printed, text_of_example(file));
        assert_eq!(language.adapter(), text_of_example(file));
    }
    assert_all_unsupported(&mut Called(init::reply));
    if has("python3") {
        assert_all_unsupported(&mut program(&["python3", &example("init.py")]));
    }
    let folder = Folder::new();
    if let Some(executable) = compiled("init.cpp", &folder) {
        assert_all_unsupported(&mut program(&[&executable]));
    }
    if has("javac") && has("java") {
        let flags = "-encoding UTF-8 --release 11 -Xlint:all,-options -Werror";
        folder.good(&format!(
            "cp $ROOT/examples/conform/init.java MyTracer.java; javac {flags} MyTracer.java"
        ));
        let classes = folder.path().to_string_lossy();
        assert_all_unsupported(&mut program(&["java", "-cp", &classes, "MyTracer"]));
    }
}
