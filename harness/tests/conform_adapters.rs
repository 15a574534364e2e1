//! The adapters of `examples/conform`: the right ones pass, of the wrong one each mistake is found, and the document
//! shows what is printed. Where a language is missing, its tests say so and pass.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::time::Duration;
use std::{env, fs};

use conform::{
    Card, Language, Limits, Options, Profile, Program, Reply, Status, Subject, run, suite,
};
use serde_json::Value;

// a Rust adapter is compiled with this test, and asked without a process
#[allow(dead_code, clippy::disallowed_methods)]
#[path = "../../examples/conform/adapter.rs"]
mod adapter;
#[allow(dead_code)]
#[path = "../../examples/conform/init.rs"]
mod init;
mod programs;

/// What the adapters answer.
const ANSWERED: [&str; 6] = [
    "shapes/sphere",
    "shapes/plane",
    "shapes/triangle",
    "lobes/lambertian",
    "optics",
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
                (Some(answer), _) => Reply::Answer(answer.clone()),
                (_, Some(why)) => Reply::Unsupported(why.to_string()),
                _ => Reply::Refused(reply["error"].to_string()),
            }
        };
        questions.iter().map(reply).collect()
    }
}

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

fn example(name: &str) -> String {
    root().join("examples/conform").join(name).to_string_lossy().into_owned()
}

fn text_of(path: impl AsRef<Path>) -> String {
    fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.as_ref().display()))
}

/// Whether a language is there; says so if not.
fn has(program: &str) -> bool {
    let is_there = Command::new(program).arg("--version").output().is_ok();
    if !is_there {
        println!("skipped: there is no {program}");
    }
    is_there
}

fn groundtruth(folder: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_groundtruth"));
    command.args(arguments).current_dir(folder).output().expect("the program runs")
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

/// An executable made of a C++ file; `None` without a compiler.
fn compiled(file: &str, folder: &Path) -> Option<String> {
    if !has("g++") {
        return None;
    }
    let executable = folder.join("adapter").to_string_lossy().into_owned();
    let flags = ["-std=c++17", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-o", &executable];
    let output = Command::new("g++").args(flags).arg(example(file)).output().expect("it runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    Some(executable)
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
    let folder = tempfile::tempdir().expect("a folder");
    if let Some(executable) = compiled("adapter.cpp", folder.path()) {
        assert_all_right(&mut program(&[&executable]));
    }
}

/// Law: all answers are right, and the exit status says so; what is not answered is unsupported. Oracle: the judges.
#[test]
fn the_adapter_in_python_is_right() {
    if has("python3") {
        let adapter = example("adapter.py");
        assert_all_right(&mut program(&["python3", &adapter]));
        let output = groundtruth(&root(), &["conform", "--cases", "1", "--", "python3", &adapter]);
        assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stdout));
    }
}

fn assert_all_unsupported(subject: &mut dyn Subject) {
    let card = card(subject, &[], 1);
    let asked: u64 = card.rows.iter().map(|row| row.total()).sum();
    assert_eq!(card.count(Status::Unsupported), asked, "{card}");
    let questions = card.rows.iter().filter(|row| row.total() > 0);
    let mut names: Vec<&str> = questions.filter_map(|row| row.name.split('.').next()).collect();
    names.sort_unstable();
    names.dedup();
    // the message is the function's name: none is left to "no such question"
    for row in &card.rows {
        for (_, text, question) in &row.messages {
            assert!(question.get(text.trim_matches('"')).is_some(), "{text}: {question}");
        }
    }
    assert_eq!(names.len(), 16, "{names:?}");
}

/// Law: what `--init` prints is the file, runs, and says to every question that it is unsupported. Oracle: counts.
#[test]
fn an_adapter_to_fill_in_runs_and_supports_nothing() {
    for (name, language, file) in [
        ("python", Language::Python, "init.py"),
        ("cpp", Language::Cpp, "init.cpp"),
        ("rust", Language::Rust, "init.rs"),
        ("java", Language::Java, "init.java"),
    ] {
        let output = groundtruth(&root(), &["conform", "--init", name]);
        assert_eq!(output.status.code(), Some(0));
        assert_eq!(String::from_utf8_lossy(&output.stdout), text_of(example(file)));
        assert_eq!(language.template(), text_of(example(file)));
    }
    assert_all_unsupported(&mut Called(init::reply));
    if has("python3") {
        assert_all_unsupported(&mut program(&["python3", &example("init.py")]));
    }
    let folder = tempfile::tempdir().expect("a folder");
    if let Some(executable) = compiled("init.cpp", folder.path()) {
        assert_all_unsupported(&mut program(&[&executable]));
    }
    if has_all(&["javac", "java"]) {
        let classes = java_classes("init.java", "MyTracer", folder.path());
        assert_all_unsupported(&mut program(&["java", "-cp", &classes, "MyTracer"]));
    }
}

/// Whether all of these programs are there.
fn has_all(programs: &[&str]) -> bool {
    programs.iter().all(|program| has(program))
}

/// The folder of the classes of a Java file, which is compiled under the name of its class.
fn java_classes(file: &str, class: &str, folder: &Path) -> String {
    let source = folder.join(class).with_extension("java");
    fs::copy(example(file), &source).expect("it is copied");
    let flags = ["-encoding", "UTF-8", "--release", "11", "-Xlint:all,-options", "-Werror", "-d"];
    let output = Command::new("javac").args(flags).arg(folder).arg(&source).output();
    let output = output.expect("it runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    folder.to_string_lossy().into_owned()
}

/// Law: the adapters in C++ compile behind a header that brings all names of the standard library, as the book's do.
/// Oracle: the compiler.
#[test]
fn adapters_in_cpp_compile_behind_a_header_of_the_book() {
    if !has("g++") {
        return;
    }
    let header = "#include <algorithm>\n#include <list>\n#include <map>\nusing namespace std;\n\
                  struct Json; struct Reader; int hits; double text, object; void reply();\n";
    let folder = tempfile::tempdir().expect("a folder");
    for file in ["init.cpp", "adapter.cpp"] {
        let path = folder.path().join(file);
        fs::write(&path, header.to_owned() + &text_of(example(file))).expect("it is written");
        let flags = ["-std=c++17", "-Wall", "-Wextra", "-Werror", "-fsyntax-only"];
        let output = Command::new("g++").args(flags).arg(&path).output().expect("it runs");
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    }
}

/// Law: adapters of a language have the same reader of JSON and the same protocol as the one to fill in. Oracle: the
/// texts.
#[test]
fn adapters_of_a_language_share_their_protocol() {
    let between = |file: &str, from: &str, to: &str| {
        let text = text_of(example(file));
        let begin = text.find(from).unwrap_or_else(|| panic!("{file} has no {from}"));
        let end = if to.is_empty() { text.len() } else { text.find(to).expect(to) };
        text[begin..end].to_owned()
    };
    for (from, files) in [
        (
            "def reply",
            &[
                "init.py",
                "adapter.py",
                "wrong.py",
                "book/book.py",
                "programs/ask_trimesh.py",
                "programs/ask_embree.py",
                "programs/ask_mitsuba.py",
            ][..],
        ),
        ("// The protocol", &["init.cpp", "adapter.cpp"]),
        ("/// The protocol", &["init.rs", "adapter.rs", "programs/ask_parry.rs"]),
    ] {
        let texts: Vec<String> = files.iter().map(|file| between(file, from, "")).collect();
        assert!(texts.windows(2).all(|pair| pair[0] == pair[1]), "{files:?} differ from {from} on");
    }
    let reader = between("init.cpp", "#include", "// The questions");
    assert_eq!(reader, between("adapter.cpp", "#include", "// Vectors."));
}

/// A mistake of `wrong.py`.
struct Planted {
    /// Its comment.
    comment: &'static str,
    /// Beginnings of the names of families that it may spoil.
    spoils: &'static [&'static str],
    /// A family that it must spoil, even with few cases.
    surely: &'static str,
    /// What the card calls it; nothing if the answers do not give it away.
    name: &'static str,
}

const PLANTED: [Planted; 10] = [
    Planted {
        comment: "t is counted in a unit direction",
        spoils: &["intersect.sphere."],
        surely: "intersect.sphere.direction_length",
        name: "t is counted in a unit direction",
    },
    Planted {
        comment: "the normal is turned to the viewer",
        spoils: &["intersect.triangle."],
        surely: "intersect.triangle.ordinary",
        name: "the normal is turned to the viewer",
    },
    Planted {
        comment: "a plane is hit behind the origin",
        spoils: &["intersect.plane."],
        surely: "intersect.plane.ordinary",
        name: "a hit behind the origin",
    },
    Planted {
        comment: "what is behind the light hides it",
        spoils: &["occluded."],
        surely: "occluded.plane.segment",
        name: "",
    },
    Planted {
        comment: "1/π is left out",
        spoils: &["lobe.lambertian.values", "lobe.lambertian.sample"],
        surely: "lobe.lambertian.values",
        name: "π times too large",
    },
    Planted {
        comment: "uniform, and the pdf is that of the cosine",
        spoils: &["lobe.lambertian.density"],
        surely: "lobe.lambertian.density",
        name: "",
    },
    Planted {
        comment: "η upside down",
        spoils: &["fresnel.directions"],
        surely: "fresnel.directions",
        name: "η upside down",
    },
    Planted {
        comment: "Schlick's approximation",
        spoils: &["fresnel.cosine"],
        surely: "fresnel.cosine",
        name: "Schlick's approximation",
    },
    Planted {
        comment: "the corner of the pixel",
        spoils: &["camera_ray.pinhole."],
        surely: "camera_ray.pinhole.values",
        name: "the corner of the pixel for its middle",
    },
    Planted {
        comment: "rows from the bottom",
        spoils: &["project.pinhole.values"],
        surely: "project.pinhole.values",
        name: "rows from the bottom",
    },
];

/// Law: each mistake fails its families and no other, and is named where the answers give it away; the exit status
/// is 1. Oracle: the comments that mark the mistakes.
#[test]
fn each_mistake_of_the_wrong_adapter_is_found() {
    let wrong = text_of(example("wrong.py"));
    let comments: Vec<&str> =
        wrong.lines().filter_map(|line| Some(line.split_once("# mistake: ")?.1)).collect();
    let mut expected = PLANTED.map(|planted| planted.comment).to_vec();
    let mut found = comments.clone();
    expected.sort_unstable();
    found.sort_unstable();
    assert_eq!(found, expected);
    if !has("python3") {
        return;
    }
    let wrong = example("wrong.py");
    let mut arguments = vec!["conform", "--json", "--cases", "16"];
    arguments.extend(ANSWERED);
    arguments.extend(["--", "python3", &wrong]);
    let output = groundtruth(&root(), &arguments);
    assert_eq!(output.status.code(), Some(1), "{}", String::from_utf8_lossy(&output.stderr));
    let card: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    let families = card["families"].as_array().expect("a list");
    let failed: Vec<&Value> = families.iter().filter(|row| row["counts"]["wrong"] != 0).collect();
    let is = |row: &Value, name: &str| row["family"] == name;
    for row in &failed {
        let name = row["family"].as_str().expect("a name");
        let is_meant = |planted: &Planted| planted.spoils.iter().any(|it| name.starts_with(it));
        assert!(PLANTED.iter().any(is_meant), "{name} fails, and no mistake spoils it: {row}");
    }
    for Planted { comment, surely, name, .. } in PLANTED {
        let row = failed.iter().find(|row| is(row, surely));
        let row = row.unwrap_or_else(|| panic!("{surely} does not fail: {comment}"));
        let names: Vec<&str> = row["names"]
            .as_array()
            .into_iter()
            .flatten()
            .filter_map(|name| name.as_str()?.split(" (").next())
            .collect();
        assert!(name.is_empty() || names.contains(&name), "{surely}: {comment}: {names:?}");
    }
}

/// The fenced blocks of a document, each with its language.
fn blocks(text: &str) -> Vec<(&str, &str)> {
    let fenced = text.split("```").skip(1).step_by(2);
    fenced.filter_map(|block| block.split_once('\n')).collect()
}

/// Whether a text is what is shown, where a line `…` stands for any lines.
fn shows(shown: &str, printed: &str) -> bool {
    let mut rest = printed;
    let parts: Vec<&str> = shown.split("…\n").collect();
    let last = parts.len() - 1;
    parts.iter().enumerate().all(|(index, part)| {
        let at = match index {
            0 => rest.starts_with(part).then_some(0),
            _ if index == last => rest.ends_with(part).then(|| rest.len() - part.len()),
            _ => rest.find(part),
        };
        at.map(|at| rest = &rest[at + part.len()..]).is_some()
    }) && (last > 0 || rest.is_empty())
}

/// Law: the tour of the document is true: its function, put into the adapter of `--init`, gets the cards that are
/// shown, before and after its correction; and so does the wrong adapter. Oracle: the program.
#[test]
fn the_document_shows_what_is_printed() {
    if !has("python3") {
        return;
    }
    let folder = tempfile::tempdir().expect("a folder");
    let tracer = folder.path().join("my_tracer.py");
    let document = text_of(root().join("docs/conform.md"));
    let mut count = 0;
    for (language, text) in blocks(&document) {
        match language {
            "python" => {
                let init = Language::Python.template();
                let (before, rest) = init.split_once("def intersect").expect("a function");
                let (_, after) = rest.split_once("\n\n\n").expect("the next function");
                let before = before.replace("import json\n", "import json\nimport math\n");
                fs::write(&tracer, format!("{before}{text}\n\n{after}")).expect("it is written");
            }
            "diff" => {
                let line = |sign| text.lines().find_map(|line| line.strip_prefix(sign));
                let (old, new) = (line('-').expect("a line"), line('+').expect("a line"));
                let program = text_of(&tracer);
                assert!(program.contains(old));
                let changed = program.replace(&format!("{old}\n"), &format!("{new}\n"));
                fs::write(&tracer, changed).expect("it is written");
            }
            "console" => {
                let (command, shown) = text.split_once('\n').expect("a command and its output");
                let words = command.strip_prefix("$ groundtruth ").expect("our program");
                let words: Vec<&str> = words.split(' ').collect();
                let root = root();
                let is_tour = words.contains(&"my_tracer.py");
                let place = if is_tour { folder.path() } else { &root };
                let output = groundtruth(place, &words);
                let printed = String::from_utf8_lossy(&output.stdout);
                assert!(
                    shows(shown, &printed),
                    "{command}\nprints\n{printed}\ndocs/conform.md says\n{shown}"
                );
                count += 1;
            }
            _ => {}
        }
    }
    assert_eq!(count, 3, "two cards of the tour, and one of the wrong adapter");
}

/// Law: a line `…` stands for any lines, and only that. Oracle: texts by hand.
#[test]
fn lines_left_out_are_any_lines() {
    assert!(shows("a\n…\nd\n", "a\nb\nc\nd\n"));
    assert!(shows("a\n…\nb\n…\nd\n", "a\nb\nc\nd\n"));
    assert!(!shows("a\n…\nd\n", "a\nb\nd\nc\n"));
    assert!(!shows("a\n", "a\nb\n"));
    assert!(!shows("b\n", "a\nb\n"));
}
