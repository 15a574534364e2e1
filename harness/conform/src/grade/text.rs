//! A grade as students read it.

use std::fmt::Write;

use super::hint::{advice, asked, found};
use super::points::{Grade, PartGrade};

/// What is said of a program that answered nothing.
const NO_ANSWER: &str = "Your program answered no question. It may not start, or end, or wait, or print something \
                         else first. Try it: groundtruth conform -- YOUR PROGRAM\n";

/// Points as `28.57` or `30`.
pub(super) fn shown(points: f64) -> String {
    let text = format!("{points:.2}");
    text.strip_suffix(".00").map_or(text.clone(), str::to_owned)
}

impl Grade {
    /// Points, and a hint for each family that is not right.
    pub fn text(&self) -> String {
        let mut text = self.summary();
        if self.card.is_err() {
            return text;
        }
        for part in self.parts.iter().filter(|part| part.points < part.most) {
            let (points, most) = (shown(part.points), shown(part.most));
            write!(text, "\n{}: {points} of {most}\n{}", part.name, part.hints())
                .expect("a string grows");
        }
        text
    }

    /// The title and a line for each part.
    pub(super) fn summary(&self) -> String {
        let points = |points: f64, most: f64| format!("{:>8} of {}", shown(points), shown(most));
        let width = self.parts.iter().map(|part| part.name.chars().count()).max().unwrap_or(0);
        let width = width.max("total".len());
        let mut text = format!("{}\n\n", self.title);
        let lines = self.parts.iter().map(|part| (part.name.as_str(), part.points, part.most));
        for (name, got, most) in lines.chain([("total", self.points(), self.most())]) {
            writeln!(text, "{name:<width$}  {}", points(got, most)).expect("a string grows");
        }
        match &self.card {
            Err(_) => text + "\n" + NO_ANSWER,
            Ok(card) if !card.is_whole => text + "\ninterrupted: not everything was asked\n",
            Ok(_) => text,
        }
    }
}

impl PartGrade {
    /// A hint for each family that is not right.
    pub(super) fn hints(&self) -> String {
        let hint = |row| {
            let found = found(row)?;
            Some(format!("  {}\n    {found}\n    {}\n", asked(row), advice(row)))
        };
        self.rows.iter().filter_map(hint).collect()
    }
}
