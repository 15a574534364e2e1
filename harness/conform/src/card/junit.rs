//! The card for continuous integration: a suite for each chapter, a case for each family.

use quick_junit::{NonSuccessKind, Report, TestCase, TestCaseStatus, TestSuite};

use super::text::failed;
use super::{Card, Row};
use pictures::xml::held;

/// JUnit's XML: wrong and refused answers are failures, faults (of the program, or of a judge) are errors, what is not supported is skipped.
pub fn junit(card: &Card, command: &str) -> String {
    let mut report = Report::new(held(&format!("groundtruth conform -- {command}")));
    for (chapter, rows) in card.chapters() {
        let mut suite = TestSuite::new(held(chapter));
        suite.add_test_cases(rows.into_iter().map(case));
        report.add_test_suite(suite);
    }
    report.to_string().expect("a report of strings can be written")
}

fn case(row: &Row) -> TestCase {
    let status = if row.faults() > 0 || row.ours > 0 {
        TestCaseStatus::non_success(NonSuccessKind::Error)
    } else if row.is_failed() {
        TestCaseStatus::non_success(NonSuccessKind::Failure)
    } else if row.is_unsupported() {
        TestCaseStatus::skipped()
    } else {
        TestCaseStatus::success()
    };
    let mut case = TestCase::new(held(&row.name), status);
    let text = held(&failed(row));
    if !text.is_empty() {
        case.status.set_message(text.lines().next().unwrap_or_default());
        case.status.set_description(text);
    }
    case
}
