//! The command line of `laws`: its document, and programs to start from.

use claims::{Kind, Law};

use super::conform_adapters::Called;
use crate::kit::{Folder, has, root, text_of};

#[allow(dead_code, clippy::disallowed_methods)] // its `main`; its user may call any sine
#[path = "../../examples/laws/init.rs"]
mod init;

/// Law: the tables of docs/laws.md have every law. Oracle: the document.
#[test]
fn the_document_has_every_law() {
    let page = text_of("docs/laws.md");
    for law in Kind::ALL.into_iter().flat_map(Law::of) {
        let row = format!("| {} | {} | {} |", law.name, law.sentence, law.cause);
        assert!(page.contains(&row.replace("|cos θi|", "\\|cos θi\\|")), "no row for {}", law.name);
    }
}

/// Law: the programs to start from keep all laws as they are. Oracle: Lambert's lobe.
#[test]
fn programs_to_start_from_keep_all_laws() {
    let folder = Folder::new();
    let of_rust = folder.good("groundtruth laws --init rust");
    assert_eq!(of_rust, text_of("examples/laws/init.rs"));
    let mut rust = Called(init::reply);
    let lobes = claims::listed(&mut rust).expect("it lists its lobe");
    let options = claims::ClaimsOptions { cases: 2, seed: 1 };
    let card = claims::run(&mut rust, &lobes, options, &mut |_| ());
    assert!(!card.is_failed() && !card.rows.is_empty(), "{card}");
    for (language, file, compiler, compile, program) in [
        ("python", "my_bsdfs.py", "python3", "true", "python3 my_bsdfs.py"),
        ("cpp", "my_bsdfs.cpp", "c++", "c++ -std=c++17 -O1 -Wall -o mine my_bsdfs.cpp", "./mine"),
        ("java", "MyBsdfs.java", "javac", "javac -Xlint:all -Werror MyBsdfs.java", "java MyBsdfs"),
    ] {
        if has(compiler) {
            folder.good(&format!("groundtruth laws --init {language} > {file}; {compile}"));
            folder.good(&format!("groundtruth laws --cases 2 -- {program}"));
        }
    }
}

/// Law: each adapter of a program that people use is run by `scripts/law-cards.sh`, and named in the document of its card.
/// Oracle: the files.
#[test]
fn every_adapter_of_bsdfs_is_run_and_named() {
    let folder = root().join("examples/laws");
    let [script, document] = ["scripts/law-cards.sh", "docs/cards.md"].map(text_of);
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
