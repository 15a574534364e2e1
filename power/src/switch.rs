//! The switch of the scratch copy: this file is its package `planted`.
//!
//! The variable PLANTED names the change that is on. With PLANTED_REACHED=FILE none is on, and the numbers of all changes
//! that are reached are added to the file, by this process and by those that it starts.

use std::io::Write;
use std::sync::LazyLock;
use std::sync::atomic::{AtomicBool, Ordering};

static ON: LazyLock<usize> =
    LazyLock::new(|| std::env::var("PLANTED").ok().and_then(|it| it.parse().ok()).unwrap_or(0));
static REACHED: LazyLock<Option<String>> = LazyLock::new(|| std::env::var("PLANTED_REACHED").ok());
static SEEN: [AtomicBool; 4096] = [const { AtomicBool::new(false) }; 4096];

/// Whether change `number` (from 1) is on.
#[inline]
pub fn on(number: usize) -> bool {
    if let Some(file) = &*REACHED {
        note(file, number);
    }
    *ON == number
}

#[cold]
#[inline(never)]
fn note(file: &str, number: usize) {
    if !SEEN[number % SEEN.len()].swap(true, Ordering::Relaxed) {
        let opened = std::fs::File::options().create(true).append(true).open(file);
        // one short write, which the kernel keeps whole
        let written = opened.and_then(|mut it| it.write_all(format!("{number}\n").as_bytes()));
        written.unwrap_or_else(|error| panic!("{file}: {error}"));
    }
}
