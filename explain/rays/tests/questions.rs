use std::path::{Path, PathBuf};

use super::writers::{shell, traced};
use rays::RayVerdict;
use serde::Deserialize;

#[derive(Deserialize)]
struct Questions {
    question: Vec<Question>,
}

#[derive(Deserialize)]
struct Question {
    asked: String,
    program: String,
    edits: Vec<[String; 2]>,
    says: String,
}

/// How a program is built and run that writes `rays.jsonl`.
fn command(extension: &str) -> &'static str {
    match extension {
        "c" => "cc -O1 -w -std=c99 edited.c -o edited -lm && LOG=rays.jsonl ./edited > picture",
        "cpp" => {
            "c++ -O1 -w -std=c++17 edited.cpp -o edited -pthread && LOG=rays.jsonl ./edited > picture"
        }
        _ => "rustc -O -A warnings --edition 2021 edited.rs && ./edited > picture",
    }
}

/// The log of a program with edits.
fn log_of(question: &Question, folder: &Path) -> PathBuf {
    let root = PathBuf::from(env!("CARGO_MANIFEST_DIR"));
    let program = root.join("../../examples/rays").join(&question.program);
    let mut text = std::fs::read_to_string(&program).expect("a program");
    for [find, replace] in &question.edits {
        assert_eq!(text.matches(find).count(), 1, "{}: {find}", question.program);
        text = text.replace(find, replace);
    }
    for entry in std::fs::read_dir(root.join("writers")).expect("files").flatten() {
        std::fs::copy(entry.path(), folder.join(entry.file_name())).expect("a copy");
    }
    let extension = program.extension().expect("a name").to_string_lossy().into_owned();
    std::fs::write(folder.join(format!("edited.{extension}")), text).expect("a file");
    assert!(shell(folder, command(&extension)), "{}", question.program);
    folder.join("rays.jsonl")
}

/// Law: what people ask about is said in the first sentence, for at least nine of ten questions. Oracle: questions with their
/// answers (`questions.toml`).
#[test]
fn the_first_sentence_answers() {
    let questions: Questions = toml::from_str(include_str!("questions.toml")).expect("questions");
    let mut missed = Vec::new();
    for question in &questions.question {
        let folder = tempfile::tempdir().expect("a folder");
        let traced = traced(&log_of(question, folder.path()));
        let sentence = RayVerdict::of(traced).sentence();
        if !sentence.contains(&question.says) {
            missed.push(format!("{} {sentence}", question.asked));
        }
    }
    assert_eq!(questions.question.len(), 10);
    assert!(missed.len() <= 1, "{}", missed.join("\n"));
}
