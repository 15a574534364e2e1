//! The card in a terminal.

use std::fmt;

use super::super::mistakes::Mistake;
use super::super::run::FEW;
use super::{Card, Row, Status};
use groundtruth::printable;

/// The line above chapters.
pub fn head() -> String {
    let columns: String =
        Status::ALL.iter().map(|status| format!("{:>12}", status.name())).collect();
    format!("{:<8}{columns}\n", "chapter")
}

/// The line of a chapter.
pub fn line(chapter: &str, rows: &[&Row]) -> String {
    let count = |status: Status| rows.iter().map(|row| row.count(status)).sum::<u64>();
    let shown = |n: u64| if n == 0 { "·".to_owned() } else { n.to_string() };
    let columns: String =
        Status::ALL.iter().map(|status| format!("{:>12}", shown(count(*status)))).collect();
    format!("{chapter:<8}{columns}\n")
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
                format!(" ({}: off by {error:.3e} u·cond)", failure.wrong.symptom)
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

/// The sum of all chapters, and what failed.
pub fn rest(card: &Card) -> String {
    let all: Vec<&Row> = card.rows.iter().collect();
    line("all", &all)
        + &card.rows.iter().map(failed).collect::<String>()
        + &card.rows.iter().map(conventions).collect::<String>()
}

/// What a family's answers do as the book does and we do not: they pass by the profile *book*.
pub(super) fn conventions(row: &Row) -> String {
    let shown = |(mistake, count): &(&Mistake, u64)| {
        let (name, total) = (&row.name, row.total());
        format!(
            "{name}: {count} of {total} by a convention of the book: {} ({})\n",
            mistake.name, mistake.place
        )
    };
    row.conventions.iter().map(shown).collect()
}

/// The last line: how many families failed, of those that were judged; and which were not, and why.
pub fn verdict(card: &Card, is_fresh: bool) -> String {
    if !card.is_whole {
        return "interrupted: this is what was asked until then\n".to_owned();
    }
    let count = |is: &dyn Fn(&Row) -> bool| card.rows.iter().filter(|row| is(row)).count();
    let asked = count(&|row| row.total() > 0);
    let unsupported = count(&Row::is_unsupported);
    let (judged, seed, failed) = (asked - unsupported, card.seed, count(&Row::is_failed));
    let rest = left_alone(card, unsupported);
    let verdict = match (failed, is_fresh) {
        _ if judged == 0 => format!("nothing to judge: all {asked} families are unsupported"),
        (0, true) => {
            format!("validated: none of {judged} families failed, with the fresh seed {seed}{rest}")
        }
        (0, false) => format!(
            "none of {judged} families failed{rest}; to validate, use --fresh: the default cases can be learnt"
        ),
        (failed, _) => format!("{failed} of {judged} families failed (seed {seed}){rest}"),
    };
    let wrong = card.count(Status::Wrong);
    let fair: u64 = card.rows.iter().map(|row| row.fair).sum();
    let advice = match 2 * fair > wrong {
        true => format!(
            "; {fair} of {wrong} wrong answers are fair in single precision: for such a program, use --profile book"
        ),
        false => String::new(),
    };
    format!("{verdict}{advice}\n")
}

/// The families that were not judged, or not to their end.
fn left_alone(card: &Card, unsupported: usize) -> String {
    let count = |is: &dyn Fn(&Row) -> bool| card.rows.iter().filter(|row| is(row)).count();
    let mut text = match unsupported {
        0 => String::new(),
        1 => "; 1 other is unsupported".to_owned(),
        n => format!("; {n} others are unsupported"),
    };
    match count(&|row| row.is_unsupported() && row.not_asked() > 0) {
        0 => {}
        n if n == unsupported => text += &format!(", left alone after {FEW} cases"),
        n => text += &format!(", {n} of them left alone after {FEW} cases"),
    }
    match count(&|row| row.not_asked() > 0 && !row.is_unsupported()) {
        0 => {}
        1 => text += "; 1 was left alone after faults",
        n => text += &format!("; {n} were left alone after faults"),
    }
    match card.rows.iter().map(|row| row.ours).sum::<u64>() {
        0 => {}
        1 => text += "; 1 case was not judged, by a fault of ours",
        n => text += &format!("; {n} cases were not judged, by a fault of ours"),
    }
    text
}

impl fmt::Display for Card {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&head())?;
        for (chapter, rows) in self.chapters() {
            f.write_str(&line(chapter, &rows))?;
        }
        f.write_str(&rest(self))
    }
}
