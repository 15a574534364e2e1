//! The pictures that `merge` writes: what they say of their making.

use super::{SCENE, expect, parts};
use crate::kit::{Folder, position};

/// An attribute of an EXR file: name, type, length and text.
fn attribute(name: &str, text: &str) -> Vec<u8> {
    let length = (text.len() as u32).to_le_bytes();
    [format!("{name}\0string\0").as_bytes(), &length, text.as_bytes()].concat()
}

fn has(bytes: &[u8], part: &[u8]) -> bool {
    position(bytes, part).is_some()
}

/// Law: the pictures say scene, size, samples, tracer, and which replicas they are of; of the standard error, that it is
/// one. Oracle: the layout of an attribute, by hand; the scene.
#[test]
fn merged_pictures_say_how_they_were_made() {
    let at = &Folder::new();
    let files = parts(at, "a", 3, 7);
    let all = files.join(" ");
    expect(0, at, &format!("merge {all} -o mean.exr --standard-error error.exr"));
    let scene = gallery::find("ch18/rectangle").map(|entry| (entry.build)()).expect("listed");
    let tracer = scene.tracer.name();
    let [mean, error] = ["mean.exr", "error.exr"].map(|file| at.bytes(file));
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
    assert!(has(&at.bytes("two.exr"), &attribute("seeds", "1 to 2, 5 to 7")));
    // merged in two steps, and of a scene file with the same content
    expect(0, at, "export ch18/rectangle -o same.toml");
    let same = SCENE.replace("ch18/rectangle", "same.toml");
    expect(0, at, &format!("render {same} --seed 3 --replicas 2 -o b.sums"));
    expect(1, at, &format!("merge b.sums {} -o b2.sums", files[0]));
    expect(0, at, &format!("merge b2.sums {} -o again.exr", files[2]));
    assert!(at.bytes("again.exr") == mean, "equal pictures are equal files");
}
