//! Damaged files, and faulty machines.

use std::fs;
use std::path::Path;

use xxhash_rust::xxh3::xxh3_128;

use super::{SCENE, expect, parts, read};

/// Law: a changed byte in the header, the sums, the list of values that are not finite or the digest is found, also
/// in a part that is left out, and the file is named; so is a file that is cut or continued. Oracle: the change.
#[test]
fn each_changed_byte_is_found() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = folder.path();
    parts(at, "a", 2, 4);
    parts(at, "whole", 1, 4);
    let good = read(at, "a1.sums");
    let header = good.windows(2).position(|two| two == b"\n\n").expect("an empty line") + 2;
    let end = good.len() - 16;
    let mut places: Vec<usize> = (0..header).step_by(7).collect();
    places.extend([header - 1, header, header + 47, (header + end) / 2, end - 1]);
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

/// Law: in a part of several blocks a changed byte of the last one is found, and so are blocks that changed places.
/// Oracle: the change.
#[test]
fn blocks_that_changed_places_are_found() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = folder.path();
    expect(0, at, "render ch18/rectangle --size 80x80 --samples 1 --replicas 1 -o a.sums");
    expect(0, at, "merge a.sums -o mean.exr");
    let good = read(at, "a.sums");
    let header = good.windows(2).position(|two| two == b"\n\n").expect("an empty line") + 2;
    let (body, block) = (good.len() - header - 16, 4096 * 48);
    assert!(body > 2 * block, "several blocks");
    let mut changed = good.clone();
    changed[header + body - 1] ^= 1;
    let mut exchanged = good.clone();
    let (first, rest) = exchanged[header..].split_at_mut(block);
    first.swap_with_slice(&mut rest[..block]);
    assert!(exchanged != good, "the blocks are equal: the law holds of nothing");
    for bad in [changed, exchanged] {
        fs::write(at.join("bad.sums"), bad).expect("written");
        let run = expect(2, at, "merge bad.sums -o mean.exr");
        assert!(run.stderr.starts_with("error: bad.sums: is damaged"), "{}", run.stderr);
    }
}

fn check(at: &Path, bad: &[u8], what: &str) {
    fs::write(at.join("bad.sums"), bad).expect("written");
    for others in ["a0.sums", "a0.sums a1.sums", "whole0.sums"] {
        let run = super::run(at, &format!("merge {others} bad.sums -o mean.exr"));
        assert_eq!(run.status, Some(2), "{what}: {}{}", run.stdout, run.stderr);
        assert!(run.stderr.starts_with("error: bad.sums: is damaged"), "{what}: {}", run.stderr);
        assert!(!at.join("mean.exr").exists());
    }
    expect(2, at, &format!("render {SCENE} --seed 1 --replicas 4 --part 1/2 -o bad.sums"));
    assert_eq!(read(at, "bad.sums"), bad, "a damaged file is left as it is");
}

/// The bytes of a part with another sum at a pixel, as a faulty machine would write them.
fn faulty(good: &[u8], pixel: usize) -> Vec<u8> {
    let header = good.windows(2).position(|two| two == b"\n\n").expect("an empty line") + 2;
    let mut bad = good[..good.len() - 16].to_vec();
    bad[header + 144 * pixel + 9] ^= 4;
    // its 288 channels are one block; the list is empty
    let digests = [&bad[..header], &bad[header..], &[]].map(|bytes| xxh3_128(bytes).to_le_bytes());
    bad.extend(xxh3_128(digests.as_flattened()).to_le_bytes());
    bad
}

/// Law: a part of a faulty machine is found if the same part comes from another machine too, and by an audit of all
/// rows, which names it; an audit of right parts finds nothing. Oracle: the planted difference.
#[test]
fn a_faulty_machine_is_found() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = folder.path();
    parts(at, "a", 2, 4);
    let run = expect(0, at, "merge a0.sums a1.sums -o mean.exr --audit 1");
    assert!(run.stderr.is_empty(), "{}", run.stderr);
    fs::remove_file(at.join("mean.exr")).expect("it was written");
    // pixel 5, 3 of 12 columns
    fs::write(at.join("bad.sums"), faulty(&read(at, "a1.sums"), 3 * 12 + 5)).expect("written");
    let run = expect(1, at, "merge a0.sums a1.sums bad.sums -o mean.exr");
    let text = "error: bad.sums and a1.sums have the same seeds 3 to 4 but differ at pixel 5, 3: one of the \
                machines is faulty; --audit tells which\n\
                next: groundtruth merge a0.sums a1.sums bad.sums -o mean.exr --audit 100%\n";
    assert_eq!(run.stderr, text);
    let again = "next: groundtruth render ch18/rectangle --size 12x8 --samples 4 --seed 3 --replicas 2 -o seeds-3.sums\n";
    let named = "error: bad.sums: pixel 5, 3 is not what is rendered here from its seeds 3 to 4: that machine is \
                 faulty, or this one\n";
    let named = &format!("{named}{again}");
    for files in ["a0.sums a1.sums bad.sums", "a0.sums bad.sums a1.sums"] {
        let run = expect(1, at, &format!("merge {files} -o mean.exr --audit 100%"));
        assert!(run.stderr.ends_with(named), "{}", run.stderr);
    }
    let run = expect(1, at, "merge a0.sums bad.sums -o mean.exr --audit 1 --scene ch18/rectangle");
    assert_eq!(&run.stderr, named);
    // the next step gives the right part
    let next = again.trim_end().strip_prefix("next: groundtruth ").expect("a command");
    expect(0, at, next);
    expect(0, at, "merge a0.sums seeds-3.sums -o mean.exr --audit 1");
    fs::remove_file(at.join("mean.exr")).expect("it was written");
    assert!(!at.join("mean.exr").exists());
    expect(2, at, "merge a0.sums a1.sums -o mean.exr --audit 1 --scene ch03/single-sphere");
    for share in ["0", "2", "101%", "x"] {
        expect(2, at, &format!("merge a0.sums a1.sums -o mean.exr --audit {share}"));
    }
}
