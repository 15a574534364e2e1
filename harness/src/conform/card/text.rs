//! The card in a terminal.

use std::fmt;

use super::super::mistakes::Mistake;
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
        let (count, message) = (row.count(*status), printable::text(message));
        text += &format!(
            "{}: {count} {}: {message}\n  asked     {question}\n",
            row.name,
            status.name()
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

impl fmt::Display for Card {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&head())?;
        for (chapter, rows) in self.chapters() {
            f.write_str(&line(chapter, &rows))?;
        }
        f.write_str(&rest(self))
    }
}
