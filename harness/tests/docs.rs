//! Checks of the documents: links, the map of the book, and what they say about code, files and tests.

use std::fs;
use std::path::{Path, PathBuf};

use groundtruth::{bumps, cameras, filters, lights, lobes, materials, samplers, shapes, textures};
use report::PAGES;
use testkit::same_text::{Printed, hold};

use crate::kit::{Folder, root, text_of};

fn documents() -> Vec<PathBuf> {
    let names = ["README.md", "ARCHITECTURE.md", "CONTRIBUTING.md", "CHANGELOG.md"];
    let mut all: Vec<PathBuf> = names.map(|name| root().join(name)).into();
    let docs = fs::read_dir(root().join("docs")).expect("there are documents");
    all.extend(docs.map(|entry| entry.expect("readable").path()));
    all.retain(|path| path.extension().is_some_and(|extension| extension == "md"));
    all
}

/// The targets of `[text](target)`, outside code blocks.
fn links(text: &str) -> Vec<String> {
    let prose: String = text.split("```").step_by(2).collect();
    let targets = prose.split("](").skip(1);
    targets.filter_map(|rest| rest.split_once(')').map(|(target, _)| target.to_owned())).collect()
}

#[test]
fn every_link_in_the_documents_leads_to_a_file() {
    let mut count = 0;
    for document in documents() {
        let text = fs::read_to_string(&document).expect("documents are text");
        let folder = document.parent().expect("documents are in a folder");
        for link in links(&text) {
            count += 1;
            let target = link.split('#').next().unwrap_or_default();
            let outside = link.starts_with("http") || target.is_empty();
            assert!(
                outside || folder.join(target).exists(),
                "{}: {link} leads nowhere",
                document.display()
            );
        }
    }
    assert!(count > 80, "found only {count} links: the search for them is broken");
}

#[test]
fn every_kind_is_in_the_map_of_the_book() {
    let map = text_of("docs/book.md");
    let linked = links(&map);
    let check = |folder: &str, module: &str| {
        let (folder, file) = (format!("../src/{folder}/"), format!("/{module}.rs"));
        let is_its = |link: &String| link.starts_with(&folder) && link.ends_with(&file);
        assert!(linked.iter().any(is_its), "docs/book.md has no link to {folder}…{file}");
    };
    shapes::Kind::ENTRIES.iter().for_each(|e| check("shapes", e.module));
    samplers::Kind::ENTRIES.iter().for_each(|e| check("samplers", e.module));
    cameras::Kind::ENTRIES.iter().for_each(|e| check("cameras", e.module));
    filters::Kind::ENTRIES.iter().for_each(|e| check("filters", e.module));
    lights::Kind::ENTRIES.iter().for_each(|e| check("lights", e.module));
    lobes::Lobe::ENTRIES.iter().for_each(|e| check("lobes", e.module));
    materials::Kind::ENTRIES.iter().for_each(|e| check("materials", e.module));
    textures::Kind::ENTRIES.iter().for_each(|e| check("textures", e.module));
    bumps::Kind::ENTRIES.iter().for_each(|e| check("bumps", e.module));
}

#[test]
fn the_readme_names_only_commands_and_scenes_that_exist() {
    let text = text_of("README.md");
    let mut count = 0;
    for word in text.split(|c: char| c.is_whitespace() || "`,;)|".contains(c)) {
        let is_scene = word.len() > 5 && word.starts_with("ch") && word.contains('/');
        if is_scene && word.as_bytes()[2].is_ascii_digit() {
            count += 1;
            assert!(gallery::find(word).is_some(), "README: no scene {word}");
        }
    }
    assert!(count >= 2, "found no scenes in the README: the search for them is broken");
}

/// Law: the commands that documents show print what they show, with these exit statuses: two pictures, each rendered and judged; a
/// lobe and a light; and the tour of docs/ci.md, whose first lines render the sets. Oracle: the documents.
#[test]
fn documents_show_what_is_printed() {
    for (document, place, statuses, printed) in [
        ("docs/verify.md", "", &[0, 0, 0, 1][..], Printed::Rounded),
        ("docs/laws.md", "cd $ROOT; ", &[1, 1], Printed::Exactly),
        ("docs/ci.md", "", &[0, 1], Printed::Exactly),
    ] {
        let (page, folder, mut found) = (text_of(document), Folder::new(), Vec::new());
        let mut should_say = page.clone();
        for block in page.split("```sh\n").filter(|block| block.starts_with("mkdir reference")) {
            folder.good(block.split("```").next().expect("lines"));
        }
        for block in page.split("```console\n$ ").skip(1) {
            let (block, _) = block.split_once("```").expect("it ends");
            let (command, shown) = block.split_once('\n').expect("a command");
            let run = folder.run(&format!("{place}{command}"));
            let [old, new] = [shown, &run.stdout].map(|text| format!("$ {command}\n{text}```"));
            should_say = should_say.replacen(&old, &new, 1);
            found.extend(run.status);
        }
        assert_eq!(found, statuses, "the exit statuses of {document}");
        hold(&root().join(document), &should_say, printed);
    }
}

/// Law: the program in the README is the example, without its header comment. The example is compiled with
/// the tests, so the README's program compiles too.
#[test]
fn the_program_in_the_readme_is_the_example() {
    let (readme, example) = (text_of("README.md"), text_of("examples/sphere.rs"));
    let programs: Vec<&str> = readme.split("```rust\n").skip(1).collect();
    assert_eq!(programs.len(), 1, "the README has one program");
    let (program, _) = programs[0].split_once("```").expect("its code block ends");
    let without_header = example.lines().skip_while(|line| line.starts_with("//!")).skip(1);
    assert_eq!(program.lines().collect::<Vec<_>>(), without_header.collect::<Vec<_>>());
}

/// Law: the reading path's numbers of lines are those of the files, within a tenth, and their sum.
#[test]
fn the_reading_path_says_how_long_its_files_are() {
    let page = text_of("ARCHITECTURE.md");
    let (before, rest) = page.split_once("| file | lines |").expect("the reading path");
    let rows: Vec<&str> = rest.lines().skip(2).take_while(|line| line.starts_with('|')).collect();
    let mut sum = 0;
    for row in &rows {
        let cells: Vec<&str> = row.split('|').map(str::trim).collect();
        let said: usize = cells[2].parse().expect("a number of lines");
        let file = &links(cells[1])[0];
        let found = text_of(file).lines().count();
        assert!(10 * said.abs_diff(found) <= found, "{file}: {said} lines said, {found} found");
        sum += said;
    }
    for said in [format!("in {} files", rows.len()), format!("are {sum} lines")] {
        assert!(before.contains(&said), "ARCHITECTURE.md does not say \"{said}\"");
    }
}

/// Law: the table of the report's pages has each page's name and question, in their order.
#[test]
fn the_document_of_the_report_asks_the_questions_of_its_pages() {
    let text = text_of("docs/report.md");
    let (_, rest) = text.split_once("| page | question |").expect("the table of pages");
    let rows = rest.lines().skip(2).take_while(|line| line.starts_with('|'));
    let cells = |row: &str| {
        let cells: Vec<&str> = row.split('|').map(str::trim).collect();
        [cells[1].trim_matches('`'), cells[2]].map(str::to_owned)
    };
    let pages = PAGES.iter().map(|page| [page.name, page.question].map(str::to_owned));
    assert_eq!(rows.map(cells).collect::<Vec<_>>(), pages.collect::<Vec<_>>());
}

/// Law: a chapter's laws are in `chNN.rs` or `chNN/mod.rs` and in the folder `chNN`, as the documents say. Each
/// file is a module: cargo would ignore any other without a word.
#[test]
fn every_chapter_has_its_file_or_folder_and_every_file_is_a_module() {
    let main = text_of("tests/chapters/main.rs");
    for chapter in (1..=31).map(|number| format!("ch{number:02}")) {
        assert!(main.contains(&format!("\nmod {chapter};")), "main.rs has no mod {chapter};");
        let places = [format!("{chapter}.rs"), format!("{chapter}/mod.rs")];
        let chapters = root().join("tests/chapters");
        let found = places.iter().find(|place| chapters.join(place).exists());
        let file = found.unwrap_or_else(|| panic!("none of {places:?} is in tests/chapters"));
        let code = text_of(&format!("tests/chapters/{file}"));
        for entry in fs::read_dir(chapters.join(&chapter)).into_iter().flatten() {
            let path = entry.expect("readable").path();
            let name = path.file_stem().expect("it has a name").to_string_lossy().into_owned();
            let is_rust = path.extension().is_some_and(|extension| extension == "rs");
            let is_module = code.lines().any(|line| line.ends_with(&format!("mod {name};")));
            assert!(!is_rust || name == "mod" || is_module, "{file} has no mod {name};");
        }
    }
}

/// The text of all files of tests and cases below a folder, and the names of these files as modules.
fn tests_below(folder: &Path) -> String {
    let mut text = String::new();
    for entry in fs::read_dir(folder).expect("a folder of tests") {
        let path = entry.expect("readable").path();
        if path.is_dir() {
            text += &tests_below(&path);
        } else if path.extension().is_some_and(|it| it == "rs" || it == "toml") {
            let module = path.file_stem().unwrap_or_default().to_string_lossy();
            text += &format!("mod {module};\n{}", fs::read_to_string(&path).expect("text"));
        }
    }
    text
}

/// Law: each law that the table of promises names is there. Oracle: the functions and modules of all tests.
#[test]
fn the_laws_of_the_table_of_promises_are_there() {
    let packages =
        ["benches", "explain", "harness"].map(|it| fs::read_dir(root().join(it)).expect("there"));
    let packages = packages.into_iter().flatten();
    let folders = packages.map(|entry| entry.expect("readable").path().join("tests"));
    let mut folders: Vec<PathBuf> = folders.filter(|folder| folder.is_dir()).collect();
    folders.extend(["harness/tests", "inspector/tests", "tests"].map(|it| root().join(it)));
    let tests: String = folders.iter().map(|folder| tests_below(folder)).collect();
    let page = text_of("docs/power.md");
    let (_, table) = page.split_once("| promise | law |").expect("the table of promises");
    let mut named = 0;
    for row in table.lines().skip(2).take_while(|line| line.starts_with('|')) {
        let laws = row.split(" | ").nth(2).unwrap_or_else(|| panic!("no law in the row {row}"));
        for law in laws.split('`').skip(1).step_by(2) {
            let name = law.rsplit([' ', ':']).next().unwrap_or_default();
            let (whole, begin) = (name.trim_end_matches('…'), name.ends_with('…'));
            let kinds = ["fn ", "mod "].map(|kind| format!("{kind}{whole}"));
            let is_there = kinds.iter().any(|text| {
                tests.match_indices(text.as_str()).any(|(at, _)| {
                    begin
                        || !tests[at + text.len()..]
                            .starts_with(|c: char| c == '_' || c.is_alphanumeric())
                })
            });
            assert!(
                is_there,
                "the law {law}: found no such test or module, expected one of the row {row}"
            );
            named += 1;
        }
    }
    assert!(named > 100, "laws named: found {named}, expected more than 100");
}
