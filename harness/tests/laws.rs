//! The command line of `laws`: exit statuses, files, programs to start from, and its document.

use std::process::{Command, Output};

use claims::{Kind, Law};
use serde_json::Value;

use super::conform_adapters::Called;
use super::structure::{read, root};

#[allow(dead_code, clippy::disallowed_methods)] // its `main`; its user may call any sine
#[path = "../../examples/laws/init.rs"]
mod init;

const GROUNDTRUTH: &str = env!("CARGO_BIN_EXE_groundtruth");

/// A program of Python's, started where the repository is.
fn laws(arguments: &[&str]) -> Output {
    let mut command = Command::new(GROUNDTRUTH);
    command.current_dir(root()).arg("laws").args(arguments).output().expect("it starts")
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

/// Law: the commands that docs/laws.md shows print what it shows, and its tables have every law. Oracle: the document.
#[test]
fn the_document_shows_what_is_printed() {
    let page = read(&root().join("docs/laws.md"));
    for law in Kind::ALL.into_iter().flat_map(Law::of) {
        let row = format!("| {} | {} | {} |", law.name, law.sentence, law.cause);
        assert!(page.contains(&row.replace("|cos θi|", "\\|cos θi\\|")), "no row for {}", law.name);
    }
    let blocks: Vec<&str> = page.split("$ groundtruth laws ").skip(1).collect();
    assert_eq!(blocks.len(), 2, "an example of a lobe, and one of a light");
    for block in blocks {
        let (line, rest) = block.split_once('\n').expect("a line");
        let (shown, _) = rest.split_once("```").expect("the end of the block");
        let arguments: Vec<&str> = line.split(' ').collect();
        let output = laws(&arguments);
        assert_eq!(output.status.code(), Some(1), "{}", text(&output.stderr));
        assert_eq!(text(&output.stdout), shown);
    }
}

/// Law: right lobes exit with 0, and files and JSON say so; a mistake exits with 1, nothing that can be judged with 2.
#[test]
fn the_exit_status_says_whether_a_law_is_broken() {
    let folder = tempfile::tempdir().expect("a folder");
    let [page, junit] = ["card.html", "junit.xml"].map(|name| folder.path().join(name));
    let [shown_page, shown_junit] = [&page, &junit].map(|path| path.to_str().expect("text"));
    let bsdfs = ["--", "python3", "examples/laws/bsdfs.py"];
    let few = ["lambert", "--cases", "2"];
    let right =
        laws(&[&few[..], &["--json", "-o", shown_page, "--junit", shown_junit], &bsdfs].concat());
    assert_eq!(right.status.code(), Some(0), "{}", text(&right.stderr));
    let json: Value = serde_json::from_slice(&right.stdout).expect("JSON");
    assert_eq!(json["subjects"][0]["failed"], Value::Bool(false));
    assert!(read(&page).contains("no law is broken by 1 lobe"));
    assert!(read(&junit).contains("testcase"));
    let wrong = laws(&[&few[..], &bsdfs, &["cosine", "twice"]].concat());
    assert_eq!(wrong.status.code(), Some(1));
    assert!(
        text(&wrong.stdout).contains("what is found is |cos θi| times"),
        "{}",
        text(&wrong.stdout)
    );
    for (arguments, words) in [
        (&["nobody", "--", "python3", "examples/laws/bsdfs.py"][..], "the program lists lambert"),
        (&["--", "true"], "ended"),
        (&["--", "sh", "-c", "echo banner; cat"], "not a JSON object"),
        (&["--start-timeout", "0.2", "--timeout", "0.2", "--", "sleep", "9"], "flush"),
    ] {
        let output = laws(arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        assert!(text(&output.stderr).contains(words), "{words}: {}", text(&output.stderr));
    }
}

/// Law: a run that is interrupted ends with 130 and says so in the terminal, on the page and in JUnit's file, with what is known. Oracle:
/// a program that interrupts whoever asks it about the second lobe.
#[test]
#[cfg(unix)]
fn an_interrupted_run_says_so_and_not_that_all_is_right() {
    let folder = tempfile::tempdir().expect("a folder");
    let [page, junit] = ["card.html", "junit.xml"].map(|name| folder.path().join(name));
    let [shown_page, shown_junit] = [&page, &junit].map(|path| path.to_str().expect("text"));
    let program = "import os, signal, sys; sys.path.insert(0, 'examples/laws'); import bsdfs, init\n\
                   old = init.answer\n\
                   def answer(question):\n    \
                   data = list(question.values())[0]\n    \
                   if data.get('lobe', 'lambert') != 'lambert': os.kill(os.getppid(), signal.SIGINT)\n    \
                   return old(question)\n\
                   init.answer = answer; init.main()";
    let files = ["--cases", "2", "-o", shown_page, "--junit", shown_junit];
    let output = laws(&[&files[..], &["--", "python3", "-c", program]].concat());
    assert_eq!(output.status.code(), Some(130), "{}", text(&output.stderr));
    let said = "interrupted after 1 of 6 lobes; until then no law is known to be broken";
    assert!(text(&output.stdout).starts_with(said), "{}", text(&output.stdout));
    assert!(read(&page).contains(said));
    assert!(read(&junit).contains("<error message=\"interrupted\""));
}

/// Law: the programs to start from keep all laws as they are. Oracle: Lambert's lobe.
#[test]
fn programs_to_start_from_keep_all_laws() {
    let folder = tempfile::tempdir().expect("a folder");
    let written = |language: &str, name: &str| {
        let output = laws(&["--init", language]);
        let path = folder.path().join(name);
        std::fs::write(&path, output.stdout).expect("it can be written");
        path.to_str().expect("text").to_owned()
    };
    let python = written("python", "my_bsdfs.py");
    let mut programs = vec![vec!["python3".to_owned(), python]];
    let source = written("cpp", "my_bsdfs.cpp");
    let built = folder.path().join("my_bsdfs").to_str().expect("text").to_owned();
    let compiler = ["-std=c++17", "-O1", "-Wall", "-o", &built, &source];
    match Command::new("c++").args(compiler).status() {
        Ok(status) => {
            assert!(status.success());
            programs.push(vec![built]);
        }
        Err(error) => eprintln!("not tried in C++: {error}"),
    }
    let source = written("java", "MyBsdfs.java");
    match Command::new("javac").args(["-Xlint:all", "-Werror", &source]).status() {
        Ok(status) => {
            assert!(status.success());
            let classes = folder.path().to_str().expect("text").to_owned();
            programs.push(["java", "-cp", &classes, "MyBsdfs"].map(str::to_owned).to_vec());
        }
        Err(error) => eprintln!("not tried in Java: {error}"),
    }
    assert_eq!(
        text(&laws(&["--init", "rust"]).stdout),
        read(&root().join("examples/laws/init.rs"))
    );
    let mut rust = Called(init::reply);
    let lobes = claims::listed(&mut rust).expect("it lists its lobe");
    let options = claims::ClaimsOptions { cases: 2, seed: 1 };
    let card = claims::run(&mut rust, &lobes, options, &mut |_| ());
    assert!(!card.is_failed() && !card.rows.is_empty(), "{card}");
    for program in programs {
        let words: Vec<&str> = program.iter().map(String::as_str).collect();
        let output = laws(&[&["--cases", "2", "--"], &words[..]].concat());
        assert_eq!(output.status.code(), Some(0), "{words:?}: {}", text(&output.stdout));
    }
}

/// Law: each adapter of a program that people use is run by `scripts/law-cards.sh`, and named in the document of its card.
/// Oracle: the files.
#[test]
fn every_adapter_of_bsdfs_is_run_and_named() {
    let folder = root().join("examples/laws");
    let [script, document] =
        ["scripts/law-cards.sh", "docs/cards.md"].map(|name| read(&root().join(name)));
    let mut count = 0;
    for entry in
        [folder.join("pbrt"), folder].iter().flat_map(|it| it.read_dir().expect("a folder"))
    {
        let path = entry.expect("it can be read").path();
        let name = path.file_name().and_then(|name| name.to_str()).expect("text");
        let Some((stem, _)) = name.split_once('.').filter(|(stem, _)| stem.ends_with("_bsdfs"))
        else {
            continue;
        };
        count += 1;
        assert!(script.contains(stem), "scripts/law-cards.sh does not run {name}");
        assert!(document.contains(&format!("[{name}](../examples/laws/")), "no link to {name}");
    }
    assert_eq!(count, 3, "adapters whose names end with _bsdfs");
}
