//! Programs of others: run with a time limit, and ended with all that they started.

use std::fs::File;
use std::io::{self, Read, Seek, SeekFrom};
use std::process::{Child, Command, ExitStatus, Stdio};
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
/// # Errors
/// It cannot be started, or took longer; the message quotes what it wrote last.
pub fn run(command: &mut Command, limit: Duration) -> Result<Run, String> {
    let text = |error: io::Error| format!("cannot be started: {error}");
    let mut said = tempfile::tempfile().map_err(text)?;
    let begun = Instant::now();
    let ended = run_until(command, [&said, &said], || begun.elapsed() >= limit).map_err(text)?;
    let messages = last_written(&mut said);
    let Some(status) = ended else {
        let last = last_lines(&messages);
        let last = if last.is_empty() { "nothing".to_owned() } else { format!("\n  {last}") };
        return Err(format!(
            "ended after {} s without a picture (--time-limit); it said last: {last}",
            limit.as_secs()
        ));
    };
    Ok(Run { status, messages })
}

/// Runs a program without input to its end, or ends it, and the group of its own if it has one, when `is_over`: it has no
/// status then.
///
/// Its output and its messages go to files, not to pipes: a process that it started and that outlives it keeps nobody
/// waiting.
///
/// # Errors
/// It cannot be started.
pub fn run_until(
    command: &mut Command,
    [output, messages]: [&File; 2],
    is_over: impl Fn() -> bool,
) -> io::Result<Option<ExitStatus>> {
    command.stdin(Stdio::null()).stdout(output.try_clone()?).stderr(messages.try_clone()?);
    let mut child = command.spawn()?;
    loop {
        if let Some(status) = child.try_wait()? {
            return Ok(Some(status));
        }
        if is_over() {
            kill_group(&mut child);
            let _ = child.wait();
            return Ok(None);
        }
        std::thread::sleep(Duration::from_millis(10));
    }
}

/// A process group of its own: the program's children can be ended with it.
#[cfg(unix)]
pub fn put_into_group(command: &mut Command) {
    use std::os::unix::process::CommandExt;
    command.process_group(0);
}

/// Other systems have no process groups.
#[cfg(not(unix))]
pub fn put_into_group(_: &mut Command) {}

/// Ends a process, and its group if it leads one.
pub fn kill_group(child: &mut Child) {
    #[cfg(unix)]
    {
        use rustix::process::{Pid, Signal, kill_process_group};
        if let Some(group) = Pid::from_raw(child.id().cast_signed()) {
            let _ = kill_process_group(group, Signal::KILL);
        }
    }
    let _ = child.kill(); // it may have ended just now
}

/// What was written to a file, the end of it if that is much.
pub fn last_written(file: &mut File) -> Vec<u8> {
    /// More is not read.
    const LAST: u64 = 1 << 16;
    let mut bytes = Vec::new();
    let end = file.metadata().map_or(0, |data| data.len());
    let last = file.seek(SeekFrom::Start(end.saturating_sub(LAST)));
    // what cannot be read is not quoted
    let _ = last.and_then(|_| file.read_to_end(&mut bytes));
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
