//! Programs that are asked questions: what `conform` and `laws` have in common.

use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use std::time::Duration;

use clap::Args;
use conform::{Limits, Program};
use groundtruth::math::hash;

const ANSWER_SECONDS: f64 = 5.0;
const START_SECONDS: f64 = 60.0;

/// A program, and how long it may take.
#[derive(Args)]
pub struct ProgramArguments {
    /// Seconds for an answer
    #[arg(long, value_name = "SECONDS", default_value_t = ANSWER_SECONDS, value_parser = seconds)]
    timeout: f64,
    /// Seconds for the first answer after a start
    #[arg(long, value_name = "SECONDS", default_value_t = START_SECONDS, value_parser = seconds)]
    start_timeout: f64,
    /// The program and its arguments
    #[arg(last = true, required_unless_present = "init", value_name = "PROGRAM")]
    program: Vec<String>,
}

fn seconds(text: &str) -> Result<f64, String> {
    match text.parse() {
        Ok(x) if (1e-3..=1e6).contains(&x) => Ok(x),
        _ => Err("write a number of seconds, such as 5".to_owned()),
    }
}

impl ProgramArguments {
    /// The program, which starts at the first question.
    pub fn program(&self, interrupted: Arc<AtomicBool>) -> Program {
        let [answer, start] = [self.timeout, self.start_timeout].map(Duration::from_secs_f64);
        Program::new(self.program.clone(), Limits { answer, start: start.max(answer) }, interrupted)
    }

    /// The options that say how long it may take, if they are not the defaults.
    pub fn limits(&self) -> Vec<String> {
        let all = [
            ("--timeout", self.timeout, ANSWER_SECONDS),
            ("--start-timeout", self.start_timeout, START_SECONDS),
        ];
        let chosen = all.into_iter().filter(|(_, seconds, default)| seconds != default);
        chosen.flat_map(|(name, seconds, _)| [name.to_owned(), seconds.to_string()]).collect()
    }

    /// The program and its arguments.
    pub fn words(&self) -> &[String] {
        &self.program
    }

    /// The program and its arguments, as they were typed.
    pub fn command(&self) -> String {
        self.program.join(" ")
    }
}

/// A seed from the clock: anything that was not chosen.
pub fn fresh_seed() -> u64 {
    let now =
        std::time::SystemTime::now().duration_since(std::time::UNIX_EPOCH).unwrap_or_default();
    hash(&[now.as_nanos() as u64]) >> 16
}

/// What is to be done about a program that answers nothing.
pub fn no_answer(error: &str, log: &str) -> String {
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
    text + hint + &log
}
