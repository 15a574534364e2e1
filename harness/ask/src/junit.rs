//! Cards for continuous integration.

use quick_junit::{NonSuccessKind, Report, TestCase, TestCaseStatus, TestSuite};
use text::xml::held;

/// What became of a case.
pub enum Result {
    /// Nothing is wrong.
    Success,
    /// It was not judged.
    Skipped,
    /// Something is wrong.
    Failure,
    /// There is no answer, or it could not be judged.
    Error,
}

/// A case: its name, what became of it, and the text about it, of which the first line is the message.
pub type JunitCase = (String, Result, String);

/// JUnit's XML of a command: its suites by name.
pub fn junit(command: &str, suites: impl IntoIterator<Item = (String, Vec<JunitCase>)>) -> String {
    let mut report = Report::new(held(&format!("groundtruth {command}")));
    for (name, cases) in suites {
        let mut suite = TestSuite::new(held(&name));
        suite.add_test_cases(cases.into_iter().map(case));
        report.add_test_suite(suite);
    }
    report.to_string().expect("a report of strings can be written")
}

fn case((name, result, text): JunitCase) -> TestCase {
    let mut status = match result {
        Result::Success => TestCaseStatus::success(),
        Result::Skipped => TestCaseStatus::skipped(),
        Result::Failure => TestCaseStatus::non_success(NonSuccessKind::Failure),
        Result::Error => TestCaseStatus::non_success(NonSuccessKind::Error),
    };
    let text = held(&text);
    if let Some(line) = text.lines().next() {
        status.set_message(line);
    }
    if text.contains('\n') {
        status.set_description(text);
    }
    TestCase::new(held(&name), status)
}
