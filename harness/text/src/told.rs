//! What a command says of what it judged, in one form for terminal, page and JSON: the verdict in one sentence, what it
//! rests on, and the next step as a command.

use serde::Serialize;

use crate::html::{self, escaped};

/// What stands before the command of the last line.
pub const NEXT: &str = "next: ";

/// What is said of a verdict.
#[derive(Clone, Debug)]
pub struct Told {
    /// The first line: one sentence.
    pub verdict: String,
    /// Whole lines, those first that a reader needs first.
    pub details: String,
    /// The next step: a command that can be pasted into a shell.
    pub next: String,
}

/// JSON of a verdict: its sentence, all its data with all digits, and the next step.
#[derive(Serialize)]
struct Json<'a, T> {
    verdict: &'a str,
    #[serde(flatten)]
    data: &'a T,
    next: &'a str,
}

impl Told {
    /// For the terminal.
    pub fn text(&self) -> String {
        let Self { verdict, details, next } = self;
        format!("{verdict}\n{details}{NEXT}{next}\n")
    }

    /// For programs, with the data that the verdict is made of.
    ///
    /// # Errors
    /// If the data cannot be JSON.
    pub fn json(&self, data: &impl Serialize) -> Result<String, serde_json::Error> {
        let Self { verdict, next, .. } = self;
        Ok(serde_json::to_string_pretty(&Json { verdict, data, next })? + "\n")
    }

    /// The page: the verdict as headline, what it is about, pictures or tables (HTML), the details, and the next step.
    pub fn page(&self, about: &str, rules: &[&str], body: &str) -> String {
        let Self { verdict, details, next } = self;
        let [headline, about, details, next] = [verdict, about, details, next].map(escaped);
        let numbers = match details.is_empty() {
            true => String::new(),
            false => format!("<h2>In numbers</h2>\n<pre>{details}</pre>\n"),
        };
        let body = format!(
            "<p class=\"about\">{about}</p>\n<h1>{headline}</h1>\n{body}{numbers}\
             <p class=\"next\">Next: <code>{next}</code></p>\n"
        );
        html::page(&headline, rules, &body)
    }
}
