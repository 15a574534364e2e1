//! Which package may use which: the table of the architecture page, held to the manifests.

use std::path::Path;

use super::{read, root};

/// A row of the table: the package, its folder, and what it uses.
struct Row {
    name: String,
    folder: String,
    uses: Vec<String>,
}

/// The texts between backticks.
fn quoted(cell: &str) -> Vec<String> {
    cell.split('`').skip(1).step_by(2).map(str::to_owned).collect()
}

fn rows() -> Vec<Row> {
    let page = read(&root().join("ARCHITECTURE.md"));
    let (_, rest) = page.split_once("| package |").expect("the table of packages");
    let row = |line: &str| {
        let cells: Vec<&str> = line.split('|').collect();
        let folder = cells[2].split(['[', ']']).nth(1).expect("a link");
        let folder = folder.trim_end_matches("/cli").replace("src", ".");
        Row { name: quoted(cells[1]).concat(), folder, uses: quoted(cells[4]) }
    };
    rest.lines().skip(2).take_while(|line| line.starts_with('|')).map(row).collect()
}

/// The packages of the workspace that the manifest of a folder names as dependencies of the product.
fn used(folder: &Path, packages: &[String]) -> Vec<String> {
    let manifest: toml::Table = read(&folder.join("Cargo.toml")).parse().expect("a manifest");
    let dependencies = manifest["dependencies"].as_table().expect("a table");
    let mut names: Vec<_> = dependencies.keys().filter(|name| packages.contains(name)).collect();
    names.sort_unstable();
    names.into_iter().cloned().collect()
}

/// Law: a package uses those that its row names, which are all below it; no package is left out. Oracle: the manifests.
#[test]
fn packages_use_those_below_them() {
    let rows = rows();
    let names: Vec<String> = rows.iter().map(|row| row.name.clone()).collect();
    for (index, row) in rows.iter().enumerate() {
        let used = used(&root().join(&row.folder), &names);
        assert_eq!(used, row.uses, "what {} uses, and what its row says", row.name);
        let below = &names[index + 1..];
        let wrong: Vec<_> = used.iter().filter(|name| !below.contains(name)).collect();
        assert!(wrong.is_empty(), "{} is above {wrong:?}", row.name);
    }
    let workspace: toml::Table = read(&root().join("Cargo.toml")).parse().expect("a manifest");
    let members = workspace["workspace"]["members"].as_array().expect("a list");
    // the library itself is no member, the laws are no product
    let products =
        members.iter().filter(|it| !it.as_str().is_some_and(|it| it.starts_with("tests")));
    assert_eq!(products.count() + 1, rows.len());
}
