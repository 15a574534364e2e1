//! The commands of the README share one build of each crate.

use std::collections::{BTreeMap, BTreeSet};
use std::process::Command;

use serde_json::Value;

/// The README's commands, as builds.
const COMMANDS: [&[&str]; 5] = [
    &["build", "--bin", "groundtruth"],
    &["build", "--bin", "inspector"],
    &["build", "--example", "sphere"],
    &["chapter"],
    &["test", "--workspace"],
];

/// For each crate that a command builds, in which ways: features and profile, without its name.
fn units(command: &[&str]) -> BTreeMap<String, BTreeSet<String>> {
    let built = Command::new(env!("CARGO"))
        .args(command)
        .args(["--unit-graph", "-Z", "unstable-options", "--offline"])
        .current_dir(super::root())
        // the graph of units is not stable
        .env("RUSTC_BOOTSTRAP", "1")
        .output()
        .expect("cargo starts");
    assert!(built.status.success(), "{}", String::from_utf8_lossy(&built.stderr));
    let graph: Value = serde_json::from_slice(&built.stdout).expect("it is JSON");
    let mut all: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    for unit in graph["units"].as_array().expect("a list") {
        let kind = unit["target"]["kind"][0].as_str().unwrap_or_default();
        if unit["mode"] == "build" && ["lib", "rlib", "proc-macro"].contains(&kind) {
            let mut profile = unit["profile"].clone();
            profile["name"].take();
            // proc macros and what they use are built for the compiler
            let name = format!("{} {}", unit["pkg_id"], unit["platform"]);
            all.entry(name).or_default().insert(format!("{} {profile}", unit["features"]));
        }
    }
    all
}

/// Law: each crate has the same features and profile whichever command of the README builds it. Oracle: cargo's own plan.
#[test]
fn commands_share_one_build_of_each_crate() {
    let all = COMMANDS.map(units);
    let tests = &all[all.len() - 1];
    let mut shared = 0;
    for (command, units) in COMMANDS.iter().zip(&all) {
        for (name, ways) in units {
            let of_tests = tests.get(name);
            assert_eq!(of_tests, Some(ways), "cargo {}: {name}", command.join(" "));
            shared += 1;
        }
    }
    assert!(shared > 500, "only {shared} crates of commands were found");
}
