//! The provenance of a report: machine, version, commit.

use std::process::Command;
use std::time::{Duration, UNIX_EPOCH};

use serde::Serialize;

/// The data that a reader needs to compare times.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Provenance {
    /// The version of this program.
    pub version: &'static str,
    /// The current commit of the folder in which the program was built: `-dirty` if files were
    /// changed since, `-or-earlier` if the program is older than the commit, `unknown` without git
    /// or without the folder.
    pub commit: String,
    /// Whether debug assertions are enabled: then times are too long.
    pub debug: bool,
    /// The name of the processor, from the operating system.
    pub processor: String,
    /// Operating system and architecture.
    pub platform: String,
    /// The number of threads. Rays are always timed on one.
    pub threads: usize,
}

impl Provenance {
    /// The provenance of this run.
    pub fn current() -> Self {
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

/// The output of a git command in the folder in which the program was built.
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
