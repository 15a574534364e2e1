//! The pictures that `merge` writes: what they say of their making, and `-` in the place of a file.

use super::{SCENE, command, expect, parts, read, run};

/// An attribute of an EXR file: name, type, length and text.
fn attribute(name: &str, text: &str) -> Vec<u8> {
    let length = (text.len() as u32).to_le_bytes();
    [format!("{name}\0string\0").as_bytes(), &length, text.as_bytes()].concat()
}

fn has(bytes: &[u8], part: &[u8]) -> bool {
    bytes.windows(part.len()).any(|window| window == part)
}

/// Law: the pictures say scene, size, samples, tracer, and which replicas they are of; of the standard error, that it is
/// one. Oracle: the layout of an attribute, by hand; the scene.
#[test]
fn merged_pictures_say_how_they_were_made() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = folder.path();
    let files = parts(at, "a", 3, 7);
    let all = files.join(" ");
    expect(0, at, &format!("merge {all} -o mean.exr --standard-error error.exr"));
    let scene = gallery::find("ch18/rectangle").map(|entry| (entry.build)()).expect("listed");
    let tracer = scene.tracer.name();
    let [mean, error] = ["mean.exr", "error.exr"].map(|file| read(at, file));
    for (name, text) in [
        ("scene", "ch18/rectangle"),
        ("size", "12x8"),
        ("samples", "4"),
        ("replicas", "7"),
        ("seeds", "1 to 7"),
        ("tracer", tracer),
    ] {
        let attribute = attribute(name, text);
        assert!(has(&mean, &attribute) && has(&error, &attribute), "{name}");
    }
    let part = attribute("part", "standard error");
    assert_eq!([has(&mean, &part), has(&error, &part)], [false, true]);
    assert!(!has(&mean, b"\0seed\0string\0"), "it has no single seed");
    expect(1, at, &format!("merge {} {} -o two.exr", files[0], files[2]));
    assert!(has(&read(at, "two.exr"), &attribute("seeds", "1 to 2, 5 to 7")));
    // merged in two steps, and of a scene file with the same content
    let export = run(at, "export ch18/rectangle -o same.toml");
    assert_eq!(export.status, Some(0), "{}", export.stderr);
    let same = SCENE.replace("ch18/rectangle", "same.toml");
    expect(0, at, &format!("render {same} --seed 3 --replicas 2 -o b.sums"));
    expect(1, at, &format!("merge b.sums {} -o b2.sums", files[0]));
    expect(0, at, &format!("merge b2.sums {} -o again.exr", files[2]));
    assert!(read(at, "again.exr") == mean, "equal pictures are equal files");
}

/// Law: `-` is the standard output, with the bytes of the file and no word among them; what cannot go there, or come
/// from the standard input, is refused. Oracle: the files.
#[test]
fn a_dash_is_the_standard_output() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = folder.path();
    let all = parts(at, "a", 2, 4).join(" ");
    expect(0, at, &format!("merge {all} -o mean.exr --standard-error error.pfm"));
    for (line, file) in [
        ("-o - --format exr", "mean.exr"),
        ("-o other.exr --standard-error - --format pfm", "error.pfm"),
    ] {
        let output = command(at, &format!("merge {all} {line}")).output().expect("it starts");
        assert_eq!(output.status.code(), Some(0), "{line}");
        assert!(output.stdout == read(at, file), "{line}");
        assert!(String::from_utf8_lossy(&output.stderr).contains("4 of 4 replicas"), "{line}");
    }
    for (line, problem) in [
        (format!("{all} -o -"), "--format exr or pfm"),
        (format!("{all} -o - --format png"), "write exr or pfm"),
        (format!("{all} -o - --standard-error - --format exr"), "the standard output is one file"),
        ("- -o mean.exr".to_owned(), "write the standard input to a file, and name that"),
    ] {
        let run = expect(2, at, &format!("merge {line}"));
        assert!(run.stderr.contains(problem), "{line}: {}", run.stderr);
    }
}
