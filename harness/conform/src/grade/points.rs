//! Points: of a family by its right answers, of a part by its families.

use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use serde_json::{Value, json};

use super::table::{Table, TablePart};
use crate::card::{Card, Row, Status};
use crate::judgement::Profile;
use crate::run::{NoAnswer, Options, run};
use crate::subject::Subject;

/// What a program gets.
#[derive(Debug)]
pub struct Grade {
    /// Of the assignment.
    pub title: String,
    /// In the order of the table.
    pub parts: Vec<PartGrade>,
    /// What was asked and answered; none if the program answered no question at all.
    pub card: Result<Card, NoAnswer>,
}

/// What it gets for a part.
#[derive(Debug)]
pub struct PartGrade {
    /// As in the table.
    pub name: String,
    /// As many as a program without a mistake gets.
    pub most: f64,
    /// In hundredths, rounded down: all of them only if nothing is wrong.
    pub points: f64,
    /// The families, as far as they were asked.
    pub(super) rows: Vec<Row>,
}

/// What a family counts: 1 if all of its answers are right, else 0. `None` if there was nothing to judge.
pub(super) fn worth(row: &Row) -> Option<f64> {
    // a case that was not asked any more, after faults or as unsupported, is not right
    let judged = row.cases - row.count(Status::Undecided);
    (judged > 0).then(|| f64::from(u8::from(row.count(Status::Pass) == judged)))
}

impl PartGrade {
    fn new(part: &TablePart, rows: Vec<Row>) -> Self {
        let worths: Vec<f64> = rows.iter().filter_map(worth).collect();
        let share = match worths.len() {
            0 => 0.0,
            count => worths.iter().sum::<f64>() / count as f64,
        };
        // a product like 0.29 · 100 is a little below its hundredth
        let points = (100.0 * part.points * share + 1e-6).floor() / 100.0;
        let points = if share == 1.0 { part.points } else { points };
        Self { name: part.name.clone(), most: part.points, points, rows }
    }

    /// Families with a wrong answer, an error or no answer.
    pub fn failed(&self) -> usize {
        self.rows.iter().filter(|row| row.is_failed()).count()
    }

    /// Families of which the program supports nothing.
    pub(super) fn unsupported(&self) -> usize {
        self.rows.iter().filter(|row| row.is_unsupported()).count()
    }
}

impl Grade {
    /// Asks a program what the table says; `watch` is told of each family that is finished.
    pub fn of(
        subject: &mut dyn Subject,
        table: &Table,
        interrupted: Arc<AtomicBool>,
        watch: &mut dyn FnMut(&Row),
    ) -> Self {
        let options = Options {
            profile: Profile::Book,
            seed: table.seed,
            cases: table.cases,
            shrink: false,
            interrupted,
        };
        let card = run(subject, &table.families, &options, watch);
        let rows = |part: &TablePart| match &card {
            Ok(card) => {
                card.rows.iter().filter(|row| part.families.contains(&row.name)).cloned().collect()
            }
            Err(_) => Vec::new(),
        };
        let parts = table.parts.iter().map(|part| PartGrade::new(part, rows(part))).collect();
        Self { title: table.title.clone(), parts, card }
    }

    /// The sum of all parts.
    pub fn points(&self) -> f64 {
        // hundredths add up without rounding errors
        self.parts.iter().map(|part| (100.0 * part.points).round()).sum::<f64>() / 100.0
    }

    /// The sum that a program without a mistake gets.
    pub fn most(&self) -> f64 {
        self.parts.iter().map(|part| part.most).sum()
    }

    /// Whether the program gets all points.
    pub fn is_full(&self) -> bool {
        self.parts.iter().all(|part| part.points == part.most)
    }

    /// Whether everything was asked, and a part has something that could be judged.
    pub fn is_whole(&self) -> bool {
        self.card.as_ref().is_ok_and(|card| card.is_whole)
    }

    /// Whether a judge of ours failed, or a part had nothing that could be judged.
    pub fn is_not_judged(&self) -> bool {
        let is_empty = |part: &PartGrade| part.rows.iter().all(|row| worth(row).is_none());
        self.card.as_ref().is_ok_and(Card::is_not_judged) || self.parts.iter().any(is_empty)
    }

    /// Everything, for the teacher: questions, answers, names of mistakes.
    pub fn json(&self) -> Value {
        let part = |part: &PartGrade| {
            let family = |row: &Row| json!({"family": row.name, "worth": worth(row)});
            json!({
                "name": part.name, "points": part.points, "most": part.most, "failed": part.failed(),
                "unsupported": part.unsupported(),
                "families": part.rows.iter().map(family).collect::<Vec<_>>(),
            })
        };
        json!({
            "title": self.title, "points": self.points(), "most": self.most(),
            "parts": self.parts.iter().map(part).collect::<Vec<_>>(),
            "card": self.card.as_ref().ok().map(Card::json),
            "no_answer": self.card.as_ref().err().map(|error| &error.0),
        })
    }
}
