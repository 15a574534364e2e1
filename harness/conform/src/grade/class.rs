//! The table of a class: a file of comma-separated values (RFC 4180), a line for each student.

use std::collections::BTreeMap;

use groundtruth::printable;

use super::points::Grade;
use super::text::shown;

/// Why a line cannot be added.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ClassError {
    /// Its first line is another one.
    #[error("its first line is not that of this assignment, `{0}`; write to another file")]
    Another(String),
}

/// The text of a class with this student's line, which replaces one of the same name; lines are sorted by name.
///
/// # Errors
/// [`ClassError`] if the text is of another assignment.
pub fn with_row(text: &str, student: &str, grade: &Grade) -> Result<String, ClassError> {
    let student = printable::name(student);
    let head = head(grade);
    let mut lines = text.lines();
    if lines.next().is_some_and(|found| found != head) {
        return Err(ClassError::Another(head));
    }
    let mut rows: BTreeMap<&str, String> = BTreeMap::new();
    for line in lines.filter(|line| !line.is_empty()) {
        rows.insert(first_field(line), line.to_owned());
    }
    let name = quoted(&student);
    rows.insert(&name, row(&name, grade));
    let rows = rows.into_values().map(|row| row + "\n");
    Ok(head + "\n" + &rows.collect::<String>())
}

fn head(grade: &Grade) -> String {
    let parts = grade.parts.iter().map(|part| part.name.as_str());
    let ends = ["families wrong", "families unsupported", "note"];
    let all = ["student", "total"].into_iter().chain(parts).chain(ends);
    all.map(quoted).collect::<Vec<_>>().join(",")
}

fn row(name: &str, grade: &Grade) -> String {
    let count = |of: fn(&_) -> usize| grade.parts.iter().map(of).sum::<usize>().to_string();
    let note = match &grade.card {
        Ok(_) => String::new(),
        Err(error) => {
            let first = error.0.first().map_or("", String::as_str);
            format!("answered no question: {}", printable::name(first))
        }
    };
    let mut fields = vec![name.to_owned(), shown(grade.points())];
    fields.extend(grade.parts.iter().map(|part| shown(part.points)));
    fields.extend([count(|part| part.failed()), count(|part| part.unsupported()), quoted(&note)]);
    fields.join(",")
}

/// A field, in quotes if it has to be.
fn quoted(field: &str) -> String {
    match field.contains([',', '"', '\n', '\r']) {
        true => format!("\"{}\"", field.replace('"', "\"\"")),
        false => field.to_owned(),
    }
}

/// The first field of a line, as it stands there.
fn first_field(line: &str) -> &str {
    let mut is_quoted = false;
    let end = line.find(|c| {
        is_quoted ^= c == '"';
        c == ',' && !is_quoted
    });
    &line[..end.unwrap_or(line.len())]
}
