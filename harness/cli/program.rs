//! Programs that are asked questions, and cards of what is found: what `conform` and `laws` have in common.

use ask::{Invocation, Limits, Program};
use std::error::Error;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use std::time::Duration;

use clap::Args;
use groundtruth::math::hash;
use groundtruth::printable;
use serde_json::Value;
use text::told::Told;

use super::numbers::{number, whole};
use super::{Exit, Outcome, output};

const ANSWER_SECONDS: f64 = 5.0;
const START_SECONDS: f64 = 60.0;

/// Which cases are drawn, where the card goes, and the program and how long it may take.
#[derive(Args)]
pub struct CardArguments {
    /// Of the cases
    #[arg(long, default_value_t = 1, value_parser = whole::<u64>(0..=u64::MAX))]
    seed: u64,
    /// A seed that nobody has seen; the card prints it
    #[arg(long, conflicts_with = "seed")]
    fresh: bool,
    /// Write the results for continuous integration (JUnit's XML)
    #[arg(long, value_name = "FILE")]
    junit: Option<PathBuf>,
    /// Write the card as a page; - is the standard output, here and for other files
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Print JSON
    #[arg(long)]
    json: bool,
    /// Seconds for an answer
    #[arg(long, value_name = "SECONDS", default_value_t = ANSWER_SECONDS, value_parser = number(1e-3..=1e6, "write a number of seconds, such as 5"))]
    timeout: f64,
    /// Seconds for the first answer after a start
    #[arg(long, value_name = "SECONDS", default_value_t = START_SECONDS, value_parser = number(1e-3..=1e6, "write a number of seconds, such as 5"))]
    start_timeout: f64,
    /// The program and its arguments
    #[arg(last = true, required_unless_present = "init", value_name = "PROGRAM")]
    program: Vec<String>,
}

/// A card, as it is written; a form takes the command line of the program.
pub struct Written<'a> {
    pub told: &'a Told,
    pub json: Value,
    pub page: &'a dyn Fn(&str) -> String,
    pub junit: &'a dyn Fn(&str) -> String,
    /// One file more, and what it holds.
    pub more: Option<(&'a Path, String)>,
}

impl CardArguments {
    /// The program, which starts at the first question.
    pub fn program(&self, interrupted: Arc<AtomicBool>) -> Program {
        let [answer, start] = [self.timeout, self.start_timeout].map(Duration::from_secs_f64);
        Program::new(self.program.clone(), Limits { answer, start: start.max(answer) }, interrupted)
    }

    /// The options that say how long it may take, if they are not the defaults.
    fn limits(&self) -> Vec<String> {
        let all = [
            ("--timeout", self.timeout, ANSWER_SECONDS),
            ("--start-timeout", self.start_timeout, START_SECONDS),
        ];
        let chosen = all.into_iter().filter(|(_, seconds, default)| seconds != default);
        chosen.flat_map(|(name, seconds, _)| [name.to_owned(), seconds.to_string()]).collect()
    }

    /// The seed that was given, or a fresh one.
    pub fn seed(&self) -> u64 {
        if self.fresh { fresh_seed() } else { self.seed }
    }

    /// What was typed, to be asked again; `cases` if they are not the usual ones.
    pub fn invocation(
        &self,
        selection: Vec<String>,
        options: Vec<String>,
        cases: Option<usize>,
    ) -> Invocation<'_> {
        let options = [options, self.limits()].concat();
        Invocation { selection, options, cases, is_fresh: self.fresh, program: &self.program }
    }

    fn files<'a>(&'a self, more: Option<&'a Path>) -> impl Iterator<Item = &'a Path> {
        [self.output.as_deref(), self.junit.as_deref(), more].into_iter().flatten()
    }

    /// Fails if a file cannot be written, found out before anything is asked.
    pub fn check_files(&self, more: Option<&Path>) -> Result<(), Box<dyn Error>> {
        output::once(self.files(more), "output")?;
        self.files(more).try_for_each(output::writable)
    }

    /// Writes the files, and prints what is said: to the standard error if a file goes to the standard output.
    pub fn write(&self, card: &Written<'_>) -> Outcome {
        let command = self.program.join(" ");
        for (file, text) in [(&self.output, card.page), (&self.junit, card.junit)] {
            if let Some(file) = file {
                output::write(file, text(&command).as_bytes())?;
            }
        }
        if let Some((file, text)) = &card.more {
            output::write(file, text.as_bytes())?;
        }
        let said = if self.json { card.told.json(&card.json)? } else { card.told.text() };
        let more = card.more.as_ref().map(|(file, _)| *file);
        output::say(&said, self.files(more).find(|file| output::is_standard(file)))
    }
}

/// A seed from the clock: anything that was not chosen.
pub fn fresh_seed() -> u64 {
    let now = std::time::UNIX_EPOCH.elapsed().unwrap_or_default();
    hash(&[now.as_nanos() as u64]) >> 16
}

/// Says what is to be done about a program that answers nothing.
pub fn unanswered(error: &str, log: &str) -> Outcome {
    let text = format!("error: {error}");
    let hint = if text.contains("no answer within") {
        "\nhint: flush the output after each line (C and Python keep it back when writing to a pipe)"
    } else if text.contains("not a JSON object") {
        "\nhint: print nothing but answers to the standard output; banners belong to the standard error"
    } else {
        ""
    };
    let log =
        if log.is_empty() { String::new() } else { format!("\nits standard error begins:\n{log}") };
    (text + hint + &log).lines().for_each(|line| eprintln!("{}", printable::text(line)));
    Ok(Exit::Unanswered)
}
