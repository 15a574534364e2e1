//! Kinds: each has a file and an entry, and modules that work for all kinds name none of them.

use std::collections::{BTreeMap, BTreeSet};

use super::{code_by_module, read, rust_files, sources, without_comments};

/// The folders whose files are kinds.
const KINDS: [&str; 9] = [
    "shapes",
    "lobes",
    "materials",
    "lights",
    "samplers",
    "cameras",
    "textures",
    "filters",
    "bumps",
];

/// A new kind never needs a line in `trace`, `render` or `world`, which work for all kinds. (The
/// world's default samplers are the exception.)
#[test]
fn tracing_and_rendering_name_no_kind_of_anything() {
    let mut wrong = Vec::new();
    for (module, files) in code_by_module(&sources()) {
        if !["trace", "render", "world"].contains(&module.as_str()) {
            continue;
        }
        for (path, code) in files {
            for folder in KINDS {
                for kind in entries(folder).values() {
                    let default =
                        module == "world" && ["Regular", "MultiJittered"].contains(&&**kind);
                    if !default && words_from(folder, &code).contains(kind) {
                        wrong.push(format!("src/{}: names {folder}::{kind}", path.display()));
                    }
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// The words after each `crate::folder::`, up to the end of its statement or group.
fn words_from(folder: &str, code: &str) -> BTreeSet<String> {
    let start = format!("crate::{folder}::");
    let paths = code.match_indices(&start).map(|(at, _)| &code[at + start.len()..]);
    let texts = paths.map(|rest| match rest.strip_prefix('{') {
        Some(group) => group.split_once('}').map_or(group, |(group, _)| group),
        None => rest
            .split_once(|c: char| !c.is_alphanumeric() && c != ':')
            .map_or(rest, |(path, _)| path),
    });
    texts.flat_map(|text| text.split(|c: char| !c.is_alphanumeric())).map(str::to_owned).collect()
}

/// The entries of a folder's list: each module, and the name of its data type.
fn entries(folder: &str) -> BTreeMap<String, String> {
    let text = without_comments(&read(&sources().join(folder).join("mod.rs")));
    let mut entries = BTreeMap::new();
    for line in text.lines() {
        let mut words = line.split_whitespace();
        let (Some(chapter), Some(entry)) = (words.next(), words.next()) else { continue };
        let is_chapter = chapter.len() == 4
            && chapter.starts_with("ch")
            && chapter[2..].chars().all(|c| c.is_ascii_digit());
        if let (true, Some((module, data))) = (is_chapter, entry.split_once("::")) {
            entries.insert(module.to_owned(), data.trim_end_matches(',').to_owned());
        }
    }
    entries
}

/// The modules in the blocks `// shared by the kinds` of a folder and its subfolders. Each block ends with an
/// empty line.
fn shared(folder: &str) -> BTreeSet<String> {
    let mut modules = BTreeSet::new();
    for path in rust_files(&sources().join(folder)).iter().filter(|path| path.ends_with("mod.rs")) {
        let text = read(path);
        let block = text.split_once("// shared by the kinds\n").map_or("", |(_, rest)| rest);
        let lines = block.lines().take_while(|line| !line.trim().is_empty());
        modules.extend(
            lines
                .filter_map(|line| line.trim_start_matches("pub ").strip_prefix("mod "))
                .map(|module| module.trim_end_matches(';').to_owned()),
        );
    }
    modules
}

#[test]
fn every_file_is_a_kind_with_an_entry_or_shared_by_the_kinds() {
    let mut wrong = Vec::new();
    for folder in KINDS {
        let (entries, shared) = (entries(folder), shared(folder));
        assert!(!entries.is_empty(), "src/{folder}/mod.rs: no list of kinds was found");
        for path in rust_files(&sources().join(folder)) {
            let stem = path.file_stem().expect("files have names").to_string_lossy().into_owned();
            let listed = [entries.contains_key(&stem), shared.contains(&stem)];
            match listed {
                _ if stem == "mod" => {}
                [true, false] | [false, true] => {}
                [false, false] => wrong.push(format!(
                    "src/{folder}/{stem}.rs: has no entry in the list of src/{folder}/mod.rs \
                     (and is not in its block `// shared by the kinds`)"
                )),
                [true, true] => wrong.push(format!(
                    "src/{folder}/{stem}.rs: is both a kind and shared by the kinds"
                )),
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
