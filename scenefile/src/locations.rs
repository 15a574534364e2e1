//! Locations in a scene file: the line of a path, and the path at a byte offset.

use std::path::Path;

use groundtruth::invalid::{Invalid, Key};
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::error::{Location, SceneError};
use super::vocabulary::{Choice, Definition};
use super::words::{NEEDS_TABLE, WHOLE_NUMBER, plain_words};
use super::{mismatch, syntax};

/// The line (from 1) of the value at this path. If the text does not contain the value (a default),
/// the line of the innermost table on the path.
pub(super) fn line_of(text: &str, path: &[Key]) -> usize {
    let Some(document) = parse(text) else { return 1 };
    let mut value = &document;
    let mut start = 0;
    for key in path {
        let next = match key {
            Key::Field(name) => value.as_ref().get(name.as_str()),
            Key::Item(index, _) => value.as_ref().get(*index),
        };
        let Some(next) = next else { break };
        value = next;
        start = value.span().start;
    }
    line_at(text, start)
}

fn parse(text: &str) -> Option<Spanned<DeValue<'_>>> {
    let document = DeTable::parse(text).ok()?;
    Some(Spanned::new(document.span(), DeValue::Table(document.into_inner())))
}

/// The line (from 1) of a byte offset.
fn line_at(text: &str, at: usize) -> usize {
    1 + text.as_bytes()[..at.min(text.len())].iter().filter(|&&byte| byte == b'\n').count()
}

/// The error of the TOML parser with the line and the path of the value that caused it.
pub(super) fn parse_error(text: &str, file: &Path, error: &toml::de::Error) -> SceneError {
    let problem = plain_words(error.message());
    let Some(span) = error.span() else {
        return SceneError::Invalid {
            location: Location::file(file),
            invalid: Invalid::new(problem),
        };
    };
    // for a table with a header `[a.b]`, the last key of the header is the table
    let header = text[span.start..].starts_with('[') && problem.starts_with("missing field");
    let end = if header { text[span.start..].find(']').unwrap_or(0) } else { 0 };
    let location = Location::line(file, line_at(text, span.start));
    let Some(document) = parse(text) else {
        if let Some((at, problem)) = syntax::unclosed(text, span.start) {
            let location = Location::line(file, line_at(text, at));
            return SceneError::Invalid { location, invalid: Invalid::new(problem) };
        }
        let name = text.get(span.clone()).filter(|_| problem == "duplicate key");
        let problem = name.map_or(problem.clone(), |name| format!("{problem} `{name}`; keep one"));
        let line = text[..span.start].rfind('\n').map_or(0, |end| end + 1);
        let problem =
            syntax::with_advice(&problem, text[line..].lines().next().unwrap_or_default());
        return SceneError::Invalid { location, invalid: Invalid::new(problem) };
    };
    // an unknown name is where the reader says
    let found = if problem.starts_with("unknown ") { None } else { mismatch::first(&document) };
    if let Some(found) = found {
        return of_mismatch(text, file, found);
    }
    let mut path = path_at(&document, span.start + end);
    if let Some(unknown) = problem.strip_prefix("unknown field `") {
        // a table that nothing knows is named itself, not its first element
        let is_unknown =
            |key: &Key| matches!(key, Key::Field(name) if unknown.starts_with(&format!("{name}`")));
        let last = path.iter().rposition(is_unknown).map_or(path.len(), |index| index + 1);
        path.truncate(last);
    }
    let problem = with_help(&path, problem, string_at(&document, &path));
    SceneError::Invalid { location, invalid: Invalid { path, problem } }
}

/// The error of the first list in place of a table, or table in place of a list.
pub(super) fn mismatch_error(text: &str, file: &Path) -> Option<SceneError> {
    Some(of_mismatch(text, file, mismatch::first(&parse(text)?)?))
}

fn of_mismatch(text: &str, file: &Path, found: mismatch::Mismatch) -> SceneError {
    let mismatch::Mismatch { path, at, problem } = found;
    let location = Location::line(file, line_at(text, at));
    let problem = with_help(&path, problem, None);
    SceneError::Invalid { location, invalid: Invalid { path, problem } }
}

/// The string at a path.
fn string_at<'a>(document: &'a Spanned<DeValue<'_>>, path: &[Key]) -> Option<&'a str> {
    let next = |value: &'a DeValue<'_>, key: &Key| match key {
        Key::Field(name) => Some(value.get(name.as_str())?.as_ref()),
        Key::Item(index, _) => Some(value.get(*index)?.as_ref()),
    };
    path.iter().try_fold(document.as_ref(), next)?.as_str()
}

/// Adds the command that describes the field or kind; replaces the name of a Rust type by an
/// example of a table, and the range of a type by that of the field. `found` is the value, if it is
/// a string.
fn with_help(path: &[Key], problem: String, found: Option<&str>) -> String {
    let definition = Definition::at(path);
    let topic = definition.title().replace(' ', "_");
    let key = path.iter().rev().find_map(|key| match key {
        Key::Field(name) => Some(name.as_str()),
        Key::Item(..) => None,
    });
    let problem = match (problem.split_once("expected struct "), definition.fields().next(), key) {
        (Some((start, _)), Some(field), Some(key)) => {
            format!("{start}expected a table, as `{key} = {{ {} = … }}`", field.name)
        }
        _ => problem,
    };
    let problem = match (problem.contains(WHOLE_NUMBER), key) {
        (true, Some(key)) => with_range(&definition, key, &problem),
        _ => problem,
    };
    let kind = |tag| definition.choices().into_iter().find(|choice| choice.tag == tag);
    let problem = match (found.and_then(kind), key) {
        (Some(kind), Some(key)) if problem == NEEDS_TABLE => as_table(key, &kind),
        _ => problem,
    };
    format!("{problem}; see `groundtruth kinds {topic}` (docs/scene.md)")
}

/// The problem with the range of its field.
fn with_range(definition: &Definition, key: &str, problem: &str) -> String {
    let range = definition.fields().find(|field| field.name == key).and_then(|field| field.range());
    match range {
        Some([least, most]) => {
            let whole_number = format!("expected a whole number from {least} to {most}");
            problem.replace(WHOLE_NUMBER, &whole_number)
        }
        None => problem.to_owned(),
    }
}

/// How a kind is written that was found as a string.
fn as_table(key: &str, kind: &Choice) -> String {
    let field = kind.table().and_then(|table| table.fields().find(|field| field.required));
    let fields = field.map_or(String::new(), |field| format!(" {} = … ", field.name));
    let tag = kind.tag;
    format!("`{tag}` needs a table of fields: write `{key} = {{ {tag} = {{{fields}}} }}`")
}

/// The path of the last key or element that begins at or before this byte offset.
fn path_at(value: &Spanned<DeValue<'_>>, at: usize) -> Vec<Key> {
    let mut last = None;
    let mut path = Vec::new();
    latest((value, 0), at, &mut path, &mut last);
    last.map(|(_, path)| path).unwrap_or_default()
}

fn latest(
    (value, begin): (&Spanned<DeValue<'_>>, usize),
    at: usize,
    path: &mut Vec<Key>,
    last: &mut Option<(usize, Vec<Key>)>,
) {
    let mut visit = |key: Key, start: usize, value: &Spanned<DeValue<'_>>| {
        let start = start.max(begin);
        path.push(key);
        if start <= at && last.as_ref().is_none_or(|(latest, _)| *latest <= start) {
            *last = Some((start, path.clone()));
        }
        latest((value, start), at, path, last);
        path.pop();
    };
    match value.as_ref() {
        DeValue::Table(table) => {
            for (key, value) in table {
                visit(Key::Field(key.as_ref().to_string()), key.span().start, value);
            }
        }
        DeValue::Array(array) => {
            // the numbers of a vector get no path of their own
            let tables = array.iter().enumerate().filter(|(_, value)| value.as_ref().is_table());
            for (index, value) in tables {
                visit(Key::Item(index, name(value.as_ref())), value.span().start, value);
            }
        }
        _ => {}
    }
}

/// The name that a table gives itself.
pub(super) fn name(value: &DeValue<'_>) -> Option<String> {
    value.get("name")?.as_ref().as_str().map(str::to_owned)
}
