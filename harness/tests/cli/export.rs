//! Scenes with a mesh file, exported to another folder: they still find the file and give the same picture.

use std::fs;
use std::path::Path;

use super::run_in;

const SCENE: &str = r#"
background = 0.5
[image]
width = 12
height = 12
[camera]
eye = [0, 0, 5]
lens = { pinhole = { distance = 8 } }
[[materials]]
name = "red"
recipe = { matte = { ka = 0.5, cd = [1, 0, 0] } }
[[lights]]
name = "everywhere"
source = { ambient = { color = 1, ls = 1 } }
[[objects]]
name = "knot"
material = "red"
shape = { mesh = { file = "meshes/knot.ply", scale = 0.5 } }
"#;

/// A folder with `scenes/first.toml` and its mesh in `scenes/meshes`.
fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    let meshes = folder.path().join("scenes/meshes");
    fs::create_dir_all(&meshes).expect("a folder");
    fs::create_dir(folder.path().join("other")).expect("a folder");
    let knot = concat!(env!("CARGO_MANIFEST_DIR"), "/../scenes/knot.ply");
    fs::copy(knot, meshes.join("knot.ply")).expect("it is there");
    fs::write(folder.path().join("scenes/first.toml"), SCENE).expect("it can be written");
    folder
}

fn good(folder: &Path, arguments: &[&str]) -> String {
    let run = run_in(folder, arguments);
    assert_eq!(run.status, Some(0), "{arguments:?}: {}", run.stderr);
    run.stdout
}

/// The bytes of a scene's picture file.
fn picture(folder: &Path, scene: &str) -> Vec<u8> {
    let file = folder.join("picture.exr");
    good(folder, &["render", scene, "-o", &file.to_string_lossy()]);
    fs::read(file).expect("it was written")
}

/// Law: an edited scene is not lost: export leaves a file that exists as it is, unless told to replace it.
#[test]
fn an_edited_scene_is_replaced_only_on_request() {
    let folder = folder();
    let edited = folder.path().join("edited.toml");
    fs::write(&edited, "mine").expect("it can be written");
    let export = ["export", "ch03/single-sphere", "-o", "edited.toml"];
    let run = run_in(folder.path(), &export);
    assert_eq!(run.status, Some(2), "{}", run.stderr);
    let expected =
        "error: edited.toml: exists already; write to another file, or replace it with --replace\n";
    assert_eq!(run.stderr, expected);
    assert_eq!(fs::read_to_string(&edited).expect("it is there"), "mine");
    good(folder.path(), &[&export[..], &["--replace"]].concat());
    let text = fs::read_to_string(&edited).expect("it is there");
    assert_eq!(text, good(folder.path(), &export[..2]));
}

/// Law: the picture is the same from any folder, and the name in the file is the shortest relative path.
/// Oracle: the picture of the original scene, and the names by hand.
#[test]
fn an_exported_mesh_is_found_from_the_new_folder() {
    let folder = folder();
    let expected = picture(folder.path(), "scenes/first.toml");
    for (here, from, to, name) in [
        ("scenes", "first.toml", "second.toml", "meshes/knot.ply"),
        ("scenes", "first.toml", "../other/second.toml", "../scenes/meshes/knot.ply"),
        (".", "scenes/first.toml", "second.toml", "scenes/meshes/knot.ply"),
        ("other", "../scenes/../scenes/first.toml", "second.toml", "../scenes/meshes/knot.ply"),
        (".", "scenes/first.toml", "scenes/meshes/second.toml", "../meshes/knot.ply"),
    ] {
        let here = folder.path().join(here);
        assert_eq!(good(&here, &["export", from, "-o", to, "--replace"]), "");
        let text = fs::read_to_string(here.join(to)).expect("it was written");
        assert!(text.contains(&format!("\"{name}\"")), "{from} to {to}:\n{text}");
        assert!(picture(&here, to) == expected, "{from} to {to}");
    }
}

/// Law: on standard output the mesh's name is absolute, also if the scene is named without its folder.
#[test]
fn a_mesh_on_the_standard_output_has_an_absolute_name() {
    let folder = folder();
    let scenes = folder.path().join("scenes");
    let text = good(&scenes, &["export", "first.toml"]);
    fs::write(folder.path().join("other/second.toml"), text).expect("it can be written");
    let expected = picture(&scenes, "first.toml");
    assert!(picture(folder.path(), "other/second.toml") == expected);
}

/// Law: `..` after a symbolic link leads to the parent of the folder that the link points to.
#[test]
#[cfg(unix)]
fn an_exported_mesh_is_found_through_symbolic_links() {
    let folder = folder();
    let at = |path: &str| folder.path().join(path);
    fs::create_dir_all(at("deep/er")).expect("a folder");
    std::os::unix::fs::symlink(at("deep/er"), at("short")).expect("a link");
    std::os::unix::fs::symlink(at("scenes"), at("deep/linked")).expect("a link");
    let expected = picture(folder.path(), "scenes/first.toml");
    good(folder.path(), &["export", "deep/linked/first.toml", "-o", "short/second.toml"]);
    assert!(picture(folder.path(), "short/second.toml") == expected);
    assert!(picture(folder.path(), "deep/er/second.toml") == expected);
}

/// Law: no output is written over a file that the scene is read from, in any format and by any path, also with
/// --replace, and not by a picture or a page. Oracle: the bytes of both files.
#[test]
fn no_file_of_the_scene_is_written_over() {
    let folder = folder();
    let at = folder.path().join("scenes");
    let files = ["meshes/knot.ply", "first.toml"].map(|name| at.join(name));
    let read = || files.each_ref().map(|file| fs::read(file).expect("there"));
    let before = read();
    for format in ["toml", "pov", "mitsuba"] {
        let without = ["--without", "ambient"];
        for output in ["meshes/knot.ply", "../scenes/meshes/knot.ply", "first.toml"] {
            let line = ["export", "first.toml", "--format", format, "--replace", "-o", output];
            let run = run_in(&at, &[&line[..], &without].concat());
            assert_eq!(run.status, Some(2), "{format} {output}: {}", run.stdout);
            assert_eq!(read(), before, "{format} {output}");
        }
    }
    let run = run_in(&at, &["export", "first.toml", "--replace", "-o", "meshes/knot.ply"]);
    assert!(run.stderr.contains("is read by this command, and would be lost"), "{}", run.stderr);
    let picture = ["render", "first.toml", "--format", "ppm", "-o", "meshes/knot.ply"];
    assert_eq!(run_in(&at, &picture).status, Some(2));
    good(&at, &["render", "first.toml", "-o", "a.pfm"]);
    for command in ["verify", "compare"] {
        let page = [command, "first.toml", "a.pfm", "-o", "meshes/knot.ply"];
        let run = run_in(&at, &page);
        assert_eq!(run.status, Some(2), "{command}: {}", run.stderr);
    }
    assert_eq!(read(), before);
}

/// Law: an export to Mitsuba whose file's name and description hold markup is well formed: the mesh is named with its
/// references, and no two hyphens stand in the comment. Oracle: the text that XML asks for.
#[test]
fn markup_in_names_and_descriptions_is_escaped() {
    let folder = folder();
    let at = folder.path().join("scenes");
    fs::write(at.join("second.toml"), format!("about = \"a --- b\"\n{SCENE}")).expect("written");
    let line = ["export", "second.toml", "--format", "mitsuba", "--without", "ambient"];
    let run = run_in(&at, &[&line[..], &["-o", "a&b.xml"]].concat());
    assert_eq!(run.status, Some(0), "{}", run.stderr);
    let text = fs::read_to_string(at.join("a&b.xml")).expect("written");
    let comment = text.split_once("<!--").and_then(|(_, rest)| rest.split_once("-->"));
    let (comment, rest) = comment.expect("a comment");
    assert!(comment.contains("a - - - b") && !comment.contains("--"), "{comment}");
    assert!(rest.contains("value=\"a&amp;b") && !rest.contains("a&b"), "{rest}");
}
