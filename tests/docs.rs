//! Checks of the documents: every link leads to a file, and every kind is in the map of the book.

use std::fs;
use std::path::{Path, PathBuf};

use groundtruth::{bumps, cameras, filters, lights, lobes, materials, samplers, shapes, textures};

fn root() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/.."))
}

fn documents() -> Vec<PathBuf> {
    let mut all: Vec<PathBuf> =
        ["README.md", "CONTRIBUTING.md", "CHANGELOG.md"].map(|name| root().join(name)).into();
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

/// Law: every class of the book is built. Oracle: none; the map itself says so, and another test checks that
/// it names every kind.
#[test]
fn the_map_of_the_book_is_whole() {
    let map = fs::read_to_string(root().join("docs/book.md")).expect("the map of the book");
    let left: Vec<&str> = map.lines().filter(|line| line.contains("not built yet")).collect();
    assert!(left.is_empty(), "docs/book.md says that these are not built: {left:#?}");
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
    let map = fs::read_to_string(root().join("docs/book.md")).expect("the map is there");
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
    let text = fs::read_to_string(root().join("README.md")).expect("the README is there");
    let mut count = 0;
    for word in text.split(|c: char| c.is_whitespace() || "`,;)|".contains(c)) {
        let is_scene = word.len() > 5 && word.starts_with("ch") && word.contains('/');
        if is_scene && word.as_bytes()[2].is_ascii_digit() {
            count += 1;
            assert!(groundtruth::gallery::find(word).is_some(), "README: no scene {word}");
        }
    }
    assert!(count >= 2, "found no scenes in the README: the search for them is broken");
}
