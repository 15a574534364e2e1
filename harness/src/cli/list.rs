//! `groundtruth list`.

use clap::Args;
use groundtruth::gallery;
use serde::Serialize;

use super::{Outcome, print};

#[derive(Args)]
pub struct List {
    /// Chapters to list, such as ch24; all if left out
    #[arg(value_name = "CHAPTER")]
    chapters: Vec<String>,
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
        let names: Vec<&str> = gallery::scenes().map(|entry| entry.name).collect();
        if let Some(unknown) = self.chapters.iter().find(|chapter| !is_chapter(chapter, &names)) {
            return Err(no_chapter(unknown, &names).into());
        }
        let wanted = |name: &str| {
            self.chapters.is_empty() || self.chapters.iter().any(|chapter| is_in(name, chapter))
        };
        let lines: Vec<Line> = gallery::scenes()
            .filter(|entry| wanted(entry.name))
            .map(|entry| Line { name: entry.name, about: (entry.build)().about })
            .collect();
        if self.json {
            return print(&(serde_json::to_string_pretty(&lines)? + "\n"));
        }
        let widest = lines.iter().map(|line| line.name.len()).max().unwrap_or(0);
        let text: String =
            lines.iter().map(|line| format!("{:widest$}  {}\n", line.name, line.about)).collect();
        print(&text)
    }
}

/// Whether a name such as `ch24/hall-of-mirrors` belongs to the chapter.
pub fn is_in(name: &str, chapter: &str) -> bool {
    name.split_once('/').is_some_and(|(its, _)| its == chapter)
}

fn is_chapter(chapter: &str, names: &[&str]) -> bool {
    names.iter().any(|name| is_in(name, chapter))
}

fn no_chapter(chapter: &str, names: &[&str]) -> String {
    let mut chapters: Vec<&str> =
        names.iter().filter_map(|name| name.split_once('/')).map(|(chapter, _)| chapter).collect();
    chapters.dedup();
    format!("no scenes of a chapter `{chapter}`; the chapters are: {}", chapters.join(", "))
}
