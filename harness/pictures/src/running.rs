//! A run of another renderer, with a time limit.

use std::fs::File;
use std::io::{Read, Seek};
use std::process::{Command, ExitStatus, Stdio};
use std::time::{Duration, Instant};

use groundtruth::printable;

/// How a program ended, and what it wrote to its standard error.
pub struct Run {
    /// How it ended.
    pub status: ExitStatus,
    /// Its standard error.
    pub messages: Vec<u8>,
}

/// Runs a program without input to its end, or ends it after `limit`.
///
/// It writes to files, not to pipes: a process that it started and that outlives it keeps nobody waiting.
///
/// # Errors
/// It cannot be started, or took longer; the message quotes what it wrote last.
pub fn run(command: &mut Command, limit: Duration) -> Result<Run, String> {
    let text = |error: std::io::Error| format!("cannot be started: {error}");
    let mut said = tempfile::tempfile().map_err(text)?;
    let files = [said.try_clone(), said.try_clone()].map(|file| file.map_err(text));
    let [out, messages] = files;
    command.stdin(Stdio::null()).stdout(out?).stderr(messages?);
    let mut child = command.spawn().map_err(text)?;
    let begun = Instant::now();
    loop {
        if let Some(status) = child.try_wait().map_err(|e| e.to_string())? {
            return Ok(Run { status, messages: read(&mut said) });
        }
        if begun.elapsed() >= limit {
            let _ = child.kill(); // it may have ended just now
            let _ = child.wait();
            let last = last_lines(&read(&mut said));
            let last = if last.is_empty() { "nothing".to_owned() } else { format!("\n  {last}") };
            return Err(format!(
                "ended after {} s without a picture (--time-limit); it said last: {last}",
                limit.as_secs()
            ));
        }
        std::thread::sleep(Duration::from_millis(10));
    }
}

/// All that was written to a file.
fn read(file: &mut File) -> Vec<u8> {
    let mut bytes = Vec::new();
    // what cannot be read is not quoted
    let _ = file.rewind().and_then(|()| file.read_to_end(&mut bytes));
    bytes
}

/// The last lines of the messages of a program that failed.
pub fn last_lines(messages: &[u8]) -> String {
    /// So many are quoted.
    const QUOTED: usize = 12;
    let messages = String::from_utf8_lossy(messages).into_owned();
    let lines = messages.lines().filter(|line| !line.trim().is_empty());
    let lines: Vec<String> = lines.map(printable::text).collect();
    lines[lines.len().saturating_sub(QUOTED)..].join("\n  ")
}
