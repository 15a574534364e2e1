//! Which module of the library and of the window may name which: the allowed dependencies (arrows).

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use super::{code_by_module, read, root, sources};

/// The other modules that each module may name.
const MAY_NAME: &str = include_str!("arrows.csv");

/// The rows of that list.
fn may_name() -> Vec<(&'static str, Vec<&'static str>)> {
    let rows = MAY_NAME.lines().skip(1).filter_map(|row| row.split_once(','));
    rows.map(|(module, named)| (module, named.split_whitespace().collect())).collect()
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

/// The other modules that each module of a crate's sources names.
fn named_by_module(sources: &Path) -> BTreeMap<String, BTreeSet<String>> {
    let named = |(module, files): (String, Vec<(PathBuf, String)>)| {
        let mut named: BTreeSet<String> =
            files.iter().flat_map(|(_, code)| named_modules(code)).collect();
        named.remove(&module);
        (module, named)
    };
    code_by_module(sources).into_iter().map(named).collect()
}

/// Law: the list has each module that there is and no other, and of each the modules that it names and no other. Oracle:
/// the sources.
#[test]
fn the_list_of_arrows_is_that_of_the_sources() {
    let sources = named_by_module(&sources());
    let listed = may_name().into_iter().map(|(module, named)| {
        let others = named.iter().filter(|name| **name != module);
        (module.to_string(), others.map(|name| name.to_string()).collect())
    });
    let listed: BTreeMap<String, BTreeSet<String>> = listed.collect();
    for (module, named) in &sources {
        let list = listed.get(module);
        assert!(list == Some(named), "src/{module} names {named:?}, and the list has {list:?}");
    }
    assert_eq!(listed.len(), sources.len(), "the list has modules that are gone");
}

/// Law: the list of arrows has no circle, and the order in `src/lib.rs` is the one that follows from it: each
/// module is in the first line below all modules that it may name. Oracle: the list, sorted topologically (a
/// module in a circle would never get a line).
#[test]
fn the_arrows_have_no_circle_and_the_library_shows_their_order() {
    let mut rest = may_name();
    let (mut placed, mut lines) = (BTreeSet::new(), Vec::new());
    while !rest.is_empty() {
        let is_free = |(module, named): &(&str, Vec<&str>)| {
            named.iter().all(|name| name == module || placed.contains(name))
        };
        let (free, bound): (Vec<_>, Vec<_>) = rest.into_iter().partition(is_free);
        assert!(!free.is_empty(), "these modules name each other in a circle: {bound:?}");
        let line: BTreeSet<&str> = free.into_iter().map(|(module, _)| module).collect();
        lines.push(format!("//! {}\n", line.iter().copied().collect::<Vec<_>>().join(", ")));
        placed.extend(line);
        rest = bound;
    }
    let order = lines.concat();
    let text = read(&sources().join("lib.rs"));
    assert!(text.contains(&format!("```text\n{order}//! ```")), "src/lib.rs must show:\n{order}");
}

/// Modules as a table of `ARCHITECTURE.md` orders them: its rows, from top to bottom. `title` is that of their column.
fn rows_of_modules(title: &str) -> Vec<Vec<String>> {
    let page = read(&root().join("ARCHITECTURE.md"));
    let (_, rest) = page.split_once(&format!("| {title} |")).expect("the table of modules");
    let rows = rest.lines().skip(2).take_while(|line| line.starts_with('|'));
    let first_cell = |row: &str| row.split('|').nth(1).expect("a cell").to_owned();
    let names = |cell: String| cell.split('`').skip(1).step_by(2).map(str::to_owned).collect();
    rows.map(first_cell).map(names).collect()
}

/// Checks that the table has each module of these sources once, and that each names only modules of lower rows.
fn obey_the_table(sources: &Path, title: &str) {
    let (modules, rows) = (named_by_module(sources), rows_of_modules(title));
    let row_of = |name: &str| rows.iter().position(|row| row.iter().any(|module| module == name));
    let mut on_page: Vec<&String> = rows.iter().flatten().collect();
    on_page.sort();
    assert_eq!(on_page, modules.keys().collect::<Vec<_>>(), "each module is there once");
    for (module, named) in &modules {
        for other in named {
            let is_lower = row_of(other) > row_of(module);
            assert!(is_lower, "ARCHITECTURE.md: {module} names {other}, which is not below it");
        }
    }
}

/// Law: the architecture page has each module once, and a module names only those of lower rows.
/// Oracle: the sources.
#[test]
fn the_architecture_page_orders_the_modules() {
    obey_the_table(&sources(), "modules");
}

/// Law: the same of the window's modules. Oracle: the sources.
#[test]
fn the_architecture_page_orders_the_modules_of_the_window() {
    obey_the_table(&root().join("inspector/src"), "modules of the window");
}

#[test]
fn only_the_mathematics_names_glam() {
    for (module, files) in code_by_module(&sources()) {
        for (path, code) in files {
            let names = code.contains("glam::") || code.contains("use glam");
            assert!(module == "math" || !names, "src/{}: names glam", path.display());
        }
    }
}
