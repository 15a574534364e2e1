//! The card: in a terminal, as a page, and for continuous integration.

use ask::{Invocation, JunitResult, Stop};
use std::fmt::{self, Write as _};

use groundtruth::printable;
use serde_json::{Value, json};
use text::digits::shortened;
use text::document::*;
use text::html;
use text::shell::quoted;
use text::told::Told;

use crate::description::Kind;
use crate::laws::{Breach, Law};
use crate::run::{Broken, CASES, ClaimsCard, LawStatus, MOST_CASES, SubjectRow};
use crate::setting::Setting;

/// What is told of a card of a program that was asked by this command.
pub fn told(card: &ClaimsCard, invocation: &Invocation<'_>) -> Told {
    Told { verdict: verdict(card), details: rows(card), next: next(card, invocation) }
}

impl fmt::Display for ClaimsCard {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}\n{}", verdict(self), rows(self))
    }
}

/// The next step: the first that fails, by itself; if it was alone, the question that shows it; if none fails, a seed that
/// nobody has seen, or more cases; after an interruption the same again.
fn next(card: &ClaimsCard, invocation: &Invocation<'_>) -> String {
    let failed = card.rows.iter().find(|row| row.is_failed());
    let question = || failed?.broken().next()?.1.breach.questions.first();
    match (failed, question()) {
        (Some(_), Some(question)) if card.rows.len() == 1 => {
            let mut question = question.clone();
            question["id"] = 1.into();
            format!("echo {} | {}", quoted(&written(&question)), invocation.program())
        }
        (Some(row), _) => invocation.of_one("laws", &glob::Pattern::escape(&row.name), card.seed),
        (None, _) if !card.is_whole => invocation.again("laws", card.seed),
        (None, _) => invocation.with_fresh_seed("laws", CASES, MOST_CASES),
    }
}

/// The rows of all subjects, and what is wrong with each.
fn rows(card: &ClaimsCard) -> String {
    let count =
        |row: &SubjectRow, is: fn(&LawStatus) -> bool| row.laws.iter().filter(|it| is(it)).count();
    let open = |row: &SubjectRow| count(row, |it| matches!(it, LawStatus::Undecided(_)));
    let broken =
        |row: &SubjectRow| row.broken().map(|(law, _)| law.name).collect::<Vec<_>>().join(", ");
    let or_dot = |text: String| if text.is_empty() || text == "0" { "·".to_owned() } else { text };
    let table = table(&card.rows)
        .column(word(&card.rows), |row| shown(row))
        .column("held", |row| count(row, |it| matches!(it, LawStatus::Holds(_))).to_string())
        .column("undecided", |row| or_dot(open(row).to_string()))
        .column("broken", |row| or_dot(broken(row)));
    let details: String = card.rows.iter().map(details).collect();
    format!("\n{}{details}\n", table.element().plain())
}

impl ClaimsCard {
    /// All of it, for programs.
    pub fn json(&self) -> Value {
        let law = |kind: Kind, law: &Law, status: &LawStatus| {
            let mut entry = json!({"law": law.name});
            match status {
                LawStatus::Holds(cases) => {
                    (entry["status"], entry["cases"]) = ("holds".into(), (*cases).into())
                }
                LawStatus::NotClaimed => entry["status"] = "not claimed".into(),
                LawStatus::Undecided(why) => {
                    (entry["status"], entry["why"]) = ("undecided".into(), why.as_str().into())
                }
                LawStatus::Broken(Broken { setting, breach }) => {
                    let Setting { parameters, seen } = setting;
                    let Breach { found, expected, mistake, questions, .. } = breach;
                    entry = json!({
                        "law": law.name, "status": "broken", "sentence": law.sentence, "cause": law.cause,
                        "found": found, "expected": expected, "mistake": mistake, "parameters": parameters,
                        "questions": questions,
                    });
                    if let Some(seen) = seen {
                        entry[kind.seen_from()] = json!(seen);
                    }
                }
            }
            entry
        };
        let row = |row: &SubjectRow| {
            let laws = Law::of(row.kind).iter().zip(&row.laws);
            let laws: Vec<Value> = laws.map(|(it, status)| law(row.kind, it, status)).collect();
            let (kind, trouble) = (row.kind.word(), row.trouble.as_ref().map(Stop::text));
            json!({
                "name": row.name, "kind": kind, "laws": laws, "trouble": trouble,
                "failed": row.is_failed(),
            })
        };
        json!({
            "seed": self.seed, "tests": self.tests, "whole": self.is_whole,
            "subjects": self.rows.iter().map(row).collect::<Vec<_>>(),
        })
    }
}

/// One sentence.
fn verdict(card: &ClaimsCard) -> String {
    let broken: Vec<&SubjectRow> = card.rows.iter().filter(|row| row.is_failed()).collect();
    let seed = card.seed;
    let rest = format!("seed {seed}, {} tests of chance", card.tests);
    let asked = card.rows.iter().filter(|row| row.trouble != Some(Stop::NotAsked)).count();
    let interrupted = match card.is_whole {
        true => String::new(),
        false => format!("interrupted after {asked} of {}; until then ", counted(&card.rows)),
    };
    interrupted
        + &match &broken[..] {
            [] if !card.is_judged() => format!("nothing could be decided ({rest})"),
            [] if !card.is_whole => format!("no law is known to be broken ({rest})"),
            [] => format!("no law is broken by {} ({rest})", counted(&card.rows)),
            [row, ..] => {
                let what = match row.broken().next() {
                    Some((law, broken)) => {
                        let more = broken.breach.mistake.as_deref().unwrap_or(law.sentence);
                        format!("{} breaks \"{}\": {more}", shown(row), law.name)
                    }
                    None => format!("{} does not answer", shown(row)),
                };
                format!("{what} ({} of {} broken; {rest})", broken.len(), counted(&card.rows))
            }
        }
}

/// Its name for a terminal.
fn shown(row: &SubjectRow) -> String {
    printable::name(&row.name)
}

/// A question as JSON without a character that a terminal obeys, to be copied.
fn written(question: &Value) -> String {
    let escaped = |c: char| match printable::is_obeyed(c) {
        true => c.encode_utf16(&mut [0; 2]).iter().map(|unit| format!("\\u{unit:04x}")).collect(),
        false => c.to_string(),
    };
    question.to_string().chars().map(escaped).collect()
}

/// What all of them are: a kind, or subjects of several.
fn word(rows: &[SubjectRow]) -> &'static str {
    let first = rows.first().map_or(Kind::Lobe, |row| row.kind);
    if rows.iter().all(|row| row.kind == first) { first.word() } else { "subject" }
}

fn counted(rows: &[SubjectRow]) -> String {
    format!("{} {}{}", rows.len(), word(rows), if rows.len() == 1 { "" } else { "s" })
}

/// What is wrong with a subject: each broken law, the one to begin with first.
fn details(row: &SubjectRow) -> String {
    let mut text = String::new();
    if let Some(trouble) = row.trouble.as_ref().filter(|it| **it != Stop::NotAsked) {
        let what =
            if row.is_unsupported() { "not supported" } else { "no answer that can be judged" };
        let why = printable::text(trouble.text());
        let _ = writeln!(text, "\n{}: {what}: {why}", shown(row));
    }
    for (law, broken) in row.broken() {
        let Broken { setting: Setting { parameters, seen }, breach } = broken;
        let parameters = shortened(&written(&parameters.clone().into()));
        let seen = seen.map_or(String::new(), |at| format!(", {} = {at:?}", row.kind.seen_from()));
        let seen = shortened(&seen);
        let _ = writeln!(text, "\n{} breaks \"{}\": {}", shown(row), law.name, law.sentence);
        let _ = writeln!(text, "  found       {}", printable::text(&shortened(&breach.found)));
        let _ = writeln!(text, "  expected    {}", printable::text(&shortened(&breach.expected)));
        let _ = writeln!(text, "  parameters  {parameters}{seen}");
        match &breach.mistake {
            Some(mistake) => {
                let _ = writeln!(text, "  mistake     {mistake}");
            }
            None => {
                let _ = writeln!(text, "  usual cause {}", law.cause);
            }
        }
        for question in &breach.questions {
            let _ = writeln!(text, "  question    {}", written(question));
        }
    }
    text
}

/// The page for a program with this command line, of which this is told.
pub fn page(card: &ClaimsCard, told: &Told, command: &str) -> String {
    let details = card.rows.iter().map(details).filter(|it| !it.is_empty());
    let body = several()
        .with_all(Kind::ALL.into_iter().map(|kind| of_kind(card, kind)))
        .with_all(details.map(|details| lines(details.trim())));
    // the page has the details in its own form
    let told = Told { details: String::new(), ..told.clone() };
    told.page(&format!("laws -- {command}"), &[html::LINES, html::CARD], &body.html())
}

/// The table of a kind; nothing if there is none of it.
fn of_kind(card: &ClaimsCard, kind: Kind) -> Element {
    let rows: Vec<&SubjectRow> = card.rows.iter().filter(|row| row.kind == kind).collect();
    if rows.is_empty() {
        return several();
    }
    let mut table = table(rows).column(kind.word(), |row| shown(row));
    for (index, law) in Law::of(kind).iter().enumerate() {
        let heading = element("span").attribute("title", law.sentence).with(law.name);
        table = table.column(heading, |row| match row.laws[index] {
            LawStatus::Holds(_) => several().with("holds"),
            LawStatus::Undecided(_) => span("quiet", "undecided"),
            LawStatus::Broken(_) => span("failed", "broken"),
            LawStatus::NotClaimed => span("quiet", "·"),
        });
    }
    table.element()
}

/// JUnit's XML: a suite for each subject, a case for each law.
pub fn junit(card: &ClaimsCard, command: &str) -> String {
    let case = |(law, status): (&Law, &LawStatus), trouble: Option<&Stop>| {
        let (result, text) = match (status, trouble) {
            (LawStatus::Broken(Broken { breach, .. }), _) => {
                (JunitResult::Failure, format!("{}; expected {}", breach.found, breach.expected))
            }
            (LawStatus::NotClaimed, _) => (JunitResult::Skipped, String::new()),
            (LawStatus::Undecided(_), Some(it @ (Stop::Refused(_) | Stop::Fault(_))))
            | (_, Some(it @ Stop::NotAsked)) => (JunitResult::Error, it.text().to_owned()),
            (LawStatus::Undecided(_), _) => (JunitResult::Skipped, String::new()),
            (LawStatus::Holds(_), _) => (JunitResult::Success, String::new()),
        };
        (law.name.to_owned(), result, text)
    };
    let suite = |row: &SubjectRow| {
        let laws = Law::of(row.kind).iter().zip(&row.laws);
        (shown(row), laws.map(|law| case(law, row.trouble.as_ref())).collect())
    };
    ask::junit(&format!("laws -- {command}"), card.rows.iter().map(suite))
}
