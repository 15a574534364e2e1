//! `groundtruth list`.

use clap::Args;
use groundtruth::gallery;
use serde::Serialize;

use super::{Outcome, print};

#[derive(Args)]
pub struct List {
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
        let lines: Vec<Line> = gallery::scenes()
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
