//! Which module of the window may name which.

use std::collections::BTreeSet;

use super::arrows::named_modules;
use super::{code_by_module, root, rows_of_modules};

/// Law: the architecture page has each module of the window once, and each names only modules of lower rows. Oracle: the
/// sources.
#[test]
fn the_modules_of_the_window_name_only_those_below_them() {
    let modules = code_by_module(&root().join("inspector/src"));
    let rows = rows_of_modules("modules of the window");
    let row_of = |name: &str| rows.iter().position(|row| row.iter().any(|module| module == name));
    assert_eq!(rows.iter().flatten().count(), modules.len(), "each module is there once");
    for (module, files) in &modules {
        let row = row_of(module);
        assert!(row.is_some(), "ARCHITECTURE.md has no module {module} of the window");
        for (path, code) in files {
            let named: BTreeSet<String> = named_modules(code);
            for other in named.iter().filter(|other| *other != module) {
                let is_lower = row_of(other) > row;
                assert!(
                    is_lower,
                    "{}: {module} names {other}, which is not below it",
                    path.display()
                );
            }
        }
    }
}
