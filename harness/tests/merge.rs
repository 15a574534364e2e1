//! The commands `render --replicas` and `merge`: what cases cannot say.

#[cfg(unix)]
mod interrupt;

use std::process::Command;

use xxhash_rust::xxh3::xxh3_128;

use crate::kit::{Folder, Run};

fn command(at: &Folder, line: &str) -> Command {
    at.command(&format!("exec groundtruth {line}"))
}

/// Runs the program, and fails unless it ends with this status.
fn expect(status: i32, at: &Folder, line: &str) -> Run {
    at.run(&format!("groundtruth {line}")).expect(status, &[])
}

/// Where the sums begin: after two lines.
fn body(bytes: &[u8]) -> usize {
    let ends = (0..bytes.len()).filter(|at| bytes[*at] == b'\n');
    ends.take(2).last().expect("two lines") + 1
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
    at.good(
        "for k in 0 1; do groundtruth render ch18/rectangle --size 12x8 --samples 4 --seed 1 \
         --replicas 4 --part $k/2 -o a$k.sums; done",
    );
    // pixel 5, 3 of 12 columns
    at.write("bad.sums", faulty(&at.bytes("a1.sums"), 3 * 12 + 5));
    let run = expect(1, at, "merge a0.sums a1.sums bad.sums -o mean.exr");
    let text = "error: bad.sums and a1.sums have the same seeds 3 to 4 but differ at pixel 5, 3: one of the \
                machines is faulty; render them a third time to see which\n";
    assert_eq!(run.stderr, text);
    assert!(!at.path().join("mean.exr").exists());
}
