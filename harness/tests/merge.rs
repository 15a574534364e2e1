//! The commands `render --replicas` and `merge`: what cases cannot say.

mod borders;
mod damage;
#[path = "../pictures/tests/sums/header.rs"]
mod header;
#[cfg(unix)]
mod interrupt;
mod means;
mod merged;
mod shares;

use std::process::Command;

use crate::kit::{Folder, Run};

/// A small picture with noise.
const SCENE: &str = "ch18/rectangle --size 12x8 --samples 4";

fn command(at: &Folder, line: &str) -> Command {
    at.command(&format!("exec groundtruth {line}"))
}

/// Runs the program, and fails unless it ends with this status.
fn expect(status: i32, at: &Folder, line: &str) -> Run {
    at.run(&format!("groundtruth {line}")).expect(status, &[])
}

/// Renders replicas from seed 1 on, as this number of parts: `a0.sums`, `a1.sums` …
fn parts(at: &Folder, name: &str, count: u32, replicas: u32) -> Vec<String> {
    let part = |k: u32| {
        let file = format!("{name}{k}.sums");
        let line = format!("render {SCENE} --seed 1 --replicas {replicas} --part {k}/{count}");
        expect(0, at, &format!("{line} -o {file}"));
        file
    };
    (0..count).map(part).collect()
}
