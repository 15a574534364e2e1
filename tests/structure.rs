//! The house: which module may name which, and that every kind's file has its entry.
//!
//! Read from the sources' own text: `crate::` paths outside comments, `mod` lines and lists.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// The modules each module may name beside itself. Arrows run one way.
const MAY_NAME: &[(&str, &[&str])] = &[
    ("math", &[]),
    ("invalid", &["math"]),
    ("rgb", &["invalid", "math"]),
    ("kinds", &["invalid", "kinds", "rgb"]),
    ("noise", &["invalid", "math", "samplers"]),
    ("bumps", &["invalid", "kinds", "math", "noise", "resources", "textures"]),
    ("mesh_file", &[]),
    ("candidate", &[]),
    ("accel", &["candidate", "math"]),
    ("mesh_bvh", &["accel", "candidate", "math"]),
    (
        "shapes",
        &["accel", "candidate", "invalid", "kinds", "math", "mesh_bvh", "mesh_file", "resources"],
    ),
    ("samplers", &["invalid", "kinds", "math"]),
    ("lobes", &["invalid", "kinds", "math", "rgb", "samplers"]),
    ("textures", &["images", "invalid", "kinds", "math", "noise", "resources", "rgb", "shapes"]),
    (
        "materials",
        &[
            "emission",
            "invalid",
            "kinds",
            "lobes",
            "math",
            "medium",
            "resources",
            "rgb",
            "textures",
        ],
    ),
    ("emission", &["rgb", "textures"]),
    ("medium", &["invalid", "kinds", "rgb"]),
    (
        "lights",
        &["background", "emission", "invalid", "kinds", "math", "rgb", "shapes", "textures"],
    ),
    ("cameras", &["invalid", "kinds", "math", "medium"]),
    ("film", &["math", "rgb"]),
    ("filters", &["invalid", "kinds", "math"]),
    ("background", &["images", "invalid", "kinds", "math", "resources", "rgb", "textures"]),
    ("images", &["film", "invalid", "math", "rgb"]),
    ("resources", &["images", "invalid", "mesh_file"]),
    (
        "scene",
        &[
            "accel",
            "background",
            "bumps",
            "cameras",
            "film",
            "filters",
            "invalid",
            "kinds",
            "lights",
            "materials",
            "math",
            "rgb",
            "samplers",
            "shapes",
        ],
    ),
    (
        "world",
        &[
            "accel",
            "background",
            "bumps",
            "cameras",
            "filters",
            "invalid",
            "lights",
            "materials",
            "math",
            "resources",
            "rgb",
            "samplers",
            "scene",
            "shapes",
            "textures",
        ],
    ),
    (
        "trace",
        &[
            "lights",
            "lobes",
            "materials",
            "math",
            "rgb",
            "samplers",
            "scene",
            "shapes",
            "textures",
            "world",
        ],
    ),
    ("render", &["film", "math", "rgb", "samplers", "scene", "trace", "world"]),
    ("ray_budget", &["math", "render", "rgb", "trace", "world"]),
    (
        "explain",
        &["lobes", "math", "render", "rgb", "scene", "shapes", "textures", "trace", "world"],
    ),
    (
        "gallery",
        &[
            "accel",
            "background",
            "bumps",
            "cameras",
            "film",
            "filters",
            "images",
            "kinds",
            "lights",
            "lobes",
            "materials",
            "math",
            "noise",
            "rgb",
            "samplers",
            "scene",
            "shapes",
            "textures",
        ],
    ),
    (
        "probe",
        &[
            "accel",
            "background",
            "cameras",
            "gallery",
            "invalid",
            "kinds",
            "lights",
            "lobes",
            "materials",
            "math",
            "noise",
            "ray_budget",
            "render",
            "resources",
            "rgb",
            "samplers",
            "scene",
            "shapes",
            "textures",
            "trace",
            "world",
        ],
    ),
    ("reference", &["scene"]),
    (
        "report",
        &[
            "accel",
            "film",
            "cameras",
            "gallery",
            "images",
            "kinds",
            "lights",
            "lobes",
            "materials",
            "math",
            "render",
            "rgb",
            "samplers",
            "scene",
            "shapes",
            "textures",
            "trace",
            "verify",
            "world",
        ],
    ),
    (
        "verify",
        &[
            "accel",
            "cameras",
            "film",
            "gallery",
            "kinds",
            "lights",
            "materials",
            "math",
            "render",
            "rgb",
            "scene",
            "shapes",
            "trace",
            "world",
        ],
    ),
];

/// The folders whose files are kinds of something.
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

fn sources() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("src")
}

fn read(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

/// The Rust files of a folder and its folders.
fn rust_files(folder: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).expect("the folder is there") {
        let path = entry.expect("its entries can be read").path();
        if path.is_dir() {
            files.extend(rust_files(&path));
        } else if path.extension().is_some_and(|e| e == "rs") {
            files.push(path);
        }
    }
    files.sort();
    files
}

/// The code of a file, by module of the library: `src/shapes/disk.rs` is `shapes`. Comments are left
/// out: documentation may name anything. The command line is no module of the library.
fn code_by_module() -> BTreeMap<String, Vec<(PathBuf, String)>> {
    let mut modules: BTreeMap<String, Vec<(PathBuf, String)>> = BTreeMap::new();
    for path in rust_files(&sources()) {
        let inside = path.strip_prefix(sources()).expect("it is a source").to_owned();
        let first = inside.iter().next().expect("it has a name").to_string_lossy();
        let module = first.trim_end_matches(".rs").to_owned();
        if !["lib", "main", "cli"].contains(&module.as_str()) {
            modules.entry(module).or_default().push((inside, without_comments(&read(&path))));
        }
    }
    modules
}

fn without_comments(text: &str) -> String {
    let code = |line: &str| line.split_once("//").map_or(line, |(code, _)| code).to_owned();
    text.lines().map(code).collect::<Vec<_>>().join("\n")
}

/// The modules that a text names as `crate::…`, also inside braces: `crate::{accel, shapes::Plane}`.
fn named_modules(code: &str) -> BTreeSet<String> {
    let name = |text: &str| -> String {
        text.chars().take_while(|c| c.is_ascii_lowercase() || *c == '_').collect()
    };
    let mut names = BTreeSet::new();
    for (at, path) in code.match_indices("crate::") {
        let rest = &code[at + path.len()..];
        let Some(group) = rest.strip_prefix('{') else {
            names.insert(name(rest));
            continue;
        };
        let (mut depth, mut start) = (0, true);
        for (i, c) in group.char_indices() {
            match c {
                '{' => depth += 1,
                '}' if depth == 0 => break,
                '}' => depth -= 1,
                ',' if depth == 0 => start = true,
                c if start && !c.is_whitespace() => {
                    names.insert(name(&group[i..]));
                    start = false;
                }
                _ => {}
            }
        }
    }
    names.retain(|name| !name.is_empty());
    names
}

#[test]
fn arrows_between_modules_run_one_way() {
    let allowed: BTreeMap<&str, &[&str]> = MAY_NAME.iter().copied().collect();
    let mut wrong = Vec::new();
    for (module, files) in code_by_module() {
        let Some(may_name) = allowed.get(module.as_str()) else {
            wrong.push(format!("src/{module} is not in this test's list of arrows"));
            continue;
        };
        for (path, code) in files {
            for named in named_modules(&code) {
                if named != module && !may_name.contains(&named.as_str()) {
                    wrong.push(format!("src/{}: must not name {named}", path.display()));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// One recursion for every kind: a new one never needs a line in `trace`, `render` or `world`. (The
/// world's default samplers are the exception.)
#[test]
fn tracing_and_rendering_name_no_kind_of_anything() {
    let mut wrong = Vec::new();
    for (module, files) in code_by_module() {
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

#[test]
fn only_the_mathematics_names_glam() {
    for (module, files) in code_by_module() {
        for (path, code) in files {
            let names = code.contains("glam::") || code.contains("use glam");
            assert!(module == "math" || !names, "src/{}: names glam", path.display());
        }
    }
}

/// The entries of a folder's list: module and the name of its data.
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

/// The modules of the blocks `// shared by the kinds` of a folder and its folders, each of which ends with
/// an empty line.
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

/// The gallery's files, like the kinds': each chapter's list is part of the whole.
#[test]
fn every_chapter_of_the_gallery_is_in_its_list() {
    let text = read(&sources().join("gallery/mod.rs"));
    for path in rust_files(&sources().join("gallery")) {
        let stem = path.file_stem().expect("files have names").to_string_lossy().into_owned();
        let listed = text.contains(&format!("{stem}::SCENES"));
        assert!(
            !stem.starts_with("ch") || listed,
            "src/gallery/{stem}.rs: its scenes are not in the list of src/gallery/mod.rs"
        );
    }
}

/// The checker checked: each planted violation is seen.
#[test]
fn names_are_found_in_paths_and_in_groups_but_not_in_comments() {
    let found = |code: &str| -> Vec<String> { named_modules(code).into_iter().collect() };
    assert_eq!(found("use crate::world::World;"), ["world"]);
    assert_eq!(found("let x = crate::trace::radiance(w, r);"), ["trace"]);
    assert_eq!(
        found("use crate::{accel, shapes::{Plane, Sphere},\n    lights};"),
        ["accel", "lights", "shapes"]
    );
    assert!(
        found(&without_comments("//! See crate::world.\nlet a = 1; // crate::trace")).is_empty()
    );
    assert_eq!(found("$crate::kinds::Entry"), ["kinds"]);
    let words =
        words_from("shapes", "use crate::shapes::{Shape, Plane as P}; crate::shapes::Disk {");
    assert!(["Shape", "Plane", "Disk"].iter().all(|&word| words.contains(word)), "{words:?}");
    assert!(words_from("shapes", "use crate::math::{Point, Plane};").is_empty());
}
