//! The example in Python of docs/probe.md, for those who installed the command as the README says.

use std::path::Path;

use crate::kit::{Folder, GROUNDTRUTH, has, text_of};

/// Law: the example runs as it stands, and finds nothing; with a sphere that is a little too large it finds rays.
/// Oracle: what it prints.
#[test]
fn the_example_in_python_compares_spheres() {
    if !has("python3") {
        return;
    }
    let document = text_of("docs/probe.md");
    let (_, rest) = document.split_once("```python\n").expect("an example in Python");
    let (program, _) = rest.split_once("```").expect("its end");
    let wrong = program.replace("- r * r", "- 1.001 * r * r");
    assert_ne!(wrong, program);
    let folder = Folder::new();
    folder.write("right.py", program);
    folder.write("wrong.py", wrong);
    assert_eq!(folder.good("python3 right.py").trim_end(), "1000 rays compared");
    let lines = folder.run("python3 wrong.py").stdout.lines().count();
    assert!(lines > 100, "only {lines} lines");
}

/// Law: the README says where the command is that its builds leave. Oracle: the program that is tested.
#[test]
fn the_readme_says_where_the_command_is() {
    let readme = text_of("README.md");
    let (_, rest) = readme.split_once("the command in `").expect("a sentence");
    let said = Path::new(rest.split('`').next().expect("a path"));
    assert_eq!(said.file_stem(), Path::new(GROUNDTRUTH).file_stem());
    assert_eq!(said.parent(), Some(Path::new("target/debug")));
}
