//! The card: what is right, what is wrong, and with which question.

mod junit;
mod page;
mod text;

use std::collections::BTreeMap;

use ask::Fault;
use serde_json::{Value, json};

use super::judgement::{Profile, Wrong};
use super::mistakes::{Mistake, Name};

pub use junit::junit;
pub use page::page;
pub use text::{told, verdict};

/// What became of a case.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum Status {
    Pass,
    Wrong,
    Refused,
    Unsupported,
    Hung,
    Died,
    Garbled,
    Undecided,
}

impl Status {
    /// All of them, in the order of the card.
    pub const ALL: [Self; 8] = [
        Self::Pass,
        Self::Wrong,
        Self::Refused,
        Self::Unsupported,
        Self::Hung,
        Self::Died,
        Self::Garbled,
        Self::Undecided,
    ];

    /// That of a fault.
    pub(super) fn of(fault: &Fault) -> Self {
        match fault {
            Fault::Hung(_) => Self::Hung,
            Fault::Died(_) => Self::Died,
            Fault::Garbled(_) => Self::Garbled,
        }
    }

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Pass => "pass",
            Self::Wrong => "wrong",
            Self::Refused => "refused",
            Self::Unsupported => "unsupported",
            Self::Hung => "hung",
            Self::Died => "died",
            Self::Garbled => "garbled",
            Self::Undecided => "undecided",
        }
    }
}

/// A wrong answer.
#[derive(Clone, Debug)]
pub struct Failure {
    /// The case.
    pub question: Value,
    /// What is wrong with it.
    pub wrong: Wrong,
    /// What was asked, and what came.
    pub asked: Vec<(Value, String)>,
}

/// Letters of a reason that are kept.
const LONGEST_REASON: usize = 80;
/// Reasons of a family that are kept.
const MOST_REASONS: usize = 16;

/// What became of a family.
#[derive(Clone, Debug, Default)]
pub struct Row {
    /// As `intersect.torus.grazing`.
    pub name: String,
    /// As `shapes/torus`.
    pub about: String,
    /// As `ch19`.
    pub chapter: &'static str,
    /// How many cases it has; fewer were asked if it was left alone, or the run interrupted.
    pub cases: u64,
    /// Cases of each status, in the order of [`Status::ALL`].
    pub counts: [u64; 8],
    /// Of the undecided ones, those whose judge failed: faults of ours.
    pub ours: u64,
    /// Of the wrong ones, those that are no failures by the profile *book*.
    pub fair: u64,
    /// The largest error of a right answer, in u·cond.
    pub worst: f64,
    /// The first wrong answer, with a question made small.
    pub failure: Option<Failure>,
    /// What all wrong answers have in common.
    pub names: Vec<Name>,
    /// Conventions of the book that its answers follow and ours do not, each with the number of answers: they pass.
    pub conventions: Vec<(&'static Mistake, u64)>,
    /// Fields that right answers have left out, each with their number.
    pub lacks: BTreeMap<String, u64>,
    /// Why cases are unsupported, each with their number.
    pub reasons: BTreeMap<String, u64>,
    /// Whether each wrong answer is that of a program whose axes are left-handed.
    pub is_left_handed: bool,
    /// For each other status, the first text and its question.
    pub messages: Vec<(Status, String, Value)>,
    /// What was asked for the first failure.
    pub(super) asked: Vec<(Value, String)>,
}

impl Row {
    pub(super) fn new(name: &str, about: &str, chapter: &'static str, cases: u64) -> Self {
        let (name, about) = (name.to_owned(), about.to_owned());
        Self { name, about, chapter, cases, ..Self::default() }
    }

    pub(super) fn count_convention(&mut self, mistake: &'static Mistake) {
        match self.conventions.iter_mut().find(|(known, _)| *known == mistake) {
            Some((_, count)) => *count += 1,
            None => self.conventions.push((mistake, 1)),
        }
    }

    /// Counts why a case is unsupported; of each reason its beginning, and few of them.
    pub(super) fn count_reason(&mut self, status: Status, text: &str) {
        let reason: String = text.chars().take(LONGEST_REASON).collect();
        let is_room = self.reasons.len() < MOST_REASONS || self.reasons.contains_key(&reason);
        if status == Status::Unsupported && is_room {
            *self.reasons.entry(reason).or_default() += 1;
        }
    }

    /// Cases of this status.
    pub fn count(&self, status: Status) -> u64 {
        self.counts[status as usize]
    }

    /// All cases that were asked.
    pub fn total(&self) -> u64 {
        self.counts.iter().sum()
    }

    /// Cases without a reply that can be read.
    pub fn faults(&self) -> u64 {
        [Status::Hung, Status::Died, Status::Garbled].map(|status| self.count(status)).iter().sum()
    }

    /// Cases that were not asked any more.
    pub fn not_asked(&self) -> u64 {
        self.cases - self.total()
    }

    /// Whether every question was unsupported.
    pub fn is_unsupported(&self) -> bool {
        self.count(Status::Unsupported) == self.total() && self.total() > 0
    }

    /// Whether something is wrong: an answer, a refusal, or a fault.
    pub fn is_failed(&self) -> bool {
        self.count(Status::Wrong) + self.count(Status::Refused) + self.faults() > 0
    }
}

/// What became of a program.
#[derive(Clone, Debug)]
pub struct Card {
    /// How exact answers had to be.
    pub profile: Profile,
    /// Of the cases.
    pub seed: u64,
    /// One for each family, by chapter.
    pub rows: Vec<Row>,
    /// Whether the run was not interrupted.
    pub is_whole: bool,
}

impl Card {
    /// Cases of this status.
    pub fn count(&self, status: Status) -> u64 {
        self.rows.iter().map(|row| row.count(status)).sum()
    }

    /// Whether anything failed.
    pub fn is_failed(&self) -> bool {
        self.rows.iter().any(Row::is_failed)
    }

    /// Whether a judge failed: then a case was not judged, by a fault of ours.
    pub fn is_not_judged(&self) -> bool {
        self.rows.iter().any(|row| row.ours > 0)
    }

    /// The rows of each chapter.
    pub fn chapters(&self) -> BTreeMap<&'static str, Vec<&Row>> {
        let mut chapters: BTreeMap<&'static str, Vec<&Row>> = BTreeMap::new();
        for row in self.rows.iter().filter(|row| row.total() > 0) {
            chapters.entry(row.chapter).or_default().push(row);
        }
        chapters
    }

    /// As JSON.
    pub fn json(&self) -> Value {
        let row = |row: &Row| {
            let counts: BTreeMap<&str, u64> =
                Status::ALL.into_iter().map(|status| (status.name(), row.count(status))).collect();
            let failure = row.failure.as_ref().map(|failure| {
                let asked = failure.asked.iter().map(|(q, a)| json!({"question": q, "answer": a}));
                json!({
                    "question": failure.question,
                    "symptom": failure.wrong.symptom,
                    "expected": failure.wrong.expected,
                    "error": finite(failure.wrong.error),
                    "asked": asked.collect::<Vec<_>>(),
                })
            });
            let messages = row.messages.iter().map(|(status, text, question)| {
                json!({"status": status.name(), "text": text, "question": question})
            });
            json!({
                "family": row.name, "chapter": row.chapter, "about": row.about, "counts": counts,
                "cases": row.cases, "not_asked": row.not_asked(), "judge_failed": row.ours,
                "fair": row.fair, "missing": row.lacks, "worst": row.worst, "failure": failure,
                "names": row.names.iter().map(ToString::to_string).collect::<Vec<_>>(),
                "conventions": row.conventions.iter().map(|(it, count)| {
                    json!({"name": it.words(), "place": it.known().place, "count": count})
                }).collect::<Vec<_>>(),
                "messages": messages.collect::<Vec<_>>(),
            })
        };
        json!({
            "profile": self.profile.name(), "seed": self.seed, "complete": self.is_whole,
            "families": self.rows.iter().map(row).collect::<Vec<_>>(),
        })
    }
}

/// JSON has no infinity.
fn finite(error: f64) -> Value {
    if error.is_finite() { json!(error) } else { Value::Null }
}
