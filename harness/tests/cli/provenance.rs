//! What the files of `render` say of their own making, and `-` in the place of a file.

use std::io::Write;
use std::path::Path;
use std::process::{Command, Stdio};

use formats::images;
use groundtruth::film::read_exr;

use super::{GROUNDTRUTH, Run, files_in, run_in};

const SMALL: &[&str] = &["--size", "12x8", "--samples", "4", "--seed", "7"];

/// The arguments of a small rendering into a file.
fn small<'a>(scene: &'a str, file: &'a str, more: &[&'a str]) -> Vec<&'a str> {
    [&["render", scene, "-o", file][..], SMALL, more].concat()
}

/// The bytes of a file that was rendered in this folder.
fn rendered(folder: &Path, arguments: &[&str], file: &str) -> Vec<u8> {
    let run = run_in(folder, arguments);
    assert_eq!(run.status, Some(0), "{arguments:?}: {}", run.stderr);
    std::fs::read(folder.join(file)).expect("it was written")
}

/// Where these bytes are.
fn at(bytes: &[u8], part: &[u8]) -> Option<usize> {
    bytes.windows(part.len()).position(|window| window == part)
}

/// Runs the program with an input; the output may be no text.
fn run_with_input(
    folder: &Path,
    arguments: &[&str],
    input: &[u8],
) -> (Option<i32>, Vec<u8>, String) {
    let mut child = Command::new(GROUNDTRUTH)
        .current_dir(folder)
        .args(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("it starts");
    // it may end without reading all
    let _ = child.stdin.take().expect("piped").write_all(input);
    let output = child.wait_with_output().expect("it ends");
    let stderr = String::from_utf8(output.stderr).expect("UTF-8");
    (output.status.code(), output.stdout, stderr)
}

/// Law: a PNG file has its making as text chunks and its gamma, before the data; our reader, which checks every
/// checksum, reads it. Oracle: the layout of a chunk, by hand.
#[test]
fn a_png_file_says_how_it_was_made() {
    let folder = tempfile::tempdir().expect("a folder");
    let more = ["--tracer", "whitted", "--max-depth", "3"];
    let bytes = rendered(folder.path(), &small("ch28/glass-sphere", "a.png", &more), "a.png");
    let data = at(&bytes, b"IDAT").expect("it has data");
    let version = format!("Software\0groundtruth {}", env!("CARGO_PKG_VERSION"));
    for text in [
        &*version,
        "Scene\0ch28/glass-sphere",
        "Size\x0012x8",
        "Samples\x004",
        "Seed\x007",
        "Tracer\0whitted",
        "MaxDepth\x003",
    ] {
        let chunk = [&(text.len() as u32).to_be_bytes()[..], b"tEXt", text.as_bytes()].concat();
        assert!(at(&bytes, &chunk).is_some_and(|at| at < data), "{text:?}");
    }
    // gamma 1, as in the book: the values are radiance to the power 1
    let gamma = [&4_u32.to_be_bytes()[..], b"gAMA", &100_000_u32.to_be_bytes()].concat();
    assert_eq!(at(&bytes, &gamma), Some(33));
    let texels = images::decode(&bytes, None, 1000).expect("it is a PNG file");
    assert_eq!([texels.width(), texels.height()], [12, 8]);
}

/// Law: gamma 2.2 of a scene is 1/2.2 in its PNG file, and `render` says so; a name that is no ASCII is
/// UTF-8 text, without characters that end it; a scene that says nothing is named by its digest.
#[test]
fn gamma_and_names_are_written_as_png_wants_them() {
    let folder = tempfile::tempdir().expect("a folder");
    let export = run_in(folder.path(), &["export", "ch03/single-sphere"]).stdout;
    let (about, rest) = export.split_once('\n').expect("its first line says what it is");
    assert!(about.starts_with("about = ") && rest.contains("gamma = 1.0"), "{export}");
    let scene = rest.replace("gamma = 1.0", "gamma = 2.2");
    let named = format!("about = \"eine Kügel\\u0000\"\n{scene}");
    std::fs::write(folder.path().join("a.toml"), named).expect("written");
    std::fs::write(folder.path().join("unnamed.toml"), scene).expect("written");
    let arguments = small("a.toml", "a.png", &[]);
    let bytes = rendered(folder.path(), &arguments, "a.png");
    let gamma = [&4_u32.to_be_bytes()[..], b"gAMA", &45_455_u32.to_be_bytes()].concat();
    assert_eq!(at(&bytes, &gamma), Some(33));
    assert!(at(&bytes, "iTXtScene\0\0\0\0\0eine Kügel\\u{0}".as_bytes()).is_some());
    images::decode(&bytes, None, 1000).expect("it is a PNG file");
    let unnamed = rendered(folder.path(), &small("unnamed.toml", "b.png", &[]), "b.png");
    assert!(at(&unnamed, b"tEXtScene\0sha256:").is_some());
    let said = run_in(folder.path(), &arguments).stderr;
    assert!(said.contains("radiance to the power 1/2.2; the file says so (gAMA)"), "{said}");
    let said = run_in(folder.path(), &small("a.toml", "a.ppm", &[])).stderr;
    assert!(
        said.contains("radiance to the power 1/2.2; compare with --encoding gamma=2.2"),
        "{said}"
    );
    let said = run_in(folder.path(), &small("a.toml", "a.exr", &[])).stderr;
    assert!(said.contains("a.exr: values are linear radiance"), "{said}");
}

/// Law: an EXR file has the same as attributes of type string, and is read as before: the pixels are those of the
/// picture. Oracle: the layout of an attribute, by hand; a PFM file, which has no attributes.
#[test]
fn an_exr_file_says_how_it_was_made() {
    let folder = tempfile::tempdir().expect("a folder");
    let bytes = rendered(folder.path(), &small("ch28/glass-sphere", "a.exr", &[]), "a.exr");
    for (name, text) in
        [("scene", "ch28/glass-sphere"), ("size", "12x8"), ("samples", "4"), ("seed", "7")]
    {
        let length = (text.len() as u32).to_le_bytes();
        let attribute = [format!("{name}\0string\0").as_bytes(), &length, text.as_bytes()].concat();
        assert!(at(&bytes, &attribute).is_some(), "{name}");
    }
    let film = read_exr(&folder.path().join("a.exr")).expect("it is an EXR file");
    let pfm = rendered(folder.path(), &small("ch28/glass-sphere", "a.pfm", &[]), "a.pfm");
    let texels = images::decode(&pfm, None, 1000).expect("it is a PFM file");
    assert!(film.to_f32().eq(texels.colors().iter().copied()));
}

/// Law: equal pictures are equal files: of the gallery, of its exported scene in any folder under any name, on any number
/// of threads, at another time; and a file of
/// another making is another file, though the pixels are the same. Oracle: the bytes.
#[test]
fn equal_pictures_are_equal_files() {
    let folders = [tempfile::tempdir().expect("a folder"), tempfile::tempdir().expect("a folder")];
    let export = run_in(folders[0].path(), &["export", "ch14/page-one"]).stdout;
    let changed = export.replace("ls = 3.0", "ls = 2.0");
    assert_ne!(changed, export);
    for (folder, name) in folders.iter().zip(["page.toml", "other.toml"]) {
        std::fs::write(folder.path().join(name), &export).expect("written");
        std::fs::write(folder.path().join(format!("changed-{name}")), &changed).expect("written");
    }
    for file in ["a.png", "a.exr"] {
        let of = |index: usize, threads, name: &str| {
            let folder: &Path = folders[index].path();
            let path = folder.join(name).display().to_string();
            rendered(folder, &small(&path, file, &["--threads", threads]), file)
        };
        let one = of(0, "1", "page.toml");
        assert!(one == of(1, "2", "other.toml"), "{file}");
        assert!(
            one == rendered(folders[0].path(), &small("ch14/page-one", file, &[]), file),
            "{file}"
        );
        assert!(at(&one, b"ch14/page-one").is_some(), "{file}");
        let changed = of(0, "2", "changed-page.toml");
        assert!(changed == of(1, "1", "changed-other.toml"), "{file}");
        assert!(at(&changed, b"ch14/page-one").is_none(), "{file}: it is another scene");
        let arguments = ["render", "ch03/single-sphere", "-o", file, "--size", "9x9", "--seed"];
        let [a, b] = ["1", "2"]
            .map(|seed| rendered(folders[0].path(), &[&arguments[..], &[seed]].concat(), file));
        assert!(a != b, "{file}: the seed is not in it");
    }
}

/// Law: `-` is the standard output for a picture, with the bytes of the file, and the standard input for a scene and a
/// picture. Oracle: the same with files.
#[test]
fn a_dash_is_standard_input_or_output() {
    let folder = tempfile::tempdir().expect("a folder");
    let export = run_in(folder.path(), &["export", "ch03/three-objects", "-o", "-"]).stdout;
    let same = run_in(folder.path(), &["export", "ch03/three-objects"]).stdout;
    assert_eq!(export, same);
    for (format, file) in [("png", "a.png"), ("exr", "a.exr"), ("ppm", "a.ppm"), ("pfm", "a.pfm")] {
        let expected = rendered(folder.path(), &small("ch03/three-objects", file, &[]), file);
        let arguments = small("ch03/three-objects", "-", &["--format", format]);
        let (status, stdout, stderr) = run_with_input(folder.path(), &arguments, b"");
        assert_eq!(status, Some(0), "{stderr}");
        assert!(stdout == expected, "{format}");
    }
    let piped = small("-", "b.pfm", &[]);
    let (status, _, stderr) = run_with_input(folder.path(), &piped, export.as_bytes());
    assert_eq!(status, Some(0), "{stderr}");
    let [a, b] =
        ["a.pfm", "b.pfm"].map(|file| std::fs::read(folder.path().join(file)).expect("there"));
    assert!(a == b);
    let (status, stdout, stderr) = run_with_input(folder.path(), &["compare", "-", "a.pfm"], &a);
    assert_eq!(status, Some(0), "{stderr}{}", String::from_utf8_lossy(&stdout));
    let mut files = files_in(folder.path());
    files.sort();
    assert_eq!(files, ["a.exr", "a.pfm", "a.png", "a.ppm", "b.pfm"]);
    let Run { status, stderr, .. } = run_in(folder.path(), &small("ch03/three-objects", "-", &[]));
    assert_eq!(status, Some(2));
    assert_eq!(
        stderr,
        "error: -o -: say which format is written to the standard output: --format png, ppm, exr, pfm\n"
    );
}
