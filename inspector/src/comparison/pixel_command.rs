//! A program of a person's own that is run for a pixel, and writes a log of its rays.

use std::collections::BTreeSet;
use std::fs::File;
use std::io::{self, Read, Seek};
use std::path::PathBuf;
use std::process::Command;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, PoisonError};
use std::time::Duration;

use pictures::running::{last_lines, last_written, put_into_group, run_until};
use rays::{Log, LogError};
use text::shell;
use web_time::Instant;

use crate::platform;
use crate::scene::watch::Watch;

/// The file to which a program writes its rays, in the folder where it is run.
const FILE: &str = "rays.jsonl";
/// The time for a pixel.
const LIMIT: Duration = Duration::from_secs(10);
/// Only one program runs at a time: all write the same file.
static RUNNING: Mutex<()> = Mutex::new(());
/// Whether none runs any more.
static ENDED: AtomicBool = AtomicBool::new(false);

/// Ends the program that runs, if one does, and lets no other begin.
pub fn end_all() {
    ENDED.store(true, Ordering::Relaxed);
    drop(RUNNING.lock());
}

/// How a program is run for a pixel. Nothing but the command line of the window says it: no scene, log or link.
#[derive(Clone, Debug)]
pub struct PixelCommand {
    /// The command line as it was written.
    pub line: String,
    /// Its words, with `{x}` and `{y}` in the place of the pixel.
    words: Vec<String>,
    /// The folder in which it is run.
    pub folder: PathBuf,
    /// The time after which it is ended.
    pub limit: Duration,
    /// The picture that it renders.
    pub picture: Option<PathBuf>,
}

/// What a program did for a pixel.
pub struct PixelRun {
    /// Its rays.
    pub log: Log,
    /// The command that judges them in a terminal.
    pub command: String,
    /// Why they may not be all.
    pub problem: Option<String>,
}

impl PixelCommand {
    /// A command line, divided into words as a shell does. It is run in the present folder.
    ///
    /// # Errors
    /// A quotation mark that is not closed, or no word.
    pub fn parse(line: &str) -> Result<Self, String> {
        let words = shlex::split(line).filter(|words| !words.is_empty());
        let words = words.ok_or("no program, or a quotation mark that is not closed")?;
        let (line, folder) = (line.to_owned(), PathBuf::from("."));
        Ok(Self { line, words, folder, limit: LIMIT, picture: None })
    }

    /// Runs the program for a pixel, which the environment variable `RAYS` says, too, and reads the rays that it writes to
    /// its standard output, or to `rays.jsonl`. It is ended when its time is over, or when `is_stopped`.
    ///
    /// # Errors
    /// It cannot be started, or wrote no ray of this pixel; with its command and the last lines of its messages.
    pub fn run(&self, pixel: [u32; 2], is_stopped: &AtomicBool) -> Result<PixelRun, String> {
        let _alone = RUNNING.lock().unwrap_or_else(PoisonError::into_inner);
        let (mut command, shown) = self.command(pixel);
        let no_start = |error: io::Error| format!("{shown}: cannot be started: {error}");
        let output = tempfile::tempfile().map_err(no_start)?;
        let mut messages = tempfile::tempfile().map_err(no_start)?;
        let mut watch = Watch::default();
        watch.add(self.folder.join(FILE));
        let begun = Instant::now();
        let is_stopped = || is_stopped.load(Ordering::Relaxed) || ENDED.load(Ordering::Relaxed);
        let is_over = || begun.elapsed() >= self.limit || is_stopped();
        let ended = run_until(&mut command, [&output, &messages], is_over).map_err(no_start)?;
        let said = last_lines(&last_written(&mut messages));
        let told = |problem: String| match &*said {
            "" => format!("{shown}: {problem}"),
            said => format!("{shown}: {problem}; it said last:\n  {said}"),
        };
        let problem = match ended {
            Some(status) if status.success() => None,
            Some(status) => Some(told(format!("it failed ({status})"))),
            None => Some(told(format!("it was ended after {} s", self.limit.as_secs_f64()))),
        };
        match self.written(output, watch, pixel) {
            Ok((log, into)) => {
                let command = format!("{shown}{into}; groundtruth rays {FILE}");
                Ok(PixelRun { log, command, problem })
            }
            Err(wrong) => Err(problem.unwrap_or_else(|| told(wrong))),
        }
    }

    /// The log of a pixel, from the output or from the file if that is new, and how a shell puts it into the file.
    fn written(
        &self,
        mut output: File,
        mut watch: Watch,
        pixel: [u32; 2],
    ) -> Result<(Log, String), String> {
        let (log, into) = if begins_as_log(&mut output) {
            (rays::read(output), format!(" > {FILE}"))
        } else if watch.changed() {
            (platform::read_log(&self.folder.join(FILE)), String::new())
        } else {
            return Err(format!("it wrote no log to its standard output, and no new {FILE}"));
        };
        let mut log = log.map_err(|error| match error {
            LogError::NoRay(None) => {
                let [x, y] = pixel;
                format!(
                    "it logged no ray of pixel ({x}, {y}): is its picture smaller than this one?"
                )
            }
            error => error.to_string(),
        })?;
        let pixels = log.rays.iter_mut().map(|ray| *ray.pixel.get_or_insert(pixel));
        let pixels: BTreeSet<[u32; 2]> = pixels.collect();
        if let Some([x, y]) = pixels.first().filter(|_| !pixels.contains(&pixel)) {
            return Err(format!("its rays are of pixel ({x}, {y}), not of this one"));
        }
        let picture = self.picture.as_ref().map(|path| path.display().to_string());
        log.head.picture = log.head.picture.or(picture);
        Ok((log, into))
    }

    /// The command for a pixel, and as one types it.
    fn command(&self, [x, y]: [u32; 2]) -> (Command, String) {
        let filled =
            |word: &String| word.replace("{x}", &x.to_string()).replace("{y}", &y.to_string());
        let words: Vec<String> = self.words.iter().map(filled).collect();
        let mut command = Command::new(&words[0]);
        command.args(&words[1..]).current_dir(&self.folder);
        command.env("RAYS", format!("{x},{y}")).env_remove("RAYS_FILE");
        put_into_group(&mut command);
        let shown = shell::line(words.iter().map(String::as_str));
        (command, format!("RAYS={x},{y} {shown}"))
    }
}

fn begins_as_log(file: &mut File) -> bool {
    let mut first = [0];
    let read = file.rewind().and_then(|()| file.read_exact(&mut first));
    read.and_then(|()| file.rewind()).is_ok() && first == *b"{"
}
