//! Where a report comes from: machine, version, commit.

use std::process::Command;
use std::time::{Duration, UNIX_EPOCH};

use serde::Serialize;

/// What a reader must know before comparing times.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Provenance {
    /// The version of this program.
    pub version: &'static str,
    /// The commit of the folder it was built in, as it is now; `-dirty` if files there were changed
    /// since, `-or-earlier` if the program was built before that commit was made; `unknown` without
    /// git or without that folder.
    pub commit: String,
    /// Whether the compiler left its own checks in: then times mean little.
    pub debug: bool,
    /// The processor's name, as the system says it.
    pub processor: String,
    /// Operating system and architecture.
    pub platform: String,
    /// Threads of this run. Rays are always timed on one.
    pub threads: usize,
}

impl Provenance {
    /// Of this program, here and now.
    pub fn here() -> Self {
        Self {
            version: env!("CARGO_PKG_VERSION"),
            commit: commit().unwrap_or_else(|| "unknown".to_owned()),
            debug: cfg!(debug_assertions),
            processor: processor().unwrap_or_else(|| "unknown processor".to_owned()),
            platform: format!("{} {}", std::env::consts::OS, std::env::consts::ARCH),
            threads: rayon::current_num_threads(),
        }
    }
}

fn commit() -> Option<String> {
    let name = git(&["describe", "--always", "--dirty", "--abbrev=12", "--exclude=*"])?;
    let committed = git(&["log", "-1", "--format=%ct"])?.parse().ok()?;
    let built = std::env::current_exe().ok()?.metadata().ok()?.modified().ok()?;
    let built = built.duration_since(UNIX_EPOCH).ok()?;
    Some(if built < Duration::from_secs(committed) { name + "-or-earlier" } else { name })
}

/// What git says of the folder this was built in.
fn git(words: &[&str]) -> Option<String> {
    let folder = env!("CARGO_MANIFEST_DIR");
    let output = Command::new("git").args(["-C", folder]).args(words).output().ok()?;
    let text = String::from_utf8(output.stdout).ok()?;
    let answer = text.trim();
    (output.status.success() && !answer.is_empty()).then(|| answer.to_owned())
}

fn processor() -> Option<String> {
    let text = std::fs::read_to_string("/proc/cpuinfo").ok()?;
    let line = text.lines().find(|line| line.starts_with("model name"))?;
    Some(line.split_once(':')?.1.trim().to_owned())
}
