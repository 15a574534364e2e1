//! `groundtruth list`.

use clap::Args;
use serde::Serialize;
use text::document::table;

use super::{Outcome, print};

#[derive(Args)]
pub struct List {
    /// Chapters to list, such as ch24 or 24, and words to find in names and descriptions, such as fresnel or 26.12;
    /// all scenes if left out
    #[arg(value_name = "WORD")]
    words: Vec<String>,
    /// Print JSON
    #[arg(long)]
    json: bool,
}

#[derive(Serialize)]
struct Line {
    name: &'static str,
    about: String,
}

impl List {
    pub fn run(&self) -> Outcome {
        let found = gallery::search(self.words.iter().map(String::as_str));
        if found.is_empty() {
            return Err(nothing(&self.words).into());
        }
        let line = |entry: gallery::Entry| Line { name: entry.name, about: (entry.build)().about };
        let lines: Vec<Line> = found.into_iter().map(line).collect();
        if self.json {
            return print(&(serde_json::to_string_pretty(&lines)? + "\n"));
        }
        let table = table(&lines).column("", |line| line.name).column("", |line| &line.about);
        print(&table.element().plain())
    }
}

/// Whether a name such as `ch24/hall-of-mirrors` belongs to the chapter.
pub fn is_in(name: &str, chapter: &str) -> bool {
    name.split_once('/').is_some_and(|(its, _)| its == chapter)
}

/// The message when no scene fits the words.
fn nothing(words: &[String]) -> String {
    let is_chapter = |word: &&String| {
        let number = word.strip_prefix("ch");
        number.is_some_and(|number| number.parse::<u32>().is_ok())
    };
    let mut unknown = words.iter().filter(is_chapter);
    let Some(chapter) = unknown.find(|word| gallery::search([word.as_str()]).is_empty()) else {
        return format!("no scene has `{}` in its name and description", words.join(" "));
    };
    let mut chapters: Vec<&str> = gallery::scenes()
        .filter_map(|entry| entry.name.split_once('/'))
        .map(|(chapter, _)| chapter)
        .collect();
    chapters.dedup();
    format!("no scenes of a chapter `{chapter}`; the chapters are: {}", chapters.join(", "))
}
