//! Damaged files, and faulty machines.

use xxhash_rust::xxh3::xxh3_128;

use super::{SCENE, expect, parts};
use crate::kit::Folder;

/// Where the sums begin: after two lines.
fn body(bytes: &[u8]) -> usize {
    let ends = (0..bytes.len()).filter(|at| bytes[*at] == b'\n');
    ends.take(2).last().expect("two lines") + 1
}

/// Law: a changed byte in the header, the sums or the digest is found, also in a part that is left out, and the file is
/// named; so is a file that is cut or continued. Oracle: the change.
#[test]
fn each_changed_byte_is_found() {
    let at = &Folder::new();
    parts(at, "a", 2, 4);
    let good = at.bytes("a1.sums");
    let header = body(&good);
    let end = good.len() - 16;
    let mut places: Vec<usize> = (0..header).step_by(7).collect();
    places.extend([header - 1, header, header + 55, (header + end) / 2, end - 1]);
    places.extend([end, end + 15]);
    for place in places {
        let mut bad = good.clone();
        bad[place] ^= 1;
        check(at, &bad, &format!("byte {place}"));
    }
    check(at, &good[..good.len() - 1], "cut");
    check(at, &[good.as_slice(), &[0]].concat(), "continued");
    check(at, b"", "empty");
    check(at, b"groundtruth sums 1\n\n", "another format");
}

fn check(at: &Folder, bad: &[u8], what: &str) {
    at.write("bad.sums", bad);
    for others in ["a0.sums", "a0.sums a1.sums"] {
        let run = expect(2, at, &format!("merge {others} bad.sums -o mean.exr"));
        assert!(run.stderr.starts_with("error: bad.sums: is damaged"), "{what}: {}", run.stderr);
        assert!(!at.path().join("mean.exr").exists());
    }
    expect(2, at, &format!("render {SCENE} --seed 1 --replicas 4 --part 1/2 -o bad.sums"));
    assert_eq!(at.bytes("bad.sums"), bad, "a damaged file is left as it is");
}

/// The bytes of a part with another sum at a pixel, as a faulty machine would write them.
fn faulty(good: &[u8], pixel: usize) -> Vec<u8> {
    let mut bad = good[..good.len() - 16].to_vec();
    bad[body(good) + 168 * pixel + 9] ^= 4;
    bad.extend(xxh3_128(&bad).to_le_bytes());
    bad
}

/// Law: a part of a faulty machine is found if the same part comes from another machine too. Oracle: the planted difference.
#[test]
fn a_faulty_machine_is_found() {
    let at = &Folder::new();
    parts(at, "a", 2, 4);
    // pixel 5, 3 of 12 columns
    at.write("bad.sums", faulty(&at.bytes("a1.sums"), 3 * 12 + 5));
    let run = expect(1, at, "merge a0.sums a1.sums bad.sums -o mean.exr");
    let text = "error: bad.sums and a1.sums have the same seeds 3 to 4 but differ at pixel 5, 3: one of the \
                machines is faulty; render them a third time to see which\n";
    assert_eq!(run.stderr, text);
    assert!(!at.path().join("mean.exr").exists());
}
