//! The card in words: the verdict in a sentence, what failed, and the counts.

use ask::Invocation;
use std::collections::BTreeMap;
use std::fmt;

use super::super::mistakes::{Mistake, Name};
use super::super::run::{CASES, FEW, MOST_CASES};
use super::{Card, Row, Status};
use groundtruth::printable;
use text::digits::short;
use text::told::Told;

/// The table of chapters: those of which an answer was judged or a fault happened, and only statuses that there are.
fn table(card: &Card) -> String {
    let is_shown = |status: &Status| *status != Status::Unsupported && card.count(*status) > 0;
    let columns: Vec<Status> = Status::ALL.into_iter().filter(is_shown).collect();
    if columns.is_empty() {
        return String::new();
    }
    let names: String = columns.iter().map(|status| format!("{:>11}", status.name())).collect();
    let line = |name: &str, rows: &[&Row]| -> String {
        let count = |status: &Status| rows.iter().map(|row| row.count(*status)).sum::<u64>();
        if columns.iter().all(|status| count(status) == 0) {
            return String::new();
        }
        let shown = |n: u64| if n == 0 { "·".to_owned() } else { n.to_string() };
        let counts = columns.iter().map(|status| format!("{:>11}", shown(count(status))));
        format!("{name:<8}{}\n", counts.collect::<String>())
    };
    let all: Vec<&Row> = card.rows.iter().collect();
    let chapters = card.chapters();
    let lines: String = chapters.iter().map(|(name, rows)| line(name, rows)).collect();
    format!("{:<8}{names}\n{lines}{}", "chapter", line("all", &all))
}

/// Where a family stands on the card: named mistakes first, then wrong answers without a name, then those that are fair in
/// single precision, then refusals and faults.
pub(super) fn order(row: &Row) -> usize {
    let wrong = row.count(Status::Wrong);
    match wrong {
        0 => 3,
        fair if fair == row.fair => 2,
        _ if row.names.is_empty() => 1,
        _ => 0,
    }
}

/// The families that failed or could not be judged, in their order on the card.
pub(super) fn failures(card: &Card) -> Vec<&Row> {
    let mut rows: Vec<&Row> =
        card.rows.iter().filter(|row| row.is_failed() || row.ours > 0).collect();
    rows.sort_by_key(|row| order(row));
    rows
}

/// What failed in a family: with the question, what was expected, what came.
pub(super) fn failed(row: &Row) -> String {
    let mut text = String::new();
    let wrong = row.count(Status::Wrong);
    if wrong > 0 {
        let fair = match row.fair {
            0 => String::new(),
            n if n == wrong => ", all fair in single precision".to_owned(),
            n => format!(", {n} of them fair in single precision"),
        };
        text += &format!("{}: {wrong} of {} wrong{fair}\n", row.name, row.total());
        for name in &row.names {
            text += &format!("  looks like: {name}\n");
        }
    }
    if let Some(failure) = &row.failure {
        for (question, answer) in &failure.asked {
            let answer = printable::text(answer);
            text += &format!("  asked     {question}\n  got       {answer}\n");
        }
        let error = match failure.wrong.error {
            error if error.is_finite() => {
                format!(" ({}: off by {} u·cond)", failure.wrong.symptom, short(error))
            }
            _ => format!(" ({})", failure.wrong.symptom),
        };
        text += &format!("  expected  {}{error}\n", failure.wrong.expected);
    }
    for (status, message, question) in &row.messages {
        if *status == Status::Unsupported {
            continue;
        }
        let count = if *status == Status::Undecided { row.ours } else { row.count(*status) };
        let message = printable::text(message);
        text += &format!(
            "{}: {count} {}: {message}\n  asked     {question}\n",
            row.name,
            status.name()
        );
    }
    if row.faults() > 0 && row.not_asked() > 0 {
        text += &format!(
            "{}: {} of {} cases were not asked after these faults\n",
            row.name,
            row.not_asked(),
            row.cases
        );
    }
    text
}

/// What a family's answers do as the book does and we do not: they pass by the profile *book*.
pub(super) fn conventions(row: &Row) -> String {
    let shown = |(mistake, count): &(&Mistake, u64)| {
        let (name, total) = (&row.name, row.total());
        format!(
            "{name}: {count} of {total} by a convention of the book: {} ({})\n",
            mistake.words(),
            mistake.known().place
        )
    };
    row.conventions.iter().map(shown).collect()
}

/// Fields that a family's right answers have left out.
fn lacking(row: &Row) -> String {
    let shown = |(field, count): (&String, &u64)| {
        format!(
            "{}: `{field}` is missing in {count} of {} answers, which are right in what they have\n",
            row.name,
            row.total()
        )
    };
    row.lacks.iter().map(shown).collect()
}

/// The verdict in one sentence: how many families failed, and the first of them with its mistake.
pub fn verdict(card: &Card, is_fresh: bool) -> String {
    if !card.is_whole {
        return "interrupted: this is what was asked until then".to_owned();
    }
    let (asked, unsupported, failed) = (
        count(card, &|row| row.total() > 0),
        count(card, &Row::is_unsupported),
        count(card, &Row::is_failed),
    );
    let (judged, seed) = (asked - unsupported, card.seed);
    match (failed, is_fresh) {
        _ if judged == 0 => {
            format!("nothing to judge: all {asked} families are unsupported{}", reasons(card))
        }
        (0, _) if card.rows.iter().any(|row| !row.lacks.is_empty()) => {
            format!("none of {judged} families failed, but parts of answers are missing")
        }
        (0, true) => {
            format!("validated: none of {judged} families failed, with the fresh seed {seed}")
        }
        (0, false) => format!(
            "none of {judged} families failed; to validate, use --fresh: the default cases can be learnt"
        ),
        (failed, _) => {
            let first = failures(card).first().map_or(String::new(), |row| first(row));
            format!("{failed} of {judged} families failed (seed {seed}){first}")
        }
    }
}

/// The program's own reasons, the most frequent first.
fn reasons(card: &Card) -> String {
    const SHOWN: usize = 6;
    let mut all: BTreeMap<&str, u64> = BTreeMap::new();
    for (reason, count) in card.rows.iter().flat_map(|row| &row.reasons) {
        *all.entry(reason).or_default() += count;
    }
    let mut all: Vec<(&str, u64)> = all.into_iter().collect();
    all.sort_by_key(|(_, count)| std::cmp::Reverse(*count));
    let shown =
        |(reason, count): &(&str, u64)| format!("\"{}\" ({count})", printable::text(reason));
    let mut parts: Vec<String> = all.iter().take(SHOWN).map(shown).collect();
    if all.len() > SHOWN {
        parts.push(format!("{} others", all.len() - SHOWN));
    }
    if parts.is_empty() {
        String::new()
    } else {
        format!("; the program says: {}", parts.join(", "))
    }
}

fn count(card: &Card, is: &dyn Fn(&Row) -> bool) -> usize {
    card.rows.iter().filter(|row| is(row)).count()
}

/// A family that failed, for the sentence.
fn first(row: &Row) -> String {
    let (name, total) = (&row.name, row.total());
    let (wrong, refused) = (row.count(Status::Wrong), row.count(Status::Refused));
    match (row.names.first(), wrong, refused) {
        (Some(Name::Known { mistake, explains, .. }), ..) => {
            format!(
                "; in {name}, {explains} of {total} answers look like this mistake: {}",
                mistake.words()
            )
        }
        (Some(named), ..) => format!("; in {name}, {wrong} of {total} answers are wrong: {named}"),
        (None, 1.., _) if wrong == row.fair => {
            format!("; in {name}, {wrong} of {total} answers are only as exact as single precision")
        }
        (None, 1.., _) => format!("; in {name}, {wrong} of {total} answers are wrong"),
        (None, 0, 1..) => format!("; in {name}, {refused} of {total} questions were refused"),
        (None, 0, 0) => {
            format!("; {name} got {} answers that cannot be read, or none", row.faults())
        }
    }
}

/// What is told of a card of a program that was asked by this command.
pub fn told(card: &Card, invocation: &Invocation<'_>) -> Told {
    let (details, verdict) = (details(card), verdict(card, invocation.is_fresh));
    Told { verdict, details, next: next(card, invocation) }
}

/// What failed, conventions, counts, and what was not judged.
fn details(card: &Card) -> String {
    failures(card).into_iter().map(failed).collect::<String>()
        + &card.rows.iter().map(conventions).collect::<String>()
        + &table(card)
        + &rest(card)
}

/// What is said below the counts: what is missing, families that were not judged, and which profile fits.
pub(super) fn rest(card: &Card) -> String {
    let wrong = card.count(Status::Wrong);
    let fair: u64 = card.rows.iter().map(|row| row.fair).sum();
    let advice = match 2 * fair > wrong {
        true => format!(
            "{fair} of {wrong} wrong answers are fair in single precision: for such a program, use --profile book\n"
        ),
        false => String::new(),
    };
    let left = left_alone(card, count(card, &Row::is_unsupported));
    let left = if left.is_empty() { left } else { format!("not judged: {left}\n") };
    card.rows.iter().map(lacking).collect::<String>() + &advice + &left
}

/// The next step: the first family that failed, by itself; if it was alone, the scene in which its mistake shows; if none
/// failed, a seed that nobody has seen.
fn next(card: &Card, invocation: &Invocation<'_>) -> String {
    let asked = count(card, &|row| row.total() > 0);
    match failures(card).first() {
        Some(row) if asked > 1 || !row.is_failed() => {
            invocation.of_one("conform", &row.name, card.seed)
        }
        Some(row) => match row.names.first() {
            Some(Name::Known { mistake, .. }) => match (mistake.picture(), mistake.seen_in()) {
                (Some(name), _) => format!("groundtruth mistakes {name}"),
                (None, Some(scene)) => format!("groundtruth describe {scene}"),
                (None, None) => format!("groundtruth mistakes {}", row.chapter),
            },
            _ => format!("groundtruth mistakes {}", row.chapter),
        },
        None if count(card, &Row::is_unsupported) == asked => {
            "groundtruth conform --init python".to_owned()
        }
        None => invocation.with_fresh_seed("conform", CASES, MOST_CASES),
    }
}

/// The families that were not judged, or not to their end.
fn left_alone(card: &Card, unsupported: usize) -> String {
    let mut parts = Vec::new();
    let stopped = match count(card, &|row| row.is_unsupported() && row.not_asked() > 0) {
        0 => String::new(),
        n if n == unsupported => format!(", left alone after {FEW} cases"),
        n => format!(", {n} of them left alone after {FEW} cases"),
    };
    match unsupported {
        0 => {}
        1 => parts.push(format!("1 family is unsupported{stopped}")),
        n => parts.push(format!("{n} families are unsupported{stopped}")),
    }
    let is_open = |row: &Row| row.not_asked() > 0 && !row.is_unsupported();
    let stopped = |row: &Row| !card.is_whole && row.faults() == 0;
    match count(card, &|row| is_open(row) && !stopped(row)) {
        0 => {}
        1 => parts.push("1 was left alone after faults".to_owned()),
        n => parts.push(format!("{n} were left alone after faults")),
    }
    match count(card, &|row| is_open(row) && stopped(row)) {
        0 => {}
        1 => parts.push("1 was not asked to its end before the interruption".to_owned()),
        n => parts.push(format!("{n} were not asked to their end before the interruption")),
    }
    match card.rows.iter().map(|row| row.ours).sum::<u64>() {
        0 => {}
        1 => parts.push("1 case was not judged, by a fault of ours".to_owned()),
        n => parts.push(format!("{n} cases were not judged, by a fault of ours")),
    }
    parts.join("; ")
}

impl fmt::Display for Card {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}", verdict(self, false))?;
        f.write_str(&details(self))
    }
}
