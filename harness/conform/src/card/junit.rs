//! The card for continuous integration: a suite for each chapter, a case for each family.

use ask::JunitResult;

use super::text::failed;
use super::{Card, Row};

/// JUnit's XML: wrong and refused answers are failures, faults (of the program, or of a judge) are errors, what is not supported is skipped.
pub fn junit(card: &Card, command: &str) -> String {
    let case = |row: &Row| (row.name.clone(), result(row), failed(row));
    let suite = |(chapter, rows): (&str, Vec<&Row>)| {
        (chapter.to_owned(), rows.into_iter().map(case).collect())
    };
    ask::junit(&format!("conform -- {command}"), card.chapters().into_iter().map(suite))
}

fn result(row: &Row) -> JunitResult {
    match () {
        () if row.faults() > 0 || row.ours > 0 => JunitResult::Error,
        () if row.is_failed() => JunitResult::Failure,
        () if row.is_unsupported() => JunitResult::Skipped,
        () => JunitResult::Success,
    }
}
